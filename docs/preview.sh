#!/usr/bin/env bash
# Draws docs/preview.png: a brick wall as a receding plane, in three parts: a plain MIP chain, a set, the
# reference. Usage: docs/preview.sh SCREE_PROGRAM
set -euo pipefail
scree=$(realpath "$1")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$scree" sample bricks --size 512 -o "$work" --quiet
"$scree" bake "$work/bricks.toml" -o "$work/set" --quiet
"$scree" preview "$work/set" --inputs "$work" -o preview.png --size 960 320 --samples 144
