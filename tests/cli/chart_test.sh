# scree chart: what it reads and writes, its errors, and that it stops without a trace.
. "$(dirname "$0")/lib.sh"

mkdir tmp && export TMPDIR="$work/tmp"
small=(--size 32 --samples 4 --footprints 2)

expect_success "a sample" -- "$scree" chart sine "${small[@]}" -o out --svg
for words in 'naive MIP' 'rank 8' '1024 samples' 'noise of the truth' out/chart.html; do
    grep -q "$words" stdout || fail "chart: expected '$words' in: $(cat stdout)"
done
expect_equal "pictures" "$(ls out/*.svg | wc -l)" 16
expect_equal "numbers" "$(head -n 1 out/chart.csv | cut -d, -f1-3)" asset,band_deg,method
expect_equal "lines of numbers" "$(wc -l < out/chart.csv)" $((1 + 4 * 26))
grep -q '</html>' out/chart.html || fail "chart: no whole page"
grep -Eq 'src="http|href="http|<script' out/chart.html && fail "chart: the page needs a network"
expect_equal "left in the temporary folder" "$(ls tmp)" ""
rm -rf out

expect_success "two samples and a page of a name" -- "$scree" chart plane vgroove "${small[@]}" \
    -o deep/er/page.html --quiet
expect_equal "--quiet" "$(cat stdout stderr)" ""
expect_equal "files" "$(ls deep/er | tr '\n' ' ')" "page.csv page.html "
expect_equal "assets" "$(tail -n +2 deep/er/page.csv | cut -d, -f1 | sort -u | tr '\n' ' ')" \
    "plane vgroove "

"$scree" sample bricks --size 24 -o pair --quiet || fail "scree sample bricks"
expect_success "a recipe" -- "$scree" chart pair/bricks.toml "${small[@]}" -o from --quiet
expect_success "images" -- "$scree" chart --height pair/bricks.height.exr --height-scale 0.001 \
    --color pair/bricks.color.exr "${small[@]}" -o from --quiet
expect_equal "an image's name" "$(sed -n 2p from/chart.csv | cut -d, -f1)" bricks.height

expect_usage_error "no output" 'output' -- "$scree" chart sine
expect_usage_error "no such sample" "'marble'.*fractal.*--height" -- "$scree" chart marble -o out
expect_usage_error "no such recipe" 'gone\.toml: no such' -- "$scree" chart gone.toml -o out
expect_usage_error "color alone" '--height|height map' -- \
    "$scree" chart --color pair/bricks.color.exr -o out
expect_usage_error "one sample of truth" '--samples' -- "$scree" chart sine --samples 1 -o out
expect_usage_error "no roughness" '--base-alpha' -- "$scree" chart sine --base-alpha 0 -o out
grep -v '^name' pair/bricks.toml > pair/unnamed.toml
for twice in "sine sine" "bricks pair/bricks.toml" "pair/bricks.toml sine pair/bricks.toml" \
    "pair/unnamed.toml --height pair/bricks.height.exr"; do
    expect_usage_error "two of a name: $twice" "two assets are called '.*name = " -- \
        "$scree" chart $twice -o out
done
expect_error "no such image" 'gone\.exr: ' -- "$scree" chart --height gone.exr -o out
expect_error "too small" '3x3.*4x4' -- bash -c \
    '"$1" sample sine --size 3 -o tiny --quiet && exec "$1" chart tiny/sine.toml -o out' - "$scree"

expect_error "heights of the wrong scale" 'bricks\.height: heights range .*--height-scale' -- \
    "$scree" chart --height pair/bricks.height.exr --height-scale 1e6 -o out
mkdir -p taken/chart.csv
expect_error "a folder for the numbers" 'taken/chart\.csv: cannot be written: is a folder' -- \
    "$scree" chart --height gone.exr -o taken

timeout --preserve-status -s INT -k 5 1 "$scree" chart fractal --samples 512 -o out > stdout 2> stderr
expect_equal "exit status when stopped" $? 130
[ ! -e out ] || fail "stopped: left behind: $(ls out)"
expect_equal "left in the temporary folder when stopped" "$(ls tmp)" ""
finish
