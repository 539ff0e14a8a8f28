# scree info: what it prints of a set, and what it says of folders and manifests that are none.
# --quiet: nothing at all.
. "$(dirname "$0")/lib.sh"

"$scree" sample fractal --size 48 -o pair --quiet || fail "scree sample fractal"
expect_success "a quiet bake" -- "$scree" bake pair/fractal.toml -o set --quiet
expect_equal "--quiet" "$(cat stdout stderr)" ""
expect_success "a quiet bake that has warnings" -- "$scree" bake --height pair/fractal.height.exr \
    --height-scale 1000 -o steep --quiet
expect_equal "--quiet with warnings" "$(cat stdout stderr)" ""
expect_success "a quiet sample" -- "$scree" sample sine --size 16 -o wave --quiet
expect_equal "--quiet of sample" "$(cat stdout stderr)" ""
expect_success "a loud bake" -- "$scree" bake --height pair/fractal.height.exr --height-scale 1000 \
    -o steep
expect_warning "a steep bake" 'rms slope.*--texel-size.*--world-size'

expect_success "info of a folder" -- "$scree" info set
for words in fractal 48x48 slope colorheight kurtosis 24x24 1x1; do
    grep -q "$words" stdout || fail "info: expected '$words' in: $(cat stdout)"
done
expect_success "info of a manifest" -- "$scree" info set/fractal.scree.json
expect_success "info of a folder with a slash" -- "$scree" info set/
expect_success "info --json" -- "$scree" info set --json
cmp -s stdout set/fractal.scree.json || fail "info --json: differs from the manifest"
expect_success "info of a steep set" -- "$scree" info steep
grep -q 'rms slope' stdout || fail "info: expected the warning of the bake in: $(cat stdout)"

expect_usage_error "info of nothing" 'set' -- "$scree" info
expect_success "a bake with tables" -- "$scree" bake pair/fractal.toml -o seen --quiet \
    --visibility tables --nodes 60,80 --axes 15
expect_success "info of tables" -- "$scree" info seen
grep -q 'visibility from 8 azimuths at 60, 80 degrees from the normal, along axes at 15 and 105' stdout ||
    fail "info: expected nodes and axes in: $(cat stdout)"

expect_error "no such set" 'gone: no such' -- "$scree" info gone
expect_error "a folder without a set" 'pair: no texture set here' -- "$scree" info pair
expect_error "a texture" 'fractal\.slope\.exr: not a Scree manifest; name the folder' -- "$scree" info set/fractal.slope.exr
expect_error "an empty file" 'empty: ' -- bash -c ': > empty; exec "$@"' - "$scree" info empty

# damaged NAME PATTERN SED...: a manifest changed by sed is an error that names it.
damaged()
{
    local name=$1 pattern=$2
    shift 2
    rm -rf bad
    cp -r set bad
    sed -i "$@" bad/fractal.scree.json
    ! cmp -s set/fractal.scree.json bad/fractal.scree.json || fail "$name: sed changed nothing"
    expect_error "$name" "bad/fractal\.scree\.json: $pattern" -- "$scree" info bad
}
damaged "cut manifest" 'damaged manifest: cut short, .*line 20 on; bake the set again' '20,$d'
damaged "no JSON" 'damaged manifest: cut short, or no JSON from line 2 on; bake' '2s/:/;/'
damaged "a later version" 'format version 99.*newer scree' 's/"format_version": [0-9]*/"format_version": 99/'
damaged "another format" 'not a Scree manifest; name the folder' 's/"scree texture set"/"other"/'
damaged "no version" 'damaged' '/"format_version"/d'
damaged "no width" "damaged manifest: 'width' is missing; bake the set again" 's/^  "width"/  "breadth"/'
damaged "text for a number" "damaged manifest: 'width' is text, expected a whole number; bake" 's/^  "width": [0-9]*/  "width": "wide"/'
damaged "unknown map" "damaged manifest: holds a map 'slope2', which this version does not know" 's/"map": "slope"/"map": "slope2"/'
damaged "no levels" 'damaged' 's/^  "levels"/  "stories"/'
damaged "warnings of no list" "damaged manifest: 'warnings' is a number, expected a list of text" 's/^  "warnings": .*/  "warnings": 3/'
: > bad/fractal.scree.json
expect_error "empty manifest" 'bad/fractal\.scree\.json: damaged manifest: the file is empty' -- "$scree" info bad
cp set/fractal.scree.json bad/fractal.scree.json
cp set/fractal.scree.json bad/second.scree.json
expect_error "two manifests" 'bad: 2 manifests' -- "$scree" info bad

# --- nowhere to print to ---
# unprinted NAME COMMAND...: what the command prints does not arrive, which is an error.
unprinted()
{
    local name=$1
    shift
    expect_error "$name" '^scree: error: standard output: cannot be written: .*; send it elsewhere$' \
        -- bash -c '"$@" > /dev/full' - "$@"
}
unprinted "info, no room" "$scree" info set
unprinted "info --json, no room" "$scree" info --json set
unprinted "help, no room" "$scree" bake --help
unprinted "version, no room" "$scree" --version
unprinted "bake, no room for its summary" "$scree" bake pair/fractal.toml -o whole
[ -e whole/fractal.scree.json ] || fail "bake, no room for its summary: no set"
expect_error "no standard output" 'standard output: cannot be written' -- \
    bash -c '"$@" >&-' - "$scree" info set
expect_success "nothing to print" -- bash -c '"$@" > /dev/full' - \
    "$scree" bake pair/fractal.toml -o whole --quiet

finish
