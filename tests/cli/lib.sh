# Helpers of the command-line tests; each starts with  . "$(dirname "$0")/lib.sh"
#
# A test runs as  bash NAME_test.sh PROGRAM REPO  in a folder of its own, $work, that goes when it
# ends. It reports every expectation that did not hold and ends with `finish`: exit 0 pass, 1 fail,
# 77 skipped.

set -u
[ $# -eq 2 ] || { echo "usage: bash $0 PROGRAM REPO" >&2; exit 2; }
scree=$(realpath "$1")
repo=$(realpath "$2")
work=$(mktemp -d)
failures=0
checks=0
unset OCIO

on_exit=() # commands to run before $work goes: unmounting, say
clean_up()
{
    local command
    cd /
    for command in "${on_exit[@]}"; do
        eval "$command"
    done
    rm -rf "$work"
}
trap clean_up EXIT
cd "$work" || exit 1

fail()
{
    failures=$((failures + 1))
    printf 'FAIL %s\n' "$*" >&2
}

skip_part()
{
    printf 'skipped: %s\n' "$*"
}

skip_all()
{
    printf 'skipped: %s\n' "$*"
    exit 77
}

finish()
{
    printf '%d checks, %d failures\n' "$checks" "$failures"
    [ "$checks" -gt 0 ] || { echo "nothing was checked" >&2; exit 1; }
    [ "$failures" -eq 0 ]
    exit
}

# need PROGRAM...: skips the test where one is missing.
need()
{
    local program
    for program; do
        command -v "$program" > /dev/null || skip_all "$program is not installed"
    done
}

# run COMMAND...: leaves its exit status in $status, its output in the files stdout and stderr.
run()
{
    checks=$((checks + 1))
    timeout -k 5 60 "$@" > "$work/stdout" 2> "$work/stderr" < /dev/null
    status=$?
}

# What the last command said on stderr, without its progress, for messages.
said()
{
    grep -Ev '^scree: [a-z]+ [0-9]+ %$' "$work/stderr" | head -c 500
}

# What a bake may leave behind by mistake, anywhere below $work.
staging()
{
    find "$work" -name '.*.scree-*'
}

# What stands in a folder, with its contents and links, as one number.
fingerprint()
{
    (cd "$1" && find . -print0 | sort -z | while IFS= read -r -d '' path; do
        printf '%s %s\n' "$path" "$(readlink "$path")"
        [ ! -f "$path" ] || sha256sum < "$path"
    done | sha256sum)
}

# expect_failure STATUS NAME PATTERN -- COMMAND...
# The command ends with STATUS, one error line that matches the extended regular expression
# PATTERN, no output folder ./out and nothing staged.
expect_failure()
{
    local want=$1 name=$2 pattern=$3 lines left
    shift 4
    run "$@"
    [ "$status" -eq "$want" ] ||
        fail "$name: expected exit status $want, got $status: $(said)"
    lines=$(grep -c '^scree: error: ' stderr)
    [ "$lines" -eq 1 ] ||
        fail "$name: expected one error line, got $lines: $(said)"
    grep '^scree: error: ' stderr | grep -Eq -- "$pattern" ||
        fail "$name: expected an error that matches '$pattern', got: $(said)"
    left=$(staging)
    [ -z "$left" ] || fail "$name: left behind: $left"
    [ ! -e out ] || fail "$name: left the output folder behind: $(ls out)"
    rm -rf out
}

# expect_error NAME PATTERN -- COMMAND...: the work fails.
expect_error()
{
    expect_failure 1 "$@"
}

# expect_usage_error NAME PATTERN -- COMMAND...: the command makes no sense.
expect_usage_error()
{
    expect_failure 2 "$@"
}

# expect_success NAME -- COMMAND...: the command succeeds and leaves nothing staged.
expect_success()
{
    local name=$1 left
    shift 2
    run "$@"
    [ "$status" -eq 0 ] || fail "$name: expected exit status 0, got $status: $(said)"
    left=$(staging)
    [ -z "$left" ] || fail "$name: left behind: $left"
}

# expect_warning NAME PATTERN: of the last command.
expect_warning()
{
    grep '^scree: warning: ' "$work/stderr" | grep -Eq -- "$2" ||
        fail "$1: expected a warning that matches '$2', got: $(said)"
}

# expect_equal NAME GOT EXPECTED
expect_equal()
{
    checks=$((checks + 1))
    [ "$2" = "$3" ] || fail "$1: expected '$3', got '$2'"
}

# manifest_value SET KEY: the first value of that key in the manifest, a list on one line.
manifest_value()
{
    cat "$1"/*.scree.json | tr -d '\n ' | grep -oE "\"$2\":(\[[^]]*\]|\"[^\"]*\"|[^,}]*)" |
        head -n 1 | cut -d: -f2-
}

# put FILE OFFSET BYTES: overwrites bytes of a file; BYTES as printf understands them.
put()
{
    printf "$3" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}

# pfm FILE WIDTH HEIGHT WORD...: a little-endian float image, its one word repeated or one word a
# pixel, such as '\0\0\200\077' for 1.
one='\0\0\200\077' two='\0\0\0\100' nan='\0\0\300\177'
pfm()
{
    local file=$1 width=$2 height=$3 word i
    shift 3
    {
        printf 'Pf\n%d %d\n-1.0\n' "$width" "$height"
        if [ $# -gt 1 ]; then
            for word; do printf "$word"; done
        else
            for ((i = 0; i < width * height; ++i)); do printf "$1"; done
        fi
    } > "$file"
}
