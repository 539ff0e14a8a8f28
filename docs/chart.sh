#!/usr/bin/env bash
# Measures speed against accuracy on samples and real assets; prints the tables of docs/methods.md and
# draws its charts. Usage: docs/chart.sh SCREE_PROGRAM DATA_FOLDER, the folder of real height maps
set -euo pipefail
scree=$(realpath "$1")
data=$(realpath "$2")/heights
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

recipe() { # NAME HEIGHT COLOR HEIGHT_SCALE MORE...: heights scaled to the rms slope in the text
    printf 'name = "%s"\nheight = "%s"\ncolor = "%s"\nheight-scale = %s\n' "$1" "$data/$2" "$data/$3" "$4"
    printf '%s\n' "${@:5}"
}
recipe rock_05 material/rock_05/rock_05_bump_1k.png material/rock_05/rock_05_diff_1k.png \
    0.0033048 > "$work/rock_05.toml"
recipe rock023 material/rock023/rock023_alb_ht.png material/rock023/rock023_alb_ht.png \
    0.027592 'height-channel = "A"' > "$work/rock023.toml"
recipe bricks_02 structured/bricks_02_256/bricks_02_height_2k_raw.exr \
    structured/bricks_02_256/bricks_02_basecolor_2k_acescg.exr 0.013156 > "$work/bricks_02.toml"

"$scree" chart fractal bricks vgroove "$work"/{rock_05,rock023,bricks_02}.toml -o "$work/chart" --svg
for drawn in rock_05-60-75-radiance-time rock_05-75-85-color-time bricks-60-75-radiance-time; do
    cp "$work/chart/chart-$drawn.svg" "chart-$drawn.svg"
done
