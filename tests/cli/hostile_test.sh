# Every damaged or odd file of the collection, as a height map and as a color map: whatever it is, a
# bake of it ends by itself, with a set or with one error line, in little time and memory.
. "$(dirname "$0")/lib.sh"
need timeout

data=$repo/../shared/data
[ -d "$data/badinput" ] || skip_all "no folder $data/badinput beside the repository"

pfm plane.pfm 4 4 "$one"

# Damaged files are small and fail at once; a sound one of 24 million pixels takes its time.
seconds=20

# bake_in_limits FILE ARGUMENTS...: exit 0 or 1 with what belongs to it.
bake_in_limits()
{
    local file=$1 lines left
    shift
    checks=$((checks + 1))
    # 6 GiB of address space; no core files.
    (
        ulimit -v 6291456
        ulimit -c 0
        exec timeout -k 5 "$seconds" "$scree" bake "$@" -o out --quiet
    ) > stdout 2> stderr < /dev/null
    status=$?
    lines=$(grep -c '^scree: error: ' stderr)
    left=$(staging)
    case $status in
    0) [ -e out ] && [ "$lines" -eq 0 ] || fail "$file: exit 0, but $(said)" ;;
    1)
        [ "$lines" -eq 1 ] || fail "$file: exit 1 with $lines error lines: $(said)"
        [ ! -e out ] || fail "$file: left the output folder behind"
        ;;
    124 | 137) fail "$file: ran longer than $seconds s" ;;
    *) fail "$file: expected exit 0 or 1, got $status: $(said)" ;;
    esac
    [ -z "$left" ] || fail "$file: left behind: $left"
    rm -rf out $left
}

files=0
while IFS= read -r -d '' file; do
    files=$((files + 1))
    short=${file#"$data"/}
    [[ $short != corner/* ]] || seconds=90
    input=$file
    case $file in
    *.*) ;;
    *) # OpenEXR's collection has no suffixes.
        input=$work/nameless.exr
        cp "$file" "$input"
        ;;
    esac
    bake_in_limits "$short as heights" --height "$input" --height-channel 0
    bake_in_limits "$short as color" --height plane.pfm --color "$input" --resample
done < <(find "$data"/badinput/{openexr,openimageio,png,tiff} "$data/corner" -type f -print0 |
    sort -z)
[ "$files" -gt 0 ] || fail "no files below $data"

finish
