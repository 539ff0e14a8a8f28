#!/usr/bin/env bash
# Times `scree bake` against `maketx --bumpslopes` and against the floor (tests/bench/floor.cpp) on
# the same 1/f noise (tests/bench/noise.cpp), and holds the result against the bounds of kBounds.
#
#   run_bake_bench.sh BUILD_DIR [WORK_DIR] [options]
#
#   BUILD_DIR                a release build: bake/scree, scree_noise and scree_floor
#   WORK_DIR                 where inputs, outputs and results go (default: mktemp -d); at 8192^2
#                            6 GB are in use at a time, at 16384^2 24 GB
#   --sizes "4096 8192"      powers of two
#   --runs 3                 counted runs, after one that is not
#   --types "float half auto"
#   --compressions "none zip"
#   --threads N              of all three programs (default: all cores)
#   --input-compression zip  or none, of the height map
#   --huge                   also scree_bench_synthetic 32768 (once, no warm-up)
#
# Programs take turns (A B C A B C ...), so that a change of the machine's load meets all of them.
# auto has no counterpart in maketx, and its floor writes the types scree chose. cpu is user +
# system; wall and cpu are medians, peak memory is the largest of the runs. About 0.2 s and 130 MB of
# each are the libraries that libOpenImageIO loads. Nothing is synced: what counts is handing the
# bytes to the kernel, and the output is deleted before it must reach the disk.
#
# Prints a table and WORK_DIR/bake_bench.csv.
# Exit status: 0 done, 1 failed or over a bound, 2 usage.
set -euo pipefail
export LC_ALL=C

usage() {
    sed -n '/^#   run_bake/,/^#   --huge/s/^# *//p' "$0" >&2
    exit 2
}
fail() {
    echo "run_bake_bench: error: $*" >&2
    exit 1
}

build="" work="" huge=no runs=3 threads=$(nproc)
sizes="4096 8192" types="float half auto" compressions="none zip" input_compression=zip
while [ $# -gt 0 ]; do
    case $1 in
        --sizes | --runs | --types | --compressions | --threads | --input-compression)
            [ $# -ge 2 ] || usage
            name=${1#--}
            printf -v "${name//-/_}" '%s' "$2"
            shift ;;
        --huge) huge=yes ;;
        -*) usage ;;
        *) if [ -z "$build" ]; then build=$1; elif [ -z "$work" ]; then work=$1; else usage; fi ;;
    esac
    shift
done
[ -n "$build" ] || usage
[[ $runs =~ ^[1-9][0-9]*$ && $threads =~ ^[1-9][0-9]*$ ]] || usage
for word in $types; do [[ $word =~ ^(float|half|auto)$ ]] || usage; done
for word in $compressions $input_compression; do [[ $word =~ ^(none|zip)$ ]] || usage; done

program() { # first of the places a build may have put it
    local place
    for place in "$build/bake/$1" "$build/tests/bench/$1" "$build/tests/$1"; do
        [ -f "$place" ] && [ -x "$place" ] && { realpath "$place"; return; }
    done
    fail "$1: not in $build/bake, tests/bench or tests; build the benchmark programs first"
}
[ -d "$build" ] || fail "$build: no such folder"
scree=$(program scree)
noise=$(program scree_noise)
floor=$(program scree_floor)
[ "$huge" = no ] || synthetic=$(program scree_bench_synthetic)
command -v maketx > /dev/null || fail "maketx: not found; install openimageio-tools"
[ -x /usr/bin/time ] || fail "/usr/bin/time: not found; install time"

[ -n "$work" ] || work=$(mktemp -d)
mkdir -p "$work"
work=$(realpath "$work")
data=$(mktemp -d "$work/bake_bench.XXXXXX")
trap 'rm -rf "$data"' EXIT
trap 'exit 130' INT TERM
csv=$work/bake_bench.csv

# --- what ran where ---------------------------------------------------------------------------
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt" 2> /dev/null || true; }
first_line() { "$@" 2> /dev/null | sed -n 1p; }

cores=$(nproc)
cpu=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed -n 1p)
compiler=$(first_line "$(cached CMAKE_CXX_COMPILER)" --version || echo unknown)
build_type=$(cached CMAKE_BUILD_TYPE)
here=$(dirname "$(realpath "$0")")
commit=$(git -C "$here" rev-parse --short HEAD 2> /dev/null || echo unknown)
[ "$commit" = unknown ] || [ -z "$(git -C "$here" status --porcelain)" ] || commit+=-dirty
maketx_version=$(maketx --help | sed -n 's/^OpenImageIO \([^ ]*\).*/\1/p')
background=$(awk '/^nr_dirty_background_threshold/ { printf "%d", $2 * 4096 / 1e6 }' /proc/vmstat)

cat << END
machine    $cores cores, $cpu; load $(cut -d' ' -f1-3 /proc/loadavg)
build      ${build_type:-unknown}, ${compiler:-unknown}, commit $commit
maketx     OpenImageIO $maketx_version
threads    $threads; median of $runs after a warm-up; input compression $input_compression
write-back starts at $background MB of dirty pages: larger outputs share the machine with the disk

END
[ "$cores" -ge "$threads" ] || echo "warning: more threads than cores" >&2
case $build_type in Release | RelWithDebInfo) ;; *) echo "warning: not a release build" >&2 ;; esac

# --- measuring --------------------------------------------------------------------------------
bake() { # INPUT TYPE COMPRESSION OUT
    "${timed[@]}" "$scree" bake --height "$1" -o "$4" --name bench --texel-size 1 \
        --maps slope,height --pixel-type "$2" --compression "$3" --threads "$threads" --quiet
}
run() { # PROGRAM INPUT TYPE COMPRESSION: one run into $data/out, a line to $data/PROGRAM.runs
    rm -rf "$data/out"
    local timed=(/usr/bin/time -q -f "%e %U %S %M" -o "$data/time") status=0
    case $1 in
        scree) bake "$2" "$3" "$4" "$data/out" ;;
        maketx)
            mkdir "$data/out"
            OPENIMAGEIO_OPTIONS="exr_threads=$threads" "${timed[@]}" \
                maketx --bumpslopes -d "$3" --compression "$4" --threads "$threads" "$2" \
                -o "$data/out/bench.exr" ;;
        floor)
            "${timed[@]}" "$floor" "$2" "$data/set" "$data/out" --compression "$4" \
                --threads "$threads" ;;
    esac > "$data/log" 2>&1 || status=$?
    if [ $status -ne 0 ]; then
        cat "$data/log" >&2
        fail "$1 failed (exit status $status) at $2, $3, $4"
    fi
    local bytes
    bytes=$(find "$data/out" -type f -printf '%s\n' | awk '{ n += $1 } END { printf "%.0f", n }')
    [ "${bytes:-0}" -gt 0 ] || fail "$1 wrote nothing at $2, $3, $4"
    echo "$(cat "$data/time") $bytes" >> "$data/$1.runs"
    rm -rf "$data/out"
}
summary() { # lines "wall user sys kb bytes" -> "wall min max cpu kb bytes"
    awk '
        function median(a, n,   i, j, t) {
            for (i = 2; i <= n; i++)
                for (j = i; j > 1 && a[j - 1] > a[j]; j--) {
                    t = a[j]; a[j] = a[j - 1]; a[j - 1] = t
                }
            return n % 2 ? a[(n + 1) / 2] : (a[n / 2] + a[n / 2 + 1]) / 2
        }
        { wall[NR] = $1 + 0; cpu[NR] = $2 + $3; if ($4 > kb) kb = $4; bytes = $5 }
        END { m = median(wall, NR); c = median(cpu, NR)
              printf "%.2f %.2f %.2f %.2f %d %.0f\n", m, wall[1], wall[NR], c, kb, bytes }' "$1"
}
record() { # SIZE TYPE COMPRESSION PROGRAM RUNS THREADS "wall min max cpu kb bytes"
    local wall low high cpu_s kb bytes
    read -r wall low high cpu_s kb bytes <<< "$7"
    printf '%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,"%s","%s",%s,%s,%s\n' "$1" "$2" "$3" "$4" \
        "$5" "$wall" "$low" "$high" "$cpu_s" "$kb" "$bytes" "$6" "$input_compression" "$cores" \
        "$cpu" "${compiler:-unknown}" "${build_type:-unknown}" "$commit" "$maketx_version" >> "$csv"
}

echo "size,pixel_type,compression,program,runs,wall_median_s,wall_min_s,wall_max_s,cpu_median_s,\
peak_kb,output_bytes,threads,input_compression,cores,cpu,compiler,build_type,commit,\
openimageio" > "$csv"

row='%-6s %-5s %-11s %-9s %8s  %-16s %8s %8s %9s %9s %9s\n'
# shellcheck disable=SC2059
header() {
    printf "$row" size type compression program "wall s" "(min..max)" "cpu s" "peak MB" \
        "output MB" "x floor" "x maketx"
}
show() { # SIZE TYPE COMPRESSION PROGRAM "summary" FLOOR_WALL MAKETX_WALL
    # shellcheck disable=SC2086
    set -- "$1" "$2" "$3" "$4" $5 "$6" "$7"
    # shellcheck disable=SC2059
    printf "$row" "$1" "$2" "$3" "$4" "$5" "($6..$7)" "$8" \
        "$(awk -v kb="$9" 'BEGIN { printf "%.0f", kb / 1000 }')" \
        "$(awk -v b="${10}" 'BEGIN { printf "%.1f", b / 1e6 }')" \
        "$(ratio "$5" "${11}")" "$(ratio "$5" "${12}")"
}
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { if (b > 0) printf "%.2f", a / b; else print "-" }'; }

header
for size in $sizes; do
    input=$data/input.exr
    "$noise" "$input" "$size" --type float --compression "$input_compression"
    for type in $types; do
        # What the floor writes.
        rm -rf "$data/set"
        timed=()
        bake "$input" "$type" none "$data/set" || fail "scree failed at $size, $type, none"
        programs="scree maketx floor"
        [ "$type" != auto ] || programs="scree floor"
        for compression in $compressions; do
            for ((i = 0; i <= runs; ++i)); do
                for p in $programs; do
                    run "$p" "$input" "$type" "$compression"
                    [ $i -gt 0 ] || rm "$data/$p.runs" # the warm-up
                done
            done
            declare -A found=([scree]="" [maketx]="" [floor]="")
            for p in $programs; do
                found[$p]=$(summary "$data/$p.runs")
                rm "$data/$p.runs"
                record "$size" "$type" "$compression" "$p" "$runs" "$threads" "${found[$p]}"
            done
            for p in $programs; do
                show "$size" "$type" "$compression" "$p" "${found[$p]}" "${found[floor]%% *}" \
                    "${found[maketx]%% *}"
            done
        done
    done
    rm -rf "$input" "$data/set"
done

if [ "$huge" = yes ]; then
    status=0
    (cd "$data" && TMPDIR=$data /usr/bin/time -q -f "%e %U %S %M 0" -o time \
        "$synthetic" 32768) > "$data/log" 2>&1 || status=$?
    [ $status -eq 0 ] || { cat "$data/log" >&2; fail "scree_bench_synthetic failed ($status)"; }
    result=$(summary "$data/time")
    record 32768 half - synthetic 1 "$cores" "$result"
    show 32768 half - synthetic "$result" "" ""
fi

# --- bounds -----------------------------------------------------------------------------------
echo
awk -F, -v sizes="$sizes" '
    NR == 1 { next }
    {
        key = $1 SUBSEP $2 SUBSEP $3 SUBSEP $4
        wall[key] = $6; kb[key] = $10; bytes[key] = $11
        if ($4 == "scree") order[++n] = $1 "," $2 "," $3
        if ($4 == "synthetic")
            huge = $10
    }
    function check(what, value, bound) {
        ++checks
        bad = !(value <= bound)
        failed += bad
        printf "%-5s %-46s %6.3f  bound %.2f\n", bad ? "OVER" : "ok", what, value, bound
    }
    END {
        # kBounds
        max_floor["none"] = 2.0;   max_floor["zip"] = 1.25
        max_maketx["none"] = 0.3;  max_maketx["zip"] = 1.0
        max_memory = 0.1           # of maketx, at 8192^2
        max_growth = 2.2           # peak at 8192^2 to peak at 4096^2
        max_huge_gb = 1.0

        for (i = 1; i <= n; i++) {
            split(order[i], c, ",")
            at = c[1] " " c[2] " " c[3]
            s = c[1] SUBSEP c[2] SUBSEP c[3] SUBSEP "scree"
            f = c[1] SUBSEP c[2] SUBSEP c[3] SUBSEP "floor"
            m = c[1] SUBSEP c[2] SUBSEP c[3] SUBSEP "maketx"
            small = 4096 SUBSEP c[2] SUBSEP c[3] SUBSEP "scree"
            # the same numbers; a better deflate may make them smaller
            check(at ": output, x floor", bytes[s] / bytes[f], 1.01)
            check(at ": wall, x floor", wall[s] / wall[f], max_floor[c[3]])
            if (m in wall)
                check(at ": wall, x maketx", wall[s] / wall[m], max_maketx[c[3]])
            if (c[1] == 8192 && m in kb)
                check(at ": peak memory, x maketx", kb[s] / kb[m], max_memory)
            if (c[1] == 8192 && small in kb)
                check(at ": peak memory, x that at 4096", kb[s] / kb[small], max_growth)
        }
        if (huge != "")
            check("32768 half: peak memory, GB", huge * 1024 / 1e9, max_huge_gb)
        printf "\n%d of %d checks over their bound\n", failed, checks
        exit (failed > 0 || checks == 0)
    }' "$csv" && status=0 || status=1
echo "results: $csv"
exit $status
