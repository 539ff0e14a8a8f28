# scree bake --mesh: what it says, records and refuses.
. "$(dirname "$0")/lib.sh"

"$scree" sample fractal --size 64 -o pair --quiet || fail "scree sample fractal"
cat > quad.obj << 'END'
v 0 0 0
v 2 0 0
v 2 1 1
v 0 1 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3 4/4
END
bake=("$scree" bake --height pair/fractal.height.exr --height-scale 0.001 --mesh)

expect_success 'a mesh' -- "${bake[@]}" quad.obj -o set
expect_success 'info' -- "$scree" info set
grep -q 'mesh     quad.obj (faces: 1)' stdout || fail "no mesh: $(cat stdout)"
grep -q 'charts: 1, mirrored: 0; 4096 texels in them, 2.82843 square world units; overlapped 0' stdout ||
    fail "no charts: $(cat stdout)"
grep -q 'catmull-clark subdivision, boundary edge-and-corner, UVs linear: all' stdout ||
    fail "no rules: $(cat stdout)"
grep -q 'texture units' stdout || fail 'the texel has no size in the world'
expect_success 'a preview of the set' -- "$scree" preview set --parts plain,set -o p.png --size 64 48
for command in "validate set --inputs pair" "preview set --inputs pair -o p.png" \
    "table brdf --set set --reference --inputs pair -o t"; do
    run "$scree" $command
    expect_equal "$command" "$status" 1
    grep -q 'set: was baked for a mesh' stderr || fail "$command said: $(said)"
done

expect_usage_error 'two sizes' 'mesh.*--texel-size' -- "${bake[@]}" quad.obj --texel-size 1 -o out
expect_usage_error 'views' 'planes only' -- "${bake[@]}" quad.obj --maps auto -o out
expect_usage_error 'a rule without a mesh' 'give --mesh' -- \
    "$scree" bake --height pair/fractal.height.exr --boundary none -o out
expect_usage_error 'no such scheme' 'butterfly.*catmull-clark' -- \
    "${bake[@]}" quad.obj --scheme butterfly -o out
expect_usage_error 'no such rule' 'smooth.*edge-only' -- "${bake[@]}" quad.obj --boundary smooth -o out

# refused NAME WORDS TEXT...: a mesh of that text ends the bake with status 1 and one line.
refused()
{
    printf '%b' "$3" > bad.obj
    run "${bake[@]}" bad.obj -o out
    expect_equal "$1" "$status" 1
    said | grep -q "bad.obj.*$2" || fail "$1 said: $(said)"
    expect_equal "$1: lines" "$(said | wc -l)" 1
    [ ! -e out ] || fail "$1 left a set"
}
points='v 0 0 0\nv 1 0 0\nv 1 1 0\n'
refused 'empty' '' ''
refused 'no faces' 'face' "$points"
refused 'no UVs' 'texture coordinates' "${points}f 1 2 3\n"
refused 'NaN' 'line 1' "v nan 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\n"
refused 'no area in the texture' 'UV chart' "${points}vt 0 0\nvt 1 1\nf 1/1 2/1 3/2\n"
refused 'an index out of range' '' "${points}vt 0 0\nf 1/1 2/1 9/1\n"
run "${bake[@]}" missing.obj -o out
expect_equal 'missing' "$status" 1
said | grep -q 'missing.obj' || fail "missing said: $(said)"
run "${bake[@]}" quad.obj --scheme loop -o out
expect_equal 'loop of quadrilaterals' "$status" 1

# warned NAME WORDS TEXT...: a mesh of that text is baked, with a warning.
warned()
{
    printf '%b' "$3" > odd.obj
    run "${bake[@]}" odd.obj -o odd
    expect_equal "$1" "$status" 0
    grep -q "warning: odd.obj: $2" stderr || fail "$1 said: $(cat stderr)"
}
square='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n'
warned 'a pentagon' '1 face of more than four corners' \
    "${square}v 0.5 2 0\nvt 0.5 1\nf 1/1 2/2 3/3 5/5 4/4\n"
warned 'three faces at an edge' '1 edge of three or more faces' \
    "${square}v 0 0 1\nf 1/1 2/2 3/3\nf 1/1 2/2 4/4\nf 1/1 2/2 5/4\n"
warned 'two on one place' 'UV charts overlap in 4096 texels, first of faces 1 and 2 at texel 0, 0' \
    "${square}v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\n"
warned 'a face without area in the texture' '1 face without area in the texture' \
    "${square}v 2 0 0\nf 1/1 2/2 3/3 4/4\nf 2/1 5/1 3/1\n"
warned 'no rule at the border' '1 face without a surface' "${square}v 9 9 9\nt interpolateboundary 1/0/0 1\n\
f 1/1 2/2 3/3 4/4\nt hole 1/0/0 1\nf 2/1 3/2 5/3\n"
warned 'faces in another tile' 'faces reach into tiles 1001, 1002' \
    "${square}vt 2 0\nvt 2 1\nv 2 0 0\nv 2 1 0\nf 1/1 2/2 3/3 4/4\nf 2/2 5/5 6/6 3/3\n"

cat > recipe.toml << 'END'
height = "pair/fractal.height.exr"
height-scale = 0.001
mesh = "quad.obj"
boundary = "edge-only"
END
mkdir elsewhere
cd elsewhere || exit 1
expect_success 'a recipe' -- "$scree" bake ../recipe.toml -o set --quiet
cd ..
grep -q '"boundary": "edge-only"' elsewhere/set/*.json || fail 'the boundary rule is not recorded'

finish
