#!/usr/bin/env bash
# scree validate: agreement on what was baked, exit 1 on what was not, errors that say what to do.
. "$(dirname "$0")/lib.sh"
need python3 oiiotool

# few footprints and samples: agreement of the views is the unit tests' business
quick=(--footprints 3 --samples 4)

mkdir art
"$scree" sample bricks --size 128 -o art --quiet
expect_success "bake" -- "$scree" bake art/bricks.toml -o bricks.set --quiet

# --- what it says ---
expect_success "a set beside its inputs' folder" -- "$scree" validate bricks.set --inputs art "${quick[@]}"
grep -q '^slope ' stdout || fail "no table of statistics: $(cat stdout)"
grep -q 'million samples a second' stdout || fail "no speed of the reference: $(cat stdout)"

expect_success "JSON and page" -- "$scree" validate bricks.set --inputs art "${quick[@]}" \
    --json all.json --report page.html --quiet
expect_equal "nothing said with --quiet" "$(cat stdout stderr)" ""
checks=$((checks + 1))
python3 - <<'P' || fail "the JSON is not as documented"
import json
found = json.load(open("all.json"))
assert found["valid"] is True and found["exceeded"] == []
levels = {(f["texture"], f["level"]) for f in found["statistics"]}
for texture in ("slope", "height", "color", "colorheight", "colorslope", "rank", "tail"):
    for level in range(8):
        assert (texture, level) in levels, (texture, level)
assert all(f["largest_error"] <= f["tolerance"] for f in found["statistics"])
angles = [v["angle_deg"] for v in found["views"]["all_levels"]]
assert angles == [0, 30, 60, 75, 85, "all"], angles
assert len(found["views"]["levels"]) == 5 * 8
assert "by height rank" in found["views"]["all_levels"][0]["color_by_model"]
P
checks=$((checks + 1))
python3 - <<'P' || fail "the page is not self-contained"
import re
page = open("page.html").read()
for link in re.findall(r'(?:src|href)\s*=\s*"([^"]*)"', page):
    assert link.startswith(("data:", "#")), link
assert page.count("data:image/png;base64,") == 8 and "<svg" in page and "<script" not in page
P
run "$scree" validate bricks.set --inputs art --statistics-only --json -
python3 -c 'import json
found = json.load(open("stdout"))
assert "views" not in found and found["views_not_compared"] == "only the statistics were asked for"' ||
    fail "--statistics-only: $(head -c 300 stdout)"

# equal seeds, equal figures, whatever the threads
for threads in 1 2; do
    "$scree" validate bricks.set --inputs art "${quick[@]}" --threads $threads --json - |
        grep -v '"seconds"' > "by$threads.json"
done
expect_equal "figures by 1 and 2 threads" "$(cmp by1.json by2.json 2>&1)" ""

# --- tolerances ---
expect_error "color tolerance" 'bricks.set: out of tolerance: visible color at [0-9]+ degrees' -- \
    "$scree" validate bricks.set --inputs art "${quick[@]}" --color-tolerance 1e-6
expect_success "a wide tolerance" -- \
    "$scree" validate bricks.set --inputs art "${quick[@]}" --color-tolerance 10 --radiance-tolerance 10
{ cat art/bricks.toml; printf '[validate]\nradiance-tolerance = 1e-6\nfootprints = 3\nsamples = 4\n'; } > art/strict.toml
expect_success "bake by a recipe with a table for validate" -- "$scree" bake art/strict.toml -o strict.set --quiet
expect_error "tolerance of a recipe" 'out of tolerance: radiance' -- \
    "$scree" validate strict.set --recipe art/strict.toml --inputs art
expect_success "the command line wins" -- \
    "$scree" validate strict.set --recipe art/strict.toml --inputs art --radiance-tolerance 10
expect_usage_error "recipe without the table" 'no table \[validate\]' -- \
    "$scree" validate bricks.set --recipe art/bricks.toml --inputs art
printf '[validate]\ncolour-tolerance = 1\n' > typo.toml
expect_usage_error "unknown key" "typo.toml:2: there is no option 'colour-tolerance'" -- \
    "$scree" validate bricks.set --recipe typo.toml --inputs art

# --- sets that are wrong ---
cp -r bricks.set wrong.set
oiiotool art/bricks.color.exr --mulc 1.01 -o brighter.exr
"$scree" bake art/bricks.toml --color brighter.exr -o brighter.set --quiet
cp brighter.set/bricks.color.exr wrong.set/
expect_error "another color texture" 'mean color of level 0: error .* at texel' -- \
    "$scree" validate wrong.set --inputs art --statistics-only
truncate -s 20000 wrong.set/bricks.color.exr
expect_error "a cut texture" 'bricks.color.exr' -- "$scree" validate wrong.set --inputs art --statistics-only
rm wrong.set/bricks.slope.exr
expect_error "a missing texture" 'bricks.slope.exr' -- "$scree" validate wrong.set --inputs art
expect_error "no set" 'art' -- "$scree" validate art

# --- inputs ---
mkdir changed && cp art/bricks.*.exr changed
oiiotool art/bricks.height.exr --mulc 2 -o changed/bricks.height.exr
expect_error "a changed input" 'bricks.height.exr: is not the file the set was baked from' -- \
    "$scree" validate bricks.set --inputs changed
expect_error "a missing input" 'bricks.height.exr: .*--inputs' -- "$scree" validate bricks.set
expect_error "no such folder" 'nowhere: is no folder' -- "$scree" validate bricks.set --inputs nowhere
cp art/bricks.*.exr .
expect_success "inputs in the current folder" -- "$scree" validate bricks.set --statistics-only --quiet
rm bricks.*.exr

# --- places that cannot be written ---
# Found before the work: before the inputs, which are not here.
expect_error "no folder for the page" 'nowhere/page.html: cannot be written: there is no folder nowhere' -- \
    "$scree" validate bricks.set --report nowhere/page.html
expect_error "no folder for the JSON" 'art/bricks.toml/all.json: cannot be written: .*no folder' -- \
    "$scree" validate bricks.set --json art/bricks.toml/all.json
expect_error "a folder for the page" 'art: cannot be written: is a folder' -- \
    "$scree" validate bricks.set --report art
ln -s nowhere/page.html lost.html
expect_error "a link to no folder" 'lost.html: cannot be written: there is no folder nowhere' -- \
    "$scree" validate bricks.set --report lost.html

ln -s real.html link.html
expect_success "a link to the page" -- "$scree" validate bricks.set --inputs art --statistics-only \
    --report link.html --quiet
[ -L link.html ] && [ -f real.html ] || fail "the link was replaced: $(ls -l link.html)"
mkfifo pipe.json
expect_error "a pipe" 'pipe.json: cannot be written: is a device or a pipe' -- \
    "$scree" validate bricks.set --json pipe.json
[ -p pipe.json ] || fail "the pipe was replaced"

# --- comparing nothing is no success ---
expect_error "views with a tolerance, not compared" 'was not compared: only the statistics' -- \
    "$scree" validate bricks.set --inputs art --statistics-only --radiance-tolerance 1

# --- other kinds of sets ---
kind() { # NAME OPTIONS...: bakes with them, validates
    local name=$1
    shift
    rm -rf kind.set
    expect_success "bake $name" -- "$scree" bake -o kind.set --quiet --texel-size 0.05 "$@"
    expect_success "validate $name" -- "$scree" validate kind.set --inputs art "${quick[@]}"
}
heights=(--height art/bricks.height.exr)
both=("${heights[@]}" --color art/bricks.color.exr)
kind "heights alone" "${heights[@]}"
kind "half floats" "${both[@]}" --pixel-type half
kind "clamped, Sobel" "${both[@]}" --wrap clamp --reconstruction sobel
kind "mirrored and black, central" "${both[@]}" --wrap mirror black --reconstruction central
kind "the layout of maketx" "${heights[@]}" --layout bumpslopes
kind "colors alone" "${both[@]}" --maps color
kind "slopes alone" "${both[@]}" --maps slope
kind "some of the maps" "${both[@]}" --maps slope,color,rank --rank-terms 2
kind "chosen maps" "${both[@]}" --maps auto
oiiotool art/bricks.height.exr --cut 97x51 -o art/odd.exr
oiiotool art/bricks.color.exr --cut 97x51 -o art/odd.color.exr
kind "odd sizes" --height art/odd.exr --color art/odd.color.exr --rank-terms 8
oiiotool art/odd.exr --box:color=nan:fill=1 20,20,30,40 -o art/holes.exr
kind "holes" --height art/holes.exr --color art/odd.color.exr
oiiotool --pattern constant:color=0.4,0.6,0.8 64x64 3 --noise:type=uniform:min=-0.2:max=0.2 -o art/normal.exr
kind "a normal map" --height art/normal.exr --input normal --normal-range unsigned
expect_error "a normal map with a tolerance of views" 'was not compared: a normal map has no heights' -- \
    "$scree" validate kind.set --inputs art --color-tolerance 1
expect_success "validate a normal map again" -- "$scree" validate kind.set --inputs art
grep -q 'has no heights' stdout || fail "a normal map: does not say why no views: $(cat stdout)"
kind "heights of the wrong scale" "${heights[@]}" --height-scale 1e6
grep -Eq 'not compared: heights range over .*--height-scale' stdout ||
    fail "heights of the wrong scale: does not say why no views: $(cat stdout)"
expect_error "heights of the wrong scale with a tolerance of views" 'was not compared: heights range' -- \
    "$scree" validate kind.set --inputs art --color-tolerance 1
kind "the same, clamped" "${heights[@]}" --height-scale 1e6 --wrap clamp
grep -q 'not compared' stdout && fail "the same, clamped: views were not compared: $(cat stdout)"
cat > art/map.cpt <<'C'
-1 20 40 90 0 90 160 60
0 90 160 60 1 250 250 250
C
kind "a color map by height" "${heights[@]}" --colormap art/map.cpt
oiiotool kind.set/bricks.height.map.exr --mulc nan -o kind.set/bricks.height.map.exr
expect_error "a color map's table without numbers" 'has colors that are no numbers' -- \
    "$scree" validate kind.set --inputs art "${quick[@]}" --color-tolerance 10
kind "a color map by slope" "${heights[@]}" --colormap art/map.cpt --map-by slope --map-range 0 2
kind "a color map along a slope" "${heights[@]}" --colormap art/map.cpt --map-by slope --map-azimuth 90 --map-range -1 1

# --- usage ---
expect_usage_error "an angle of 90" 'view-angles' -- "$scree" validate bricks.set --view-angles 0,90
expect_usage_error "an angle that is none" 'view-angles' -- "$scree" validate bricks.set --view-angles nan
for angle in 180 90 -1 nan; do
    expect_usage_error "a light at $angle" '--light: expected a number from 0 to 89' -- \
        "$scree" validate bricks.set --light $angle 0
done
expect_usage_error "no set named" 'set' -- "$scree" validate

finish
