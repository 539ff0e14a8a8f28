# scree preview: the pictures it writes, what it prints, what it refuses.
. "$(dirname "$0")/lib.sh"
need oiiotool

"$scree" sample bricks --size 64 -o pair --quiet || fail "scree sample bricks"
"$scree" bake pair/bricks.toml -o pair/set --quiet || fail "scree bake"

# size FILE: width and height of a picture.
size() { oiiotool --info "$1" | sed -E 's/.*: +([0-9]+) x +([0-9]+),.*/\1 \2/'; }

small="--size 60 30 --samples 4 --tile 8 --strip-angles 0,80"
expect_success "both pictures" -- "$scree" preview pair/set -o plane.png --strip strip.exr $small
expect_equal "size of the plane" "$(size plane.png)" "60 30"
expect_equal "size of the strip" "$(size strip.exr)" "18 28"
for words in 'plane.png: from the left plain MIP, set, reference' \
    'strip.exr: from the top plain MIP, set, reference; from the left 0, 80 degrees' \
    'brightness' '2400 samples'; do
    grep -q "$words" stdout || fail "preview: expected '$words' in: $(cat stdout)"
done
cp plane.png first.png
expect_success "the same again" -- "$scree" preview pair/set -o plane.png $small --threads 1 --quiet
expect_equal "--quiet" "$(cat stdout stderr)" ""
cmp -s plane.png first.png || fail "equal seeds, other pictures"
expect_success "another seed" -- "$scree" preview pair/set -o plane.png $small --seed 2 --quiet
cmp -s plane.png first.png && fail "other seeds, equal pictures"

# Without the reference nothing but the set is read; parts may stand before the set's name.
cp -r pair/set alone
expect_success "no inputs" -- "$scree" preview --parts plain,set alone -o plane.png $small
grep -q 'brightness' stdout && fail "figures without a reference: $(cat stdout)"
expect_error "inputs that are gone" 'bricks\.height\.exr: .*--inputs' -- \
    "$scree" preview alone -o out.png
expect_success "inputs named" -- "$scree" preview alone --inputs pair -o plane.png $small

"$scree" bake pair/bricks.toml --wrap clamp -o clamped --quiet || fail "scree bake --wrap clamp"
expect_success "a set that does not repeat" -- \
    "$scree" preview clamped --inputs pair -o plane.png $small
grep -q 'note: .*clamp.*seams' stdout || fail "expected a note on seams in: $(cat stdout)"

oiiotool --pattern constant:color=0.5,0.5,1 16x16 3 -o normal.png
"$scree" bake --height normal.png --input normal -o normals --quiet || fail "bake of a normal map"
expect_error "a normal map" 'normals: .*normal map.*--parts plain,set' -- \
    "$scree" preview normals --inputs . -o out.png

"$scree" bake pair/bricks.toml --height-scale 1e6 -o high --quiet || fail "bake of high bricks"
expect_error "heights of the wrong scale" 'high: heights range .*--height-scale.*--parts plain,set' -- \
    "$scree" preview high --inputs pair -o out.png

expect_usage_error "no picture" 'name one with -o or --strip' -- "$scree" preview pair/set
expect_usage_error "a light below the plane" '--light: expected a number from 0 to 89' -- \
    "$scree" preview pair/set -o out.png --light 90 0
expect_usage_error "an angle that is no number" '--view-angle: expected a number' -- \
    "$scree" preview pair/set -o out.png --view-angle nan
expect_usage_error "an unknown part" 'truth' -- "$scree" preview pair/set -o out.png --parts truth
expect_usage_error "an angle beyond the horizon" 'view-angle' -- \
    "$scree" preview pair/set -o out.png --view-angle 90
# Found before anything is drawn.
expect_error "no such folder" '^scree: error: gone/a\.png: .*no folder gone' -- \
    "$scree" preview pair/set -o gone/a.png
mkfifo pipe.png
expect_error "a pipe" 'pipe\.png: cannot be written: is a device or a pipe' -- \
    "$scree" preview pair/set -o pipe.png
expect_error "an unknown ending" 'a\.what: .*\.png' -- "$scree" preview pair/set -o a.what
expect_error "no set" 'pair: no texture set here' -- "$scree" preview pair -o out.png
expect_error "a camera underground" 'show more repeats' -- \
    "$scree" preview pair/set -o out.png --repeats 0.01 $small

expect_equal "pictures left behind" "$(ls | grep -E '^out|^gone|what$')" ""
finish
