# Outputs appear whole or not at all: sets that exist survive failures, what a user put there is not
# touched, places that cannot be written are errors.
. "$(dirname "$0")/lib.sh"

"$scree" sample fractal --size 64 -o pair --quiet || fail "scree sample fractal"
height=pair/fractal.height.exr
bake=("$scree" bake --height $height --quiet)
printf 'no image\n' > bad.exr

# --- an existing set -------------------------------------------------------------------------------
expect_success "the first bake" -- "${bake[@]}" -o set
first=$(fingerprint set)
# survives NAME ARGUMENTS...: a bake into ./set that fails changes nothing in it.
survives()
{
    local name=$1
    shift
    expect_error "$name" '' -- "$scree" bake -o set "$@"
    expect_equal "the set after: $name" "$(fingerprint set)" "$first"
}
survives "bad height" --height bad.exr
survives "bad color" --height $height --color bad.exr
survives "no such height" --height gone.exr
survives "bad maps" --height $height --maps color
head -c 9000 $height > cut.exr
survives "cut height" --height cut.exr
survives "half overflow" --height $height --height-scale 1e30 --pixel-type half
head -c 9000 pair/fractal.color.exr > cut_color.exr
survives "cut color" --height $height --color cut_color.exr
expect_failure 2 "bad option" '' -- "${bake[@]}" -o set --wrap x
expect_equal "the set after a bad option" "$(fingerprint set)" "$first"

expect_success "the same bake again" -- "${bake[@]}" -o set
expect_equal "the same bake again" "$(fingerprint set)" "$first"
expect_success "another bake" -- "${bake[@]}" -o set --height-scale 2 --maps slope --name other
expect_equal "files after another bake" "$(ls -A set | tr '\n' ' ')" \
    'other.scree.json other.slope.exr '
expect_success "a set baked from one of its own files" -- "$scree" bake --quiet -o set \
    --height set/other.slope.exr --height-channel s
expect_equal "files after that" "$(ls set | head -n 1)" 'other.slope.height.exr'

# --- what is not a set -----------------------------------------------------------------------------
mkdir photos mixed empty
printf 'dear diary\n' > photos/diary.txt
kept=$(fingerprint photos)
expect_error "a folder of other files" 'photos: .*-o' -- "${bake[@]}" -o photos
expect_equal "the folder of other files" "$(fingerprint photos)" "$kept"
expect_success "a set to mix" -- "${bake[@]}" -o mixed
printf 'dear diary\n' > mixed/diary.txt
kept=$(fingerprint mixed)
expect_error "a set with another file in it" "mixed: .*'diary\.txt'.*-o" -- "${bake[@]}" -o mixed
expect_equal "the set with another file" "$(fingerprint mixed)" "$kept"
rm mixed/diary.txt
mkdir mixed/album
expect_error "a set with a folder in it" "mixed: .*'album'" -- "${bake[@]}" -o mixed
rmdir mixed/album
printf '{' > mixed/fractal.height.scree.json
expect_error "a set whose manifest is damaged" 'mixed: ' -- "${bake[@]}" -o mixed
expect_error "a file for a folder" 'bad\.exr: exists and is not a folder' -- "${bake[@]}" -o bad.exr
expect_error "the folder of the inputs" 'pair: ' -- "${bake[@]}" -o pair
expect_success "an empty folder" -- "${bake[@]}" -o empty
expect_equal "the empty folder holds a set" "$(ls empty | wc -l)" 4

# --- ways to write a folder's name -----------------------------------------------------------------
mkdir -p here/deep
for place in bare slash/ ./dotted new/parents/set here/deep/../beside "with space" "$work/absolute"; do
    expect_success "-o $place" -- "${bake[@]}" -o "$place"
    expect_success "-o $place, again" -- "${bake[@]}" -o "$place"
    [ -f "$place/fractal.height.scree.json" ] || fail "-o $place: no set there"
done
expect_success "-o here/empty/." -- bash -c 'mkdir here/empty; exec "$@"' - "${bake[@]}" -o here/empty/.
expect_success "-o link to a set" -- bash -c 'ln -s bare link; exec "$@"' - "${bake[@]}" -o link --name via
[ -L link ] && [ -f bare/via.scree.json ] || fail "-o link: expected a new set behind the link"
expect_error "-o /" '^scree: error: /: ' -- "${bake[@]}" -o /
expect_usage_error "-o with no name" '-o' -- "${bake[@]}" -o ''

# A bake that fails makes no parents either.
expect_error "bad input, new parents" 'bad\.exr' -- "$scree" bake --height bad.exr -o young/set
[ ! -e young ] || fail "bad input: made the folder young"
expect_error "cut input, new parents" 'cut\.exr' -- "$scree" bake --height cut.exr -o young/set
[ ! -e young ] || fail "cut input: made the folder young"

# --- places that cannot be written -----------------------------------------------------------------
expect_error "below a file" 'bad\.exr/set: ' -- "${bake[@]}" -o bad.exr/set
expect_error "below a file, deep" 'bad\.exr/a/set: ' -- "${bake[@]}" -o bad.exr/a/set
expect_error "/proc" '/proc/scree_set: ' -- "${bake[@]}" -o /proc/scree_set
expect_error "a name too long" 'cannot' -- "${bake[@]}" -o "$(printf 'x%.0s' {1..300})"
expect_error "sample below a file" 'bad\.exr' -- "$scree" sample sine --size 8 -o bad.exr/pair
mkdir sealed
chmod 555 sealed
if [ "$(id -u)" -ne 0 ]; then
    expect_error "a folder without permission" 'sealed/set: ' -- "${bake[@]}" -o sealed/set
    cp $height secret.exr
    chmod 000 secret.exr
    expect_error "an input without permission" 'secret\.exr: ' -- "$scree" bake --height secret.exr \
        -o out
    expect_error "a page in it" 'sealed/page\.html: .*takes no files: Permission' -- \
        "$scree" validate set --report sealed/page.html
elif command -v setpriv > /dev/null; then
    # Root may do everything: as nobody, then.
    chmod 755 . && chmod -R a+rX pair
    cp $height secret.exr
    chmod 000 secret.exr
    as_nobody=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    if "${as_nobody[@]}" "$scree" --version > /dev/null 2>&1; then
        expect_error "a folder without permission" 'sealed/set: ' -- \
            "${as_nobody[@]}" "${bake[@]}" -o sealed/set
        expect_error "an input without permission" 'secret\.exr: .*[Pp]ermission' -- \
            "${as_nobody[@]}" "$scree" bake --height secret.exr -o sealed/set
        expect_error "a page in it" 'sealed/page\.html: .*takes no files: Permission' -- \
            "${as_nobody[@]}" "$scree" validate set --report sealed/page.html
    else
        skip_part "permissions: nobody cannot run $scree"
    fi
else
    skip_part "permissions: root may do everything, and there is no setpriv"
fi

# --- no room ---------------------------------------------------------------------------------------
for compression in none zip piz; do
    expect_error "file size limit, $compression" 'fractal.*room on the disk' -- \
        bash -c 'ulimit -f 8; exec "$@"' - "${bake[@]}" --compression $compression -o set
done
expect_error "file size limit, sample" 'cannot be written' -- \
    bash -c 'ulimit -f 8; exec "$@"' - "$scree" sample fractal --size 128 -o small_pair
mkdir small
if [ "$(id -u)" -eq 0 ] && mount -t tmpfs -o size=128k none small 2> /dev/null; then
    on_exit+=("umount '$work/small'")
    expect_success "a small disk, a small set" -- "${bake[@]}" --maps slope \
        -o small/set
    kept=$(fingerprint small)
    for compression in none zip; do
        expect_error "full disk, $compression" 'room on the disk' -- \
            "${bake[@]}" --compression $compression -o small/set --pixel-type float
        expect_equal "the set on the full disk" "$(fingerprint small)" "$kept"
    done
    # Almost full: what fails last is the manifest, or closing a file.
    dd if=/dev/zero of=small/filler bs=1k status=none 2> /dev/null
    for spare in 0 4096 8192 16384 32768; do
        truncate -s "-$spare" small/filler
        kept=$(fingerprint small)
        run "${bake[@]}" -o small/other
        case $status in
        0) rm -r small/other ;;
        1) expect_equal "a disk with $spare bytes more" "$(fingerprint small)" "$kept" ;;
        *) fail "a disk with $spare bytes more: exit status $status: $(said)" ;;
        esac
    done
    expect_error "full disk, sample" 'cannot be written' -- \
        "$scree" sample fractal --size 256 -o small/pair
    mount -o remount,ro "$work/small"
    expect_error "read-only disk" 'small/set: .*[Rr]ead-only' -- "${bake[@]}" -o small/set
    expect_error "a page on it" 'small/page\.html: .*[Rr]ead-only' -- \
        "$scree" validate set --report small/page.html
else
    skip_part "full and read-only disk: mounting one needs root"
fi

finish
