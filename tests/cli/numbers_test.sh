# What options with numbers refuse: one short line that says what was expected, exit status 2.
. "$(dirname "$0")/lib.sh"

# refuses EXPECTED VALUE -- COMMAND... OPTION WORD...: the error names the option, what it expects
# and the value.
refuses()
{
    local expected=$1 value=$2 option word
    shift 3
    for word; do
        case $word in --*) option=$word ;; esac
    done
    expect_usage_error "$*" \
        "^scree: error: $option: expected $expected, got '$value'; see scree $2 --help\$" -- "$@"
}

for value in nan inf -1 89.1 x ''; do
    refuses 'a number from 0 to 89' "$value" -- "$scree" validate set --view-angles "$value"
    refuses 'a number from 0 to 89' "$value" -- "$scree" preview set -o out.png --view-angle "$value"
    refuses 'a number from 0 to 89' "$value" -- "$scree" preview set -o out.png --strip-angles "$value"
done
for command in "validate set" "preview set -o out.png" "chart plane -o out"; do
    for value in nan 0 1.01 -inf; do
        refuses 'a number from 0.001 to 1' "$value" -- "$scree" $command --base-alpha "$value"
    done
    refuses 'a number from 0 to 1' nan -- "$scree" $command --f0 nan
    for value in -1 x nan 1e9; do
        refuses 'a whole number, 0 or more' "$value" -- "$scree" $command --threads "$value"
    done
done
for command in "validate set" "preview set -o out.png"; do
    refuses 'a number from 0 to 89' nan -- "$scree" $command --light nan 200
    refuses 'a number from 0 to 89' 200 -- "$scree" $command --light 200 60
    refuses 'a number' nan -- "$scree" $command --light 60 nan
done
for what in color radiance masking slope covariance statistics; do
    for value in 0 -1 nan inf x; do
        refuses 'a number above 0' "$value" -- "$scree" validate set --$what-tolerance "$value"
    done
done
refuses 'a number above 0' nan -- "$scree" preview set -o out.png --exposure nan
refuses 'a number' inf -- "$scree" preview set -o out.png --view-azimuth inf
refuses 'a number from 0.01 to 10000' nan -- "$scree" preview set -o out.png --repeats nan
refuses 'a whole number from 8 to 16384' 7 -- "$scree" preview set -o out.png --size 7 60
refuses 'a whole number from 8 to 16384' 16385 -- "$scree" preview set -o out.png --size 60 16385
refuses 'a whole number from 8 to 2048' 8.5 -- "$scree" preview set -o out.png --tile 8.5
refuses 'a whole number from 1 to 64' 0 -- "$scree" validate set --azimuths 0
refuses 'a whole number from 2 to 1024' 1 -- "$scree" chart plane -o out --samples 1
refuses 'a whole number, 1 or more' 0 -- "$scree" chart plane -o out --footprints 0
refuses 'a number' nan -- "$scree" chart --height heights.exr -o out --height-scale nan
refuses 'a whole number, 0 or more' -1 -- "$scree" bake --height heights.exr -o out --threads -1
for value in x nan; do
    refuses 'auto, or an angle in degrees' "$value" -- "$scree" bake --height heights.exr -o out --axes "$value"
done

for value in 0 2.5 -3 nan; do
    expect_usage_error "--nodes $value" \
        "^scree: error: --nodes $value: expected how many, 1 to 6, or their angles\$" -- \
        "$scree" bake --height heights.exr -o out --nodes "$value"
done
for value in 80,70 70,70 80,90 60,nan; do
    expect_usage_error "--nodes $value" '^scree: error: --nodes: .* expected rising angles' -- \
        "$scree" bake --height heights.exr -o out --nodes "$value"
done
expect_usage_error "seven nodes" '--nodes: 7 of them; must be 1 to 6' -- \
    "$scree" bake --height heights.exr -o out --nodes 10,20,30,40,50,60,70

# a recipe's numbers are held to the same
printf '[validate]\nradiance-tolerance = nan\n' > bad.toml
expect_usage_error "a tolerance that is no number" \
    "bad\.toml:2: radiance-tolerance: .*expected a number above 0, got 'nan'" -- \
    "$scree" validate set --recipe bad.toml

finish
