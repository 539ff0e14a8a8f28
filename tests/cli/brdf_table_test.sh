# scree table brdf: a table of a level of a set, what it records, what it refuses.
. "$(dirname "$0")/lib.sh"

"$scree" sample bricks --size 64 -o pair --quiet || fail "scree sample bricks"
"$scree" bake pair/bricks.toml -o set --quiet || fail "scree bake"

small="--set set --level 5 --size 6x5x4"
expect_success 'default folder' -- "$scree" table brdf $small
expect_equal 'its files' "$(ls brdf-hybrid | tr '\n' ' ')" \
    'brdf-hybrid.exr brdf-hybrid.scree-table.json '
grep -q '6 |h_bar| x 5 |k| / reach x 4 azimuth' stdout || fail "no summary: $(cat stdout)"
grep -q '"turns": "16"' brdf-hybrid/brdf-hybrid.scree-table.json || fail 'defaults are not recorded'
grep -q '"level": "5"' brdf-hybrid/brdf-hybrid.scree-table.json || fail '--level is not recorded'
before=$(fingerprint brdf-hybrid)
expect_success 'one thread, quiet' -- "$scree" table brdf $small --threads 1 --quiet
expect_equal 'the same bytes with one thread' "$(fingerprint brdf-hybrid)" "$before"

expect_success 'half-difference' -- "$scree" table brdf $small --parametrization half-difference
grep -q '6 theta_h x 5 theta_d / reach x 4 phi_d' stdout || fail "half-difference: $(cat stdout)"
expect_success 'whole' -- \
    "$scree" table brdf $small --parametrization orthographic --second whole --spacing even
grep -q '5 |k_bar| x' stdout || fail "whole: $(cat stdout)"

expect_success 'three at equal bytes' -- "$scree" table brdf $small --compare -o compared
for kind in hybrid orthographic half-difference; do
    grep -q "rms error in %, $kind, grazing: [0-9]" stdout || fail "no error of $kind: $(cat stdout)"
    grep -q "rms error in %, $kind, all" compared/brdf-hybrid.scree-table.json ||
        fail "no error of $kind in the manifest"
done
cmp -s compared/brdf-hybrid.exr brdf-hybrid/brdf-hybrid.exr || fail 'comparing changes the table'

rays="--set set --reference --samples 8 --size 6x5x4 -o rays"
expect_success 'by rays' -- "$scree" table brdf $rays --inputs pair
grep -q 'rms noise in %, all: [0-9]' stdout || fail "no noise: $(cat stdout)"
grep -q '"reference": "true"' rays/brdf-hybrid.scree-table.json || fail '--reference is not recorded'
before=$(fingerprint rays)
expect_success 'by rays, one thread' -- "$scree" table brdf $rays --inputs pair --threads 1
expect_equal 'the same bytes with one thread' "$(fingerprint rays)" "$before"
mv pair elsewhere
run "$scree" table brdf $rays
expect_equal 'rays without the inputs' "$status" 1
grep -q -- '--inputs' stderr || fail "said: $(said)"
mv elsewhere pair
expect_usage_error 'neither level nor rays' '--level is required' -- \
    "$scree" table brdf --set set --size 6x5x4
expect_usage_error 'samples without rays' '--reference' -- "$scree" table brdf $small --samples 8
run "$scree" table brdf $rays --inputs pair --level 7
expect_equal 'no such level, by rays' "$status" 1

for wrong in 4x5 4x5x 1x5x6 4x5x6x7 a; do
    expect_usage_error "size $wrong" "expected three numbers.*got '$wrong'" -- \
        "$scree" table brdf --set set --level 5 --size $wrong -o out
done
expect_usage_error 'no set' 'set is required' -- "$scree" table brdf --level 0
expect_usage_error 'no such axes' 'parametrization' -- \
    "$scree" table brdf $small --parametrization polar
run "$scree" table brdf --set set --level 7 --size 6x5x4 -o out
expect_equal 'no such level' "$status" 1
grep -q 'has no level 7; give one from 0 to 6' stderr || fail "said: $(said)"
expect_equal 'and no folder' "$(ls -d out 2> /dev/null)" ''

finish
