#!/usr/bin/env bash
# Draws docs/picture.png: a baked sample, level by level. Usage: docs/picture.sh SCREE_PROGRAM
#
# Columns: MIP levels 0, 2, 4 and 6, enlarged to the size of level 0. Rows: mean color; mean slope
# (red s, green t, 0 is gray); spread of the slope inside a texel (root of the variance along s and
# t); spread of the height inside a texel.
set -euo pipefail
scree=$(realpath "$1")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$scree" sample bricks --size 256 -o "$work" --quiet
"$scree" bake "$work/bricks.toml" -o "$work/set" --pixel-type float --quiet
set="$work/set/bricks"
enlarge=(--resize:filter=box 256x256)
tiles=()
tile() { # NAME ARGUMENTS...: one picture of the mosaic
    local name=$1
    shift
    oiiotool "$@" -d uint8 -o "$work/$name.png"
    tiles+=("$work/$name.png")
}
for level in 0 2 4 6; do
    tile "color$level" "$set.color.exr" --selectmip $level "${enlarge[@]}" \
        --powc 0.4545
done
for level in 0 2 4 6; do # s t -> R G
    tile "slope$level" "$set.slope.exr" --selectmip $level "${enlarge[@]}" \
        --ch s,t,B=0.0 --chnames R,G,B --mulc 1.5,1.5,0 --addc 0.5,0.5,0.5
done
for level in 0 2 4 6; do # sqrt(ss - s s), sqrt(tt - t t)
    oiiotool "$set.slope.exr" --selectmip $level --ch s,t -o "$work/mean.exr"
    oiiotool "$set.slope.exr" --selectmip $level --ch ss,tt "$work/mean.exr" --dup --mul --sub \
        --maxc 0 --powc 0.5 -o "$work/sigma.exr"
    tile "sigma$level" "$work/sigma.exr" "${enlarge[@]}" --ch 0,1,B=0.0 --chnames R,G,B \
        --mulc 1.5
done
for level in 0 2 4 6; do
    oiiotool "$set.height.exr" --selectmip $level --ch h -o "$work/mean.exr"
    oiiotool "$set.height.exr" --selectmip $level --ch hh "$work/mean.exr" --dup --mul --sub \
        --maxc 0 --powc 0.5 -o "$work/sigma.exr"
    tile "height$level" "$work/sigma.exr" "${enlarge[@]}" --ch 0,0,0 --chnames R,G,B --mulc 0.7
done
oiiotool "${tiles[@]}" --mosaic:pad=8 4x4 -o picture.png
