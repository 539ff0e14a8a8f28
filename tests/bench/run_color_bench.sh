#!/usr/bin/env bash
# Times `scree bake` of a color surface with each way to tell the visible color against the same bake
# with the mean color alone, in turn.
#
#   run_color_bench.sh BUILD_DIR [SIZE] [RUNS]
#
#   BUILD_DIR  a release build
#   SIZE       of the fractal sample, texels a side (default 4096)
#   RUNS       counted runs, after one that is not (default 3)
#
# Tables are of 4 nodes from 8 azimuths. "auto" measures every way besides and drops what it can.
# Halves; wall seconds, median; memory, the largest. Prints a table.
# Exit status: 0 done, 1 failed, or a rank table of 4 terms takes more than 4 times as long, or a
# table of visibility more than 6 times, 2 usage.
set -euo pipefail
export LC_ALL=C

[ $# -ge 1 ] && [ $# -le 3 ] || { sed -n '/^#   run_color/,/^#   RUNS/s/^# *//p' "$0" >&2; exit 2; }
scree=$(realpath "$1/bake/scree")
size=${2:-4096} runs=${3:-3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$scree" sample fractal --size "$size" -o "$work/pair" --quiet
mean=slope,tail,height,color
options_of() { # NAME
    case $1 in
        mean) echo "--maps $mean" ;;
        linear) echo "--maps $mean,colorheight,colorslope" ;;
        rank4) echo "--maps $mean,rank --rank-terms 4" ;;
        rank8) echo "--maps $mean,rank --rank-terms 8" ;;
        corrected) echo "--visibility corrected" ;;
        tables*) echo "--visibility tables --harmonics ${1#tables}" ;;
        axes) echo "--visibility tables --axes auto" ;;
        auto) echo "--maps auto" ;;
    esac
}
names="mean linear rank4 rank8 corrected tables0 tables1 tables2 axes auto"
bake() { # NAME COMPRESSION: a line "seconds kilobytes" to NAME.runs
    # shellcheck disable=SC2046 # several words
    /usr/bin/time -q -f "%e %M" -o "$work/time" "$scree" bake "$work/pair/fractal.toml" \
        -o "$work/out" $(options_of "$1") --pixel-type half --compression "$2" --quiet
    cat "$work/time" >> "$work/$1.runs"
    rm -rf "$work/out"
}
median() { sort -n | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }

printf '%dx%d, %d cores, load %s\n\n' "$size" "$size" "$(nproc)" "$(cut -d' ' -f1 /proc/loadavg)"
echo "| compression | way | s | ratio | MB |"
echo "| --- | --- | --- | --- | --- |"
over=0
for compression in none zip; do
    for ((i = 0; i <= runs; ++i)); do
        [ $i -ne 1 ] || rm -f "$work"/*.runs # the first was the warm-up
        for name in $names; do bake "$name" $compression; done
    done
    base=$(cut -d' ' -f1 "$work/mean.runs" | median)
    for name in $names; do
        case $name in rank4) bound=4 ;; tables* | axes) bound=6 ;; *) bound=1e9 ;; esac
        seconds=$(cut -d' ' -f1 "$work/$name.runs" | median)
        memory=$(cut -d' ' -f2 "$work/$name.runs" | sort -n | tail -1)
        awk -v c=$compression -v n="$name" -v s="$seconds" -v base="$base" -v m="$memory" \
            -v bound=$bound 'BEGIN {
                printf "| %s | %s | %.2f | %.2f | %.0f |\n", c, n, s, s / base, m / 1000
                exit s / base > bound }' || { echo "$name takes more than $bound times as long" >&2; over=1; }
    done
done
exit $over
