#!/usr/bin/env bash
# Times `scree bake` of a set of tiles against bakes of the same maps one after another, in turn.
#
#   run_udim_bench.sh BUILD_DIR [SIZE] [TILES] [RUNS]
#
#   BUILD_DIR  a release build
#   SIZE       of a tile, texels a side (default 2048)
#   TILES      how many, 1 to 10 (default 6)
#   RUNS       counted runs, after one that is not (default 3)
#
# All maps of heights and a color from 16-bit PNG files, whose decoding cannot be shared among threads; halves,
# zip. "tiles" is the set, "meeting" the same with --udim-wrap, "apart" the sum of its bakes as single maps,
# "one" one of these; "sheet" lies on a mesh over all tiles, "sheet of 2" on one over two. Seconds, median; memory,
# the largest of one process. Prints a table.
# Exit status: 0 done, 1 failed, or a set takes more memory than as many single bakes as there are threads, or
# grows with the number of tiles by more than a tenth, 2 usage.
set -euo pipefail
export LC_ALL=C

[ $# -ge 1 ] && [ $# -le 4 ] || { sed -n '/^#   run_udim/,/^#   RUNS/s/^# *//p' "$0" >&2; exit 2; }
scree=$(realpath "$1/bake/scree")
size=${2:-2048} tiles=${3:-6} runs=${4:-3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$scree" sample fractal --size "$size" -o "$work/pair" --quiet
for kind in height color; do
    [ $kind = height ] && map=(--addc 540 --mulc 0.0009) || map=()
    oiiotool "$work/pair/fractal.$kind.exr" "${map[@]}" -d uint16 -o "$work/$kind.1001.png"
    for ((i = 1; i < tiles; ++i)); do cp "$work/$kind.1001.png" "$work/$kind.$((1001 + i)).png"; done
done
sheet() { # TILES: one face over as many
    printf 'v 0 0 0\nv %d 0 0\nv %d 1 0\nv 0 1 0\nvt 0 0\nvt %d 0\nvt %d 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n' \
        "$1" "$1" "$1" "$1"
}
sheet "$tiles" > "$work/sheet.obj"
sheet 2 > "$work/two.obj"
timed() { # RUNS_FILE TILE OPTIONS...: a line "seconds user system kilobytes"
    local file=$1 tile=$2
    shift 2
    /usr/bin/time -q -f "%e %U %S %M" -o "$work/time" "$scree" bake \
        --height "$work/height.$tile.png" --color "$work/color.$tile.png" --pixel-type half \
        -o "$work/out" --quiet "$@"
    cat "$work/time" >> "$work/$file"
    rm -rf "$work/out"
}
round() {
    local plane=(--height-scale 1111 --world-size 4000 --wrap clamp)
    timed tiles.runs '<UDIM>' "${plane[@]}"
    timed meeting.runs '<UDIM>' "${plane[@]}" --udim-wrap
    timed one.runs 1001 "${plane[@]}"
    timed sheet.runs '<UDIM>' --height-scale 0.1 --mesh "$work/sheet.obj"
    timed two.runs '<UDIM>' --height-scale 0.1 --mesh "$work/two.obj"
    rm -f "$work/sum"
    for ((i = 0; i < tiles; ++i)); do timed sum $((1001 + i)) "${plane[@]}"; done
    awk '{ s += $1; u += $2; k += $3; m = $4 > m ? $4 : m } END { print s, u, k, m }' "$work/sum" \
        >> "$work/apart.runs"
}
median() { sort -n | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }
wall() { cut -d' ' -f1 "$work/$1.runs" | median; }
processor() { awk '{ print $2 + $3 }' "$work/$1.runs" | median; }
memory() { cut -d' ' -f4 "$work/$1.runs" | sort -n | tail -1; }

printf '%d tiles of %dx%d, %d cores, load %s\n\n' "$tiles" "$size" "$size" "$(nproc)" \
    "$(cut -d' ' -f1 /proc/loadavg)"
for ((i = 0; i <= runs; ++i)); do
    [ $i -ne 1 ] || rm -f "$work"/*.runs # the first was the warm-up
    round
done
echo "| bake | s | ratio | processor s | ratio | MB |"
echo "| --- | --- | --- | --- | --- | --- |"
for name in apart tiles meeting one sheet two; do
    label=$name
    [ $name != two ] || label="sheet of 2"
    awk -v n="$label" -v s="$(wall $name)" -v s0="$(wall apart)" -v p="$(processor $name)" \
        -v p0="$(processor apart)" -v m="$(memory $name)" 'BEGIN {
            printf "| %s | %.2f | %.2f | %.2f | %.2f | %.0f |\n", n, s, s / s0, p, p / p0, m / 1000 }'
done
[ "$(memory tiles)" -le $(($(memory one) * $(nproc))) ] || { echo "too much memory" >&2; exit 1; }
[ "$(memory sheet)" -le $(($(memory two) * 11 / 10)) ] || { echo "memory grows with the tiles" >&2; exit 1; }
