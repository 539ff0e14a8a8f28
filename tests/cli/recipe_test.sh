# The command line and the recipe: mistakes in either end with exit status 2 and name their place;
# the command line wins; a recipe's paths are relative to it.
. "$(dirname "$0")/lib.sh"

"$scree" sample fractal --size 32 -o pair --quiet || fail "scree sample fractal"
height=pair/fractal.height.exr
bake=("$scree" bake --height $height -o out --quiet)

# --- the command line ------------------------------------------------------------------------------
expect_usage_error "no command" 'command' -- "$scree"
expect_usage_error "unknown command" "there is no command 'bkae'; see scree --help" -- "$scree" bkae
expect_usage_error "unknown command with options" "no command 'bkae'; see scree --help" -- \
    "$scree" bkae -o out
expect_usage_error "an option before the command" "no option '--quiet'; see scree --help" -- \
    "$scree" --quiet
expect_usage_error "unknown option" '--heigth.*--help' -- "$scree" bake --heigth x -o out
expect_usage_error "no height" '--height FILE' -- "$scree" bake -o out
expect_usage_error "no output" '-o DIR' -- "$scree" bake --height $height
expect_usage_error "option without value" '--height-scale' -- "${bake[@]}" --height-scale
expect_usage_error "a word for a number" '--height-scale.*tall' -- "${bake[@]}" --height-scale tall
expect_usage_error "a word for a count" '--threads' -- "${bake[@]}" --threads some
expect_usage_error "fewer than no threads" '--threads' -- "${bake[@]}" --threads=-1
expect_usage_error "unknown wrap" 'wrap.*repeat.*periodic' -- "${bake[@]}" --wrap repeat
expect_usage_error "unknown second wrap" 'repeat.*mirror' -- "${bake[@]}" --wrap clamp repeat
expect_usage_error "unknown input" 'bump.*height.*normal' -- "${bake[@]}" --input bump
expect_usage_error "unknown reconstruction" 'cubic.*sobel' -- "${bake[@]}" --reconstruction cubic
expect_usage_error "unknown pixel type" 'uint8.*half' -- "${bake[@]}" --pixel-type uint8
expect_usage_error "unknown range" 'both.*signed' -- "${bake[@]}" --normal-range both
expect_usage_error "unknown layout" 'maketx.*bumpslopes' -- "${bake[@]}" --layout maketx
expect_usage_error "unknown compression" 'lzw.*zip' -- "${bake[@]}" --compression lzw
for lossy in b44 b44a pxr24 dwaa dwab; do
    expect_usage_error "lossy compression $lossy" "$lossy.*zip" -- "${bake[@]}" --compression $lossy
done
expect_usage_error "unknown map" 'normals.*slope,height,color' -- "${bake[@]}" --maps slope,normals
expect_failure 2 "set of its own and --maps" '--maps.*bumpslopes' -- \
    "${bake[@]}" --layout bumpslopes --maps slope
for map in color colorheight colorslope; do
    expect_error "--maps $map without color" "$map.*--color" -- "${bake[@]}" --maps $map
done
expect_error "--maps height of a normal map" 'height.*normal map' -- "$scree" bake --input normal \
    --height pair/fractal.color.exr --maps height -o out
expect_failure 2 "two sizes" '--texel-size.*--world-size' -- \
    "${bake[@]}" --texel-size 1 --world-size 2
for size in 0 -1 nan inf; do
    expect_failure 2 "texel size $size" '--texel-size.*above 0' -- "${bake[@]}" --texel-size=$size
    expect_failure 2 "world size 1 $size" '--world-size.*above 0' -- "${bake[@]}" --world-size 1 $size
done
expect_failure 2 "height scale nan" '--height-scale' -- "${bake[@]}" --height-scale nan
expect_failure 2 "tolerance below 0" '--half-tolerance' -- "${bake[@]}" --half-tolerance=-1
expect_usage_error "a name with folders" "--name '\.\./x'" -- "${bake[@]}" --name ../x
expect_error "an OCIO config that is none" 'pair/fractal.toml.*--ocio-config' -- "${bake[@]}" \
    --color pair/fractal.color.exr --ocio-config pair/fractal.toml
expect_error "no such OCIO config" 'gone.ocio.*--ocio-config' -- "${bake[@]}" \
    --color pair/fractal.color.exr --ocio-config gone.ocio
OCIO=gone.ocio expect_error 'no such config in $OCIO' 'gone.ocio.*OCIO' -- "${bake[@]}" \
    --color pair/fractal.color.exr
expect_error "unknown color space" "color.exr: --color-space 'purple'.*it has '" -- "${bake[@]}" \
    --color pair/fractal.color.exr --color-space purple
for kind in sand ""; do
    expect_usage_error "sample '$kind'" 'fractal' -- "$scree" sample "$kind" -o out
done
expect_usage_error "sample of no size" 'size' -- "$scree" sample sine --size 0 -o out

# --- mistakes in a recipe --------------------------------------------------------------------------
# recipe LINE...: writes bad.toml.
recipe()
{
    printf '%s\n' "$@" > bad.toml
}
baker=("$scree" bake bad.toml --height $height -o out --quiet)
recipe 'wrap = "clamp"' '' 'hieght-scale = 2'
expect_usage_error "unknown key" "bad\.toml:3: .*hieght-scale" -- "${baker[@]}"
recipe '' 'help = true'
expect_usage_error "a flag no recipe needs" "bad\.toml:2: .*help" -- "${baker[@]}"
recipe 'wrap = "clamp"' 'height-scale = = 2'
expect_usage_error "syntax error" "bad\.toml:2: " -- "${baker[@]}"
recipe 'height-scale = 2' 'height-scale = 3'
expect_usage_error "a key twice" "bad\.toml:2: .*height-scale" -- "${baker[@]}"
recipe '# scale' 'height-scale = "tall"'
expect_usage_error "text for a number" "bad\.toml:2: height-scale" -- "${baker[@]}"
recipe '' '' 'height-scale = [1, 2]'
expect_usage_error "a list for a number" "bad\.toml:3: height-scale" -- "${baker[@]}"
recipe 'texel-size = []'
expect_usage_error "an empty list" "bad\.toml:1: texel-size" -- "${baker[@]}"
recipe 'texel-size = [1, 2, 3]'
expect_usage_error "three sizes" "bad\.toml:1: texel-size" -- "${baker[@]}"
recipe 'threads = 1.5'
expect_usage_error "a fraction for a count" "bad\.toml:1: threads" -- "${baker[@]}"
recipe 'alpha-weight = "yes"'
expect_usage_error "text for a flag" "bad\.toml:1: alpha-weight.*true or false" -- "${baker[@]}"
recipe 'alpha-weight = 1'
expect_usage_error "a number for a flag" "bad\.toml:1: alpha-weight.*true or false" -- "${baker[@]}"
recipe '[surface]' 'wrap = "clamp"'
expect_usage_error "a table" "bad\.toml:1: .*surface" -- "${baker[@]}"
recipe 'name = 1979-05-27'
expect_usage_error "a date" "bad\.toml:1: .*name" -- "${baker[@]}"
recipe 'wrap = "clamp"' 'pixel-type = "uint8"'
expect_usage_error "a value no option takes" "bad\.toml.*uint8.*half" -- "${baker[@]}"
printf 'name = "\377\376"\n' > bad.toml
expect_usage_error "not UTF-8" "bad\.toml:1: " -- "${baker[@]}"
rm bad.toml
expect_usage_error "no such recipe" "bad\.toml: no such file" -- "${baker[@]}"
mkdir bad.toml
expect_usage_error "a folder" "bad\.toml: is a folder" -- "${baker[@]}"
rmdir bad.toml
expect_usage_error "an image for a recipe" "height\.exr:1: " -- "$scree" bake $height -o out

# --- a good one ------------------------------------------------------------------------------------
# Its paths start at its own folder, wherever the bake runs.
mkdir elsewhere
cat > pair/good.toml << 'END'
# Heights of a map 8 units wide.
height = "fractal.height.exr"
color = "fractal.color.exr"
output = "../out"
name = "mountain"
height-scale = 2
texel-size = [0.25, 0.5]
wrap = ["clamp", "mirror"]
maps = ["slope", "height"]
alpha-weight = false
END
(cd elsewhere && "$scree" bake ../pair/good.toml --quiet) || fail "a good recipe: failed"
expect_equal "what a recipe makes" "$(ls out | tr '\n' ' ')" \
    'mountain.height.exr mountain.scree.json mountain.slope.exr '
expect_equal "wrap of the recipe" "$(manifest_value out wrap)" '["clamp","mirror"]'
expect_equal "texel size of the recipe" "$(manifest_value out texel_size)" '[0.25,0.5]'
expect_equal "scale of the recipe" "$(manifest_value out height_scale)" 2.0
rm -rf out

expect_success "the command line wins" -- "$scree" bake pair/good.toml --quiet --height-scale 3 \
    --wrap periodic --texel-size 1 --name hill --maps tail -o out
expect_equal "files after --maps, --name" "$(ls out | tr '\n' ' ')" 'hill.scree.json hill.tail.exr '
expect_equal "wrap after --wrap" "$(manifest_value out wrap)" '["periodic","periodic"]'
expect_equal "texel size after --texel-size" "$(manifest_value out texel_size)" '[1.0,1.0]'
expect_equal "scale after --height-scale" "$(manifest_value out height_scale)" 3.0
rm -rf out

# Equal options give equal bytes, wherever they stand.
printf 'height-scale = 2.5\nwrap = "clamp"\n' > short.toml
expect_success "from a recipe" -- "$scree" bake short.toml --height $height -o a --quiet
expect_success "from the command line" -- "$scree" bake --height-scale 2.5 --wrap clamp \
    --height $height -o b --quiet
expect_equal "recipe and command line" "$(fingerprint a)" "$(fingerprint b)"
expect_equal "options in the manifest" \
    "$(grep -A 3 '"options"' b/*.scree.json | tr -d ' \n')" \
    '"options":{"height-scale":"2.5","wrap":"clamp"},'

# The recipe a sample comes with.
expect_success "the sample's recipe" -- "$scree" bake pair/fractal.toml -o out --quiet
expect_equal "name of the sample's set" "$(manifest_value out name)" '"fractal"'
rm -rf out

# Recipes that ship: every key is one that bake knows.
for shipped in "$repo"/configs/*.toml; do
    [ -e "$shipped" ] || continue
    expect_success "${shipped##*/}" -- "$scree" bake "$shipped" --height $height --height-scale 1e-4 \
        --color pair/fractal.color.exr -o out --quiet
    rm -rf out
done

finish
