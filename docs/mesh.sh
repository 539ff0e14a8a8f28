#!/usr/bin/env bash
# Draws docs/mesh.png, and prints the figures of docs/surfaces.md beside it: Spot with the heights of a
# scanned rock, baked for the mesh and for a plane.
# Usage: docs/mesh.sh SCREE_PROGRAM MESH_PICTURES_PROGRAM DATA_FOLDER
#
# Needs a TrueType font that fontconfig finds. The plane has the area of Spot's charts in the mean: 3.37
# units a side, the root of 5.59 square units over 0.4915 of the texture (scree info).
set -euo pipefail
scree=$(realpath "$1")
pictures=$(realpath "$2")
data=$(realpath "$3")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mesh="$data/meshes/spot/spot_control_mesh.obj"
inputs=(--height "$data/heights/material/rock_05/rock_05_bump_1k.png" --height-scale 0.006
        --color "$data/meshes/spot/spot_texture.png" --maps slope,height,color)
"$scree" bake "${inputs[@]}" --mesh "$mesh" -o "$work/mesh" --quiet
"$scree" bake "${inputs[@]}" --world-size 3.37 -o "$work/plane" --quiet
"$pictures" "$mesh" "$work/mesh" "$work/plane" "$(fc-match -f '%{file}' sans)" mesh.png
