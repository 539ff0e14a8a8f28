# Ctrl-C and SIGTERM in the middle of the work: exit status 130, nothing left, an old set intact.
. "$(dirname "$0")/lib.sh"

"$scree" sample fractal --size 64 -o pair --quiet || fail "scree sample fractal"
"$scree" sample fractal --size 2048 -o large --quiet || fail "scree sample fractal"
"$scree" bake pair/fractal.toml -o set --quiet || fail "scree bake"
first=$(fingerprint set)

# interrupt NAME SIGNAL FILE DELAY -- COMMAND...: sends SIGNAL DELAY seconds after a file whose path
# below $work matches the pattern FILE has appeared.
interrupt()
{
    local name=$1 signal=$2 file=$3 delay=$4 pid i left
    shift 5
    checks=$((checks + 1))
    set -m # a process group of its own, in which SIGINT is not ignored
    "$@" > stdout 2> stderr < /dev/null &
    pid=$!
    set +m
    for ((i = 0; i < 3000; ++i)); do
        [ -z "$(find "$work" -path "$work/$file" -print -quit 2> /dev/null)" ] || break
        kill -0 "$pid" 2> /dev/null || break
        sleep 0.01
    done
    sleep "$delay"
    kill "-$signal" "$pid" 2> /dev/null || fail "$name: it ended before the signal: $(said)"
    wait "$pid"
    status=$?
    [ "$status" -eq 130 ] || fail "$name: expected exit status 130, got $status: $(said)"
    [ "$(grep -c '^scree: stopped' stderr)" -eq 1 ] || fail "$name: expected 'stopped', got: $(said)"
    left=$(staging)
    [ -z "$left" ] || fail "$name: left behind: $left"
    [ ! -e out ] || fail "$name: left the output folder behind"
    rm -rf out $left
}

for signal in INT TERM; do
    # The hidden folder comes before the survey, its first file with the pass that writes.
    for moment in "first '.*.scree-*' 0" "early '.*.scree-*' 0.5" "writing '.*.scree-*/*.exr' 0.1"; do
        eval "set -- $moment"
        interrupt "SIG$signal, $1" $signal "$2" "$3" -- "$scree" bake large/fractal.toml -o out
        interrupt "SIG$signal over a set, $1" $signal "$2" "$3" -- \
            "$scree" bake large/fractal.toml -o set
        expect_equal "the set after SIG$signal, $1" "$(fingerprint set)" "$first"
    done
    interrupt "SIG$signal in sample" $signal 'out/.*.scree-*' 0.2 -- \
        "$scree" sample fractal --size 4096 -o out
done

# A closed pipe is no reason to die by a signal.
checks=$((checks + 1))
"$scree" bake pair/fractal.toml -o out 2> stderr | true
status=${PIPESTATUS[0]}
[ "$status" -le 1 ] || fail "closed stdout: expected exit status 0 or 1, got $status: $(said)"
rm -rf out

finish
