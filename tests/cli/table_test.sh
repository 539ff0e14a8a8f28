# scree table: a folder with a texture and its manifest, whole or not at all.
. "$(dirname "$0")/lib.sh"

expect_success 'default folder' -- \
    "$scree" table linear-light --coordinates angles --resolution 4x5x6
expect_equal 'its files' "$(ls linear-light | tr '\n' ' ')" \
    'linear-light.exr linear-light.scree-table.json '
grep -q '"resolution": "4x5x6"' linear-light/linear-light.scree-table.json ||
    fail 'the manifest does not record --resolution'
grep -q '4 cos theta_v x 5 cos theta_n x 6 phi_n' stdout || fail "no summary: $(cat stdout)"

expect_success 'over the cone when nothing else is said' -- "$scree" table linear-light -o cone
grep -q '"quantity": "stretch"' cone/linear-light.scree-table.json || fail 'no stretch over the cone'
grep -q '"coordinates": "cone"' cone/linear-light.scree-table.json ||
    fail 'the manifest does not say what an option not given stands for'
grep -q '32 cos theta_v x 64 (r + 1) / (r + 3) x 32 side' stdout || fail "no summary: $(cat stdout)"
expect_success 'over angles as the source has it' -- \
    "$scree" table linear-light --coordinates angles -o angles
grep -q '32 cos theta_v x 128 cos theta_n x 64 phi_n' stdout || fail "no summary: $(cat stdout)"

before=$(fingerprint linear-light)
expect_success 'again, one thread, quiet' -- \
    "$scree" table linear-light --coordinates angles --resolution 4x5x6 --threads 1 --quiet
expect_equal 'quiet' "$(cat stdout stderr)" ''
expect_equal 'the same bytes with one thread' "$(fingerprint linear-light)" "$before"

for wrong in 4x5 4x5x 4x5x6x7 1x5x6 4x5x0 4x5x9999 a; do
    expect_usage_error "resolution $wrong" "expected three numbers.*got '$wrong'" -- \
        "$scree" table linear-light --resolution $wrong -o out
done
expect_usage_error 'no kind' 'subcommand is required; see scree table --help' -- "$scree" table
expect_usage_error 'unknown kind' 'scree table --help' -- "$scree" table nothing

echo mine > linear-light/mine.txt
run "$scree" table linear-light --resolution 4x5x6
expect_equal 'a file of the user stops it' "$status" 1
grep -q "holds 'mine.txt', which is not part of its table" stderr || fail "said: $(said)"
expect_equal 'and stays' "$(cat linear-light/mine.txt)" mine

"$scree" sample plane --size 16 -o pair --quiet && "$scree" bake pair/plane.toml -o set --quiet
before=$(fingerprint set)
run "$scree" table linear-light --resolution 4x5x6 -o set
expect_equal 'a texture set stops it too' "$status" 1
grep -q 'no table; choose a new folder' stderr || fail "said: $(said)"
expect_equal 'and stays' "$(fingerprint set)" "$before"

expect_success 'large enough to be stopped' -- "$scree" table linear-light --resolution 2x2x2 -o old
before=$(fingerprint old)
"$scree" table linear-light --resolution 32x256x1024 --quiet -o old > stdout 2> stderr &
for ((i = 0; i < 3000; ++i)); do # the hidden folder comes first
    [ -z "$(staging)" ] || break
    sleep 0.01
done
sleep 0.1
kill -TERM $!
wait $!
expect_equal 'stopped by a signal' "$?" 130
expect_equal 'the old table stays' "$(fingerprint old)" "$before"
expect_equal 'nothing staged' "$(staging)" ''

expect_usage_error 'no such table' "no command 'foo'; see scree table --help" -- "$scree" table foo
expect_usage_error 'no such option' 'see scree table linear-light --help' -- \
    "$scree" table linear-light --foo

finish
