#!/usr/bin/env bash
# Times `scree bake` of a color surface with a rank table against the same bake without, in turn.
#
#   run_rank_bench.sh BUILD_DIR [SIZE] [RUNS]
#
#   BUILD_DIR  a release build
#   SIZE       of the fractal sample, texels a side (default 4096)
#   RUNS       counted runs, after one that is not (default 3)
#
# "auto" measures every color model besides and drops what it can. Halves; wall seconds, median;
# memory, the largest. Prints a table.
# Exit status: 0 done, 1 failed or the rank table takes more than 4 times as long, 2 usage.
set -euo pipefail
export LC_ALL=C

[ $# -ge 1 ] && [ $# -le 3 ] || { sed -n '/^#   run_rank/,/^#   RUNS/s/^# *//p' "$0" >&2; exit 2; }
scree=$(realpath "$1/bake/scree")
size=${2:-4096} runs=${3:-3} bound=4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$scree" sample fractal --size "$size" -o "$work/pair" --quiet
without=slope,tail,height,color,colorheight,colorslope
maps_of() {
    case $1 in
        without) echo $without ;;
        rank*) echo $without,rank ;;
        auto) echo auto ;;
    esac
}
bake() { # NAME COMPRESSION: a line "seconds kilobytes" to NAME.runs
    local terms=4
    [ "$1" != rank8 ] || terms=8
    /usr/bin/time -q -f "%e %M" -o "$work/time" "$scree" bake "$work/pair/fractal.toml" \
        -o "$work/out" --maps "$(maps_of "$1")" --rank-terms $terms --pixel-type half \
        --compression "$2" --quiet
    cat "$work/time" >> "$work/$1.runs"
    rm -rf "$work/out"
}
median() { sort -n | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }

printf '%dx%d, %d cores, load %s\n\n' "$size" "$size" "$(nproc)" "$(cut -d' ' -f1 /proc/loadavg)"
echo "| compression | without s | MB | rank 4 s | MB | ratio | rank 8 s | ratio | auto s | ratio |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
over=0
for compression in none zip; do
    for ((i = 0; i <= runs; ++i)); do
        [ $i -ne 1 ] || rm -f "$work"/*.runs # the first was the warm-up
        for name in without rank4 rank8 auto; do bake $name $compression; done
    done
    seconds() { cut -d' ' -f1 "$work/$1.runs" | median; }
    memory() { cut -d' ' -f2 "$work/$1.runs" | sort -n | tail -1 | awk '{ printf "%.0f", $1 / 1000 }'; }
    awk -v c=$compression -v a="$(seconds without)" -v am="$(memory without)" \
        -v b="$(seconds rank4)" -v bm="$(memory rank4)" -v d="$(seconds rank8)" \
        -v e="$(seconds auto)" -v bound=$bound 'BEGIN {
            printf "| %s | %.2f | %d | %.2f | %d | %.2f | %.2f | %.2f | %.2f | %.2f |\n",
                c, a, am, b, bm, b / a, d, d / a, e, e / a
            exit b / a > bound }' || over=1
done
[ $over -eq 0 ] || { echo "the rank table takes more than $bound times as long" >&2; exit 1; }
