# scree bake of tiles: names with <UDIM>, one manifest, what is missing.
. "$(dirname "$0")/lib.sh"

"$scree" sample fractal --size 64 -o pair --quiet || fail "scree sample fractal"
mkdir in
for number in 1001 1002 1012; do
    oiiotool pair/fractal.height.exr --mulc "0.$number" --addc "$((number - 1001))" \
        -o "in/rock.$number.exr"
    cp pair/fractal.color.exr "in/rock.diff.$number.exr"
done
bake=("$scree" bake --height 'in/rock.<UDIM>.exr' --world-size 4000)

expect_success 'tiles' -- "${bake[@]}" --color 'in/rock.diff.<UDIM>.exr' --udim-wrap -o set
grep -q '^set: 3 tiles, 64x64 the largest' stdout || fail "no summary: $(cat stdout)"
grep -q 'rock.<UDIM>.slope.exr' stdout || fail "no textures: $(cat stdout)"
expect_equal 'manifests' "$(ls set/*.json)" 'set/rock.scree.json'
expect_equal 'slopes' "$(echo set/*.slope.exr)" \
    'set/rock.1001.slope.exr set/rock.1002.slope.exr set/rock.1012.slope.exr'
expect_success 'info' -- "$scree" info set
grep -q '^1012 ' stdout || fail "no tile: $(cat stdout)"
grep -q 'wrap clamp clamp' stdout || fail "tiles wrap: $(cat stdout)"
expect_success 'info of a tile' -- "$scree" info set --udim 1012
grep -q 'rock.1012.slope.exr' stdout || fail "no file: $(cat stdout)"
grep -q 'rock.1001' stdout && fail "another tile's input: $(cat stdout)"
run "$scree" info set --udim 1011
expect_equal 'no such tile' "$status" 1
said | grep -q 'no tile 1011, but 1001, 1002, 1012' || fail "no such tile said: $(said)"
expect_success 'a picture of a tile' -- \
    "$scree" preview set --udim 1002 --parts plain,set -o p.png --size 64 48
run "$scree" preview set --parts plain,set -o p.png --size 64 48
expect_equal 'a picture of no tile' "$status" 1
said | grep -q 'name one with --udim' || fail "a picture of no tile said: $(said)"
run "$scree" validate set --udim 1001 --inputs in
expect_equal 'validate of tiles that meet' "$status" 1
said | grep -q 'without --udim-wrap' || fail "validate said: $(said)"

rm in/rock.1012.exr
expect_success 'a tile less' -- "${bake[@]}" --color 'in/rock.diff.<UDIM>.exr' -o set
grep -q 'warning: tile 1012: no in/rock.<UDIM>.exr; left out' stderr || fail "no word: $(cat stderr)"
[ ! -e set/rock.1012.slope.exr ] || fail 'a tile of the set before is left'
expect_success 'validate of a tile' -- "$scree" validate set --udim 1002 --inputs in --statistics-only
expect_success 'a table of a tile' -- "$scree" table brdf --set set --udim 1002 --level 4 \
    --size 4x4x4 -o table
expect_usage_error 'a name of tiles' 'leave out <UDIM>' -- "${bake[@]}" --name 'r.<UDIM>' -o out
expect_usage_error 'half tiles' 'name the tiles of both' -- \
    "${bake[@]}" --color in/rock.diff.1001.exr -o out
expect_usage_error 'no tiles' 'speaks of tiles' -- \
    "$scree" bake --height in/rock.1001.exr --udim-wrap -o out
run "$scree" bake --height 'in/none.<UDIM>.exr' -o out
expect_equal 'none there' "$status" 1
said | grep -q 'none.<UDIM>.exr: there is no tile; expected in/none.1001.exr' || fail "none: $(said)"
[ ! -e out ] || fail 'something was written'

finish
