#!/usr/bin/env bash
# Draws docs/visibility.png: the sample brick wall and a scanned rock, from four views.
# Usage: docs/visibility.sh SCREE_PROGRAM DATA_FOLDER
#
# Columns: 45, 65, 80 and 85 degrees from the normal, bricks, then rock. Rows: a plain MIP chain; a set with
# a rank table, whose exponent is Smith's; a set with visibility tables, of bricks along axes; the
# reference.
set -euo pipefail
scree=$(realpath "$1")
rock=$(realpath "$2")/heights/material/rock_05
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$scree" sample bricks --size 512 -o "$work" --quiet
ln -s "$rock"/*.png "$work"
bricks=("$work/bricks.toml")
rock=(--height "$work/rock_05_bump_1k.png" --color "$work/rock_05_diff_1k.png"
      --height-scale 0.0033048) # an rms slope of 0.6

strip() { # SET PARTS EXPOSURE: SET.png
    "$scree" preview "$work/$1" --inputs "$work" --parts "$2" --strip "$work/$1.png" \
        --strip-angles 45,65,80,85 --tile 80 --light 30 200 --exposure "$3" --quiet
}
columns() { # NAME EXPOSURE TABLE BAKE_OPTIONS...: NAME.png
    local name=$1 exposure=$2 table=$3
    shift 3
    "$scree" bake "$@" -o "$work/$name-smith" --maps slope,tail,height,color,rank --quiet
    # shellcheck disable=SC2086 # several words
    "$scree" bake "$@" -o "$work/$name-tables" --visibility tables $table --quiet
    strip "$name-smith" plain,set "$exposure"
    strip "$name-tables" set,reference "$exposure"
    oiiotool "$work/$name-smith.png" "$work/$name-tables.png" --mosaic:pad=2 1x2 \
        -o "$work/$name.png"
}
columns bricks 3 "--axes auto" "${bricks[@]}"
columns rock 4 "--harmonics 2" "${rock[@]}"
oiiotool "$work/bricks.png" "$work/rock.png" --mosaic:pad=8 2x1 \
    --nosoftwareattrib --eraseattrib Exif:ImageHistory -o visibility.png
