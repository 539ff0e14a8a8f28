# Color maps, rank tables, the choice of models and the working space, as a user gives them.
. "$(dirname "$0")/lib.sh"

"$scree" sample fractal --size 64 -o pair --quiet || fail "scree sample fractal"
height=pair/fractal.height.exr

cat > terrain.cpt << 'END'
# COLOR_MODEL = RGB
0    20/30/120   500  60/140/60
500  60/140/60   900  250/250/250
B 0/0/0
F 255/255/255
N 128/128/128
END
printf 'Version 1\nFrom 0.0 1.0\nLength 2\nComponents 1\n{\n0\n1\n}\n' > gray.spi1d

expect_success "a color map" -- "$scree" bake --height $height --colormap terrain.cpt \
    --world-size 4000 --name fractal -o mapped
for file in color map rank colorheight; do
    [ -f mapped/fractal.$file.exr ] || fail "a color map: no fractal.$file.exr"
done
expect_success "info of it" -- "$scree" info mapped
for words in 'color map by height, 0 to 900' 'table [0-9]*x[0-9]*' 'corr with height' 'rank 4'; do
    grep -q "$words" stdout || fail "info: expected '$words' in: $(cat stdout)"
done
grep -q '"role": "colormap"' mapped/fractal.scree.json || fail "the manifest does not name the map"
expect_success "baked again in its place" -- "$scree" bake --height $height --colormap terrain.cpt \
    --world-size 4000 --name fractal -o mapped

expect_success "by slope along a direction" -- "$scree" bake --height $height --world-size 4000 \
    --colormap gray.spi1d --map-by slope --map-azimuth 30 --map-range -1 1 -o along
grep -q 'color map by slope along 30 degrees, -1 to 1' stdout || fail "along: $(cat stdout)"
expect_success "by steepness" -- "$scree" bake --height $height --world-size 4000 \
    --colormap gray.spi1d --map-by slope --map-range 0 1 -o steepness
expect_error "by slope without a range" 'gray\.spi1d: .*--map-range' -- "$scree" bake \
    --height $height --colormap gray.spi1d --map-by slope -o none
expect_usage_error "an azimuth of heights" '--map-by slope' -- "$scree" bake --height $height \
    --colormap gray.spi1d --map-azimuth 30 -o none
expect_usage_error "a range the wrong way round" '--map-range' -- "$scree" bake --height $height \
    --colormap gray.spi1d --map-range 3 1 -o none
for words in "--map-range 0 inf" "--map-range -1e308 1e308" "--map-tolerance inf" \
    "--model-tolerance nan" "--half-tolerance inf"; do
    expect_usage_error "$words" "${words%% *}" -- "$scree" bake --height $height \
        --colormap gray.spi1d $words -o none
done
expect_usage_error "a range without a map" '--colormap' -- "$scree" bake --height $height \
    --map-range 0 1 -o none
expect_usage_error "bumpslopes and auto" 'bumpslopes' -- "$scree" bake --height $height \
    --layout bumpslopes --maps auto -o none
expect_usage_error "bumpslopes and a color map" 'bumpslopes' -- "$scree" bake --height $height \
    --layout bumpslopes --colormap gray.spi1d -o none
expect_success "a map that the heights miss" -- "$scree" bake --height $height --world-size 4000 \
    --colormap gray.spi1d --map-range -9000 -8000 -o missed
expect_warning "a map that the heights miss" 'the color map goes from -9000 to -8000.*--map-range'
cmp <(sha256sum < mapped/fractal.map.exr) <(sleep 1.1; "$scree" bake --height $height \
    --colormap terrain.cpt --world-size 4000 --name fractal --quiet -o mapped;
    sha256sum < mapped/fractal.map.exr) || fail "the same table, a second later, has other bytes"
expect_usage_error "color and color map" '--colormap' -- "$scree" bake --height $height \
    --color pair/fractal.color.exr --colormap gray.spi1d -o none
expect_error "a table without a map" '--maps map.*--colormap' -- "$scree" bake \
    --height $height --maps map -o none
expect_error "no such map" 'gone\.cpt: no such file' -- "$scree" bake --height $height \
    --colormap gone.cpt -o none
printf '0 1/2/3 1 4/5\n' > broken.cpt
expect_error "a broken map" 'broken\.cpt: line 1: .*4/5' -- "$scree" bake --height $height \
    --colormap broken.cpt -o none

cat > recipe.toml << 'END'
height = "pair/fractal.height.exr"
name = "fractal"
colormap = "terrain.cpt"
map-by = "height"
map-range = [-100.0, 1000.0]
world-size = 4000
maps = "auto"
max-view-angle = 60
model-tolerance = 0.02
END
expect_success "a recipe, maps chosen" -- "$scree" bake recipe.toml -o chosen
grep -q 'models for views to 60 degrees' stdout || fail "auto: $(cat stdout)"
[ "$(grep -c '  chosen' stdout)" -ge 1 ] || fail "auto: nothing is chosen in: $(cat stdout)"
grep -q 'color map by height, -100 to 1000' stdout || fail "range of a recipe: $(cat stdout)"
for file in chosen/*.exr; do # what is there is what the manifest lists
    grep -q "\"$(basename "$file")\"" chosen/fractal.scree.json || fail "$file is not listed"
done
expect_usage_error "auto and a list" 'auto' -- "$scree" bake --height $height --maps auto,slope \
    -o none
expect_usage_error "a view from below" '--max-view-angle' -- "$scree" bake --height $height \
    --maps auto --max-view-angle 95 -o none
expect_usage_error "no terms" '--rank-terms' -- "$scree" bake --height $height --rank-terms 9 -o none

expect_success "a rank table of two terms" -- "$scree" bake pair/fractal.toml --maps color,rank \
    --rank-terms 2 -o two
grep -A12 '"rank"' two/fractal.scree.json | tr -d ' \n' |
    grep -q '"B1","B2","G1","G2","R1","R2"' || fail "two terms: $(cat two/fractal.scree.json)"

expect_success "a working space" -- "$scree" bake pair/fractal.toml --working-space ACEScg -o aces
grep -q '"working_space": "acescg"' aces/fractal.scree.json || fail "the working space is not told"
expect_error "an encoded working space" "srgb_tx.*--working-space|--working-space.*srgb_tx" -- \
    "$scree" bake pair/fractal.toml --working-space srgb_tx -o none
expect_error "no such working space" '--working-space.*nowhere' -- "$scree" bake pair/fractal.toml \
    --working-space nowhere -o none
[ ! -e none ] || fail "a bake that failed left a folder"

finish
