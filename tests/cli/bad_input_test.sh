# Inputs a bake cannot use: missing, no image, cut short, of the wrong channels or sizes, claiming
# the absurd. Each ends with one line that says what and where, and leaves nothing.
. "$(dirname "$0")/lib.sh"
need oiiotool

bake=("$scree" bake -o out --height)
"$scree" sample fractal --size 96 -o pair --quiet || fail "scree sample fractal"
height=pair/fractal.height.exr
color=pair/fractal.color.exr

# --- not an image ---------------------------------------------------------------------------------
mkdir folder
: > empty.exr
printf 'heights are in the other file\n' > text.exr
printf 'heights are in the other file\n' > text.png
printf 'heights are in the other file\n' > no_suffix

expect_error "missing height" 'gone\.exr: no such file' -- "${bake[@]}" gone.exr
expect_error "missing color" 'gone\.png: no such file' -- "${bake[@]}" $height --color gone.png
expect_error "dangling link" 'link\.exr: no such file' -- \
    bash -c 'ln -s gone.exr link.exr; exec "$@"' - "${bake[@]}" link.exr
expect_error "a folder" 'folder: is a folder, expected an image' -- "${bake[@]}" folder
expect_error "a folder for color" 'folder: is a folder' -- "${bake[@]}" $height --color folder
expect_error "below a file" 'text\.png/x\.exr: ' -- "${bake[@]}" text.png/x.exr
expect_error "empty file" 'empty\.exr: the file is empty' -- "${bake[@]}" empty.exr
expect_error "empty device" '/dev/null: ' -- "${bake[@]}" /dev/null
expect_error "text named exr" 'text\.exr: cannot be read as an image' -- "${bake[@]}" text.exr
expect_error "text named png" 'text\.png: cannot be read as an image' -- "${bake[@]}" text.png
expect_error "no suffix" 'no_suffix: cannot be read as an image' -- "${bake[@]}" no_suffix
expect_error "color is text" 'text\.png: cannot be read' -- "${bake[@]}" $height --color text.png

# --- cut short ------------------------------------------------------------------------------------
# The header, the table of chunks, the pixels: a cut in each is noticed.
oiiotool $height --tile 32 32 -o tiled.exr -d uint16 --scanline -o whole.png \
    --compression zip -o whole.tif --tile 32 32 -o tiled.tif || fail "oiiotool: making images"
cp $height whole.exr
for file in whole.exr tiled.exr whole.png whole.tif tiled.tif; do
    size=$(stat -c %s "$file")
    suffix=${file##*.}
    expect_success "$file whole" -- "${bake[@]}" "$file"
    rm -rf out
    for length in 1 4 8 20 100 400 $((size / 4)) $((size / 2)) $((size * 9 / 10)) $((size - 40)); do
        head -c "$length" "$file" > "cut.$suffix"
        expect_error "$file cut to $length of $size bytes" "cut\.$suffix: .*" -- \
            "${bake[@]}" "cut.$suffix"
        [ "$length" -ge 100 ] || continue
        expect_error "$file as color, cut to $length of $size bytes" "cut\.$suffix: .*" -- \
            "${bake[@]}" $height --color "cut.$suffix"
    done
done

# --- channels -------------------------------------------------------------------------------------
oiiotool $color --ch R,G -o two.exr --ch R -o one.exr || fail "oiiotool: choosing channels"
expect_error "three channels for heights" \
    'color\.exr: 3 channels, expected 1 height channel; name one with --height-channel R' -- \
    "${bake[@]}" $color
expect_error "unknown channel" "color\.exr: no channel 'Z'; it has R,G,B; .*--height-channel" -- \
    "${bake[@]}" $color --height-channel Z
expect_error "channel number too high" "color\.exr: no channel '3'; it has R,G,B" -- \
    "${bake[@]}" $color --height-channel 3
expect_error "negative channel number" "color\.exr: no channel '-1'" -- \
    "${bake[@]}" $color --height-channel=-1
expect_error "two channels for color" 'two\.exr: 2 channels, expected R, G and B' -- \
    "${bake[@]}" $height --color two.exr
expect_error "normal map with one channel" \
    'one\.exr: 1 channels, expected the 3 of a normal map; .*--input normal' -- \
    "${bake[@]}" one.exr --input normal
expect_error "normal map with two channels" 'two\.exr: 2 channels, expected the 3 of a normal' -- \
    "${bake[@]}" two.exr --input normal
expect_error "no alpha to weight by" '--alpha-weight: no alpha channel in .*height\.exr' -- \
    "${bake[@]}" $height --alpha-weight
expect_success "a channel by name" -- "${bake[@]}" $color --height-channel G --quiet
rm -rf out
expect_success "a channel by number" -- "${bake[@]}" $color --height-channel 2 --quiet
rm -rf out

# --- numbers that are none ------------------------------------------------------------------------
pfm all_nan.pfm 5 3 "$nan"
pfm some_nan.pfm 4 1 "$one" "$nan" "$two" "$nan"
pfm flat.pfm 4 1 "$one"
expect_error "all NaN" 'all_nan\.pfm: .*no data' -- "${bake[@]}" all_nan.pfm
expect_error "all marked as no data" 'flat\.pfm: .*--no-data' -- "${bake[@]}" flat.pfm --no-data 1
expect_success "some NaN" -- "${bake[@]}" some_nan.pfm
expect_warning "some NaN" '2 texels .*not finite.* no data.*some_nan\.pfm, channel Y, texel \(1, 0\)'
expect_equal "texels without data" "$(manifest_value out no_data_texels)" 2
expect_equal "heights that count" "$(manifest_value out height_range)" '[1.0,2.0]'
rm -rf out
oiiotool pair/fractal.color.exr --resize 4x1 -o small.exr || fail "oiiotool --resize"
printf 'PF\n4 1\n-1.0\n' > nan_color.pfm
printf "$one$one$one$one$nan$one$one$one$one$one$one$one" >> nan_color.pfm
expect_success "NaN in the color" -- "${bake[@]}" flat.pfm --color nan_color.pfm
expect_warning "NaN in the color" '1 texels .*not finite.*nan_color\.pfm, channel G, texel \(1, 0\)'
expect_equal "texels without color" "$(manifest_value out no_data_texels)" 1
rm -rf out

# --- sizes ----------------------------------------------------------------------------------------
expect_error "sizes differ" \
    'fractal\.height\.exr is 96x96, small\.exr is 4x1; give maps of one size, or --resample' -- \
    "${bake[@]}" $height --color small.exr
expect_success "--resample" -- "${bake[@]}" $height --color small.exr --resample
expect_equal "size after --resample" "$(manifest_value out width)" 96
rm -rf out

finish
