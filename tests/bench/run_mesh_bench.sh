#!/usr/bin/env bash
# Times `scree bake` for a mesh against the same bake on a plane, in turn.
#
#   run_mesh_bench.sh BUILD_DIR [SIZE] [RUNS]
#
#   BUILD_DIR  a release build
#   SIZE       of the fractal sample, texels a side (default 4096)
#   RUNS       counted runs, after one that is not (default 5)
#
# The mesh is a torus of 100x100 faces whose texture covers the unit square, so that all texels have a
# metric; all maps of heights and a color, halves, not compressed. "processor" is user + system time.
# Seconds, median; memory, the largest. Prints a table.
# Exit status: 0 done, 1 failed, or the mesh takes more than 3 times the processor time, 2 usage.
set -euo pipefail
export LC_ALL=C

[ $# -ge 1 ] && [ $# -le 3 ] || { sed -n '/^#   run_mesh/,/^#   RUNS/s/^# *//p' "$0" >&2; exit 2; }
scree=$(realpath "$1/bake/scree")
size=${2:-4096} runs=${3:-5}
bound=3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

torus() { # faces counterclockwise seen from outside; the texture's seams along i = 0 and j = 0
    awk -v n=100 'BEGIN {
        turn = 2 * atan2(0, -1) / n
        for (j = 0; j < n; ++j)
            for (i = 0; i < n; ++i) {
                r = 1 + 0.4 * cos(j * turn)
                printf "v %.9f %.9f %.9f\n", r * cos(i * turn), r * sin(i * turn), 0.4 * sin(j * turn)
            }
        for (j = 0; j <= n; ++j)
            for (i = 0; i <= n; ++i) printf "vt %.9f %.9f\n", i / n, j / n
        for (j = 0; j < n; ++j)
            for (i = 0; i < n; ++i) {
                printf "f"
                for (k = 0; k < 4; ++k) {
                    x = i + (k == 1 || k == 2)
                    y = j + (k >= 2)
                    printf " %d/%d", y % n * n + x % n + 1, y * (n + 1) + x + 1
                }
                print ""
            }
    }'
}
torus > "$work/torus.obj"
"$scree" sample fractal --size "$size" -o "$work/pair" --quiet
options_of() { # NAME; heights that are small against the torus
    case $1 in
        plane) echo "--world-size 4000" ;;
        mesh) echo "--height-scale 0.0001 --mesh $work/torus.obj" ;;
    esac
}
bake() { # NAME: a line "seconds user system kilobytes" to NAME.runs
    # shellcheck disable=SC2046 # several words
    /usr/bin/time -q -f "%e %U %S %M" -o "$work/time" "$scree" bake \
        --height "$work/pair/fractal.height.exr" --color "$work/pair/fractal.color.exr" \
        --visibility smith --pixel-type half --compression none $(options_of "$1") \
        -o "$work/out" --quiet
    cat "$work/time" >> "$work/$1.runs"
    rm -rf "$work/out"
}
median() { sort -n | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }
wall() { cut -d' ' -f1 "$work/$1.runs" | median; }
processor() { awk '{ print $2 + $3 }' "$work/$1.runs" | median; }

printf '%dx%d, %d cores, load %s\n\n' "$size" "$size" "$(nproc)" "$(cut -d' ' -f1 /proc/loadavg)"
for ((i = 0; i <= runs; ++i)); do
    [ $i -ne 1 ] || rm -f "$work"/*.runs # the first was the warm-up
    for name in plane mesh; do bake $name; done
done
echo "| surface | s | ratio | processor s | ratio | MB |"
echo "| --- | --- | --- | --- | --- | --- |"
over=0
for name in plane mesh; do
    memory=$(cut -d' ' -f4 "$work/$name.runs" | sort -n | tail -1)
    awk -v n=$name -v s="$(wall $name)" -v s0="$(wall plane)" -v p="$(processor $name)" \
        -v p0="$(processor plane)" -v m="$memory" -v bound=$bound 'BEGIN {
            printf "| %s | %.2f | %.2f | %.2f | %.2f | %.0f |\n", n, s, s / s0, p, p / p0, m / 1000
            exit p / p0 > bound }' || { echo "the mesh takes more than $bound times as long" >&2; over=1; }
done
exit $over
