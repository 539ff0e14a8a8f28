# What a bake reads, and which numbers it finds there: pixel types and their normalisation, tiles
# and scan lines, channels, sizes down to one texel.
. "$(dirname "$0")/lib.sh"
need oiiotool

bake=("$scree" bake -o out --quiet --height)

# --- integers are [0, 1] before --height-scale, signed ones [-1, 1] --------------------------------
# half_and_half NAME TYPE: an image with 0 in its left half and the type's greatest value in the right.
half_and_half()
{
    oiiotool --pattern constant:color=0 8x4 1 --fill:color=1 4x4+4+0 -d "$2" -o "$1" ||
        fail "oiiotool: making $1"
}
for image in "a.png uint8" "b.png uint16" "c.tif uint8" "d.tif uint16" "e.tif uint32" \
    "f.exr half" "g.exr float" "h.tif float" "i.bmp uint8" "j.tga uint8"; do
    set -- $image
    half_and_half $1 $2
    expect_success "$2 in $1" -- "${bake[@]}" $1 --height-channel 0 --height-scale 3 \
        --height-offset=-1
    expect_equal "height range of $2 in $1" "$(manifest_value out height_range)" '[-1.0,2.0]'
    expect_equal "mean height of $2 in $1" "$(manifest_value out h0)" 0.5
    expect_equal "name of the set of $1" "$(manifest_value out name)" "\"${1%.*}\""
    rm -rf out
done
oiiotool g.exr --ch Y,Y,Y --chnames R,G,B -o hdr.hdr || fail "oiiotool: making hdr.hdr"
expect_success "rgbe" -- "${bake[@]}" hdr.hdr --height-channel 0
expect_equal "height range of rgbe" "$(manifest_value out height_range)" '[0.0,1.0]'
rm -rf out

# 32767 and 65535 of 16 bits: the step between neighbours is 1/65535 of the scale.
expect_success "the step of 16 bits" -- "${bake[@]}" b.png --height-scale 65535
expect_equal "the step of 16 bits" "$(manifest_value out height_quantum)" 1.0
expect_equal "bits of 16 bits" "$(manifest_value out height_bits)" 16
rm -rf out

# --- the same pixels give the same numbers in any arrangement --------------------------------------
"$scree" sample fractal --size 100 70 -o pair --quiet || fail "scree sample fractal"
source=pair/fractal.height.exr
expect_success "scan lines" -- "${bake[@]}" $source
want="$(manifest_value out h0) $(manifest_value out h1) $(manifest_value out rms_slope)"
rm -rf out
oiiotool $source --tile 16 16 -o tiles.exr --tile 64 32 -o wide.exr --compression piz -o piz.exr \
    --scanline --compression none -o none.exr -o plain.tif --compression zip -o zip.tif \
    --compression lzw -o lzw.tif --tile 32 16 -o tiles.tif || fail "oiiotool: copies"
for file in tiles.exr wide.exr piz.exr none.exr plain.tif zip.tif lzw.tif tiles.tif; do
    expect_success "$file" -- "${bake[@]}" $file
    expect_equal "statistics of $file" \
        "$(manifest_value out h0) $(manifest_value out h1) $(manifest_value out rms_slope)" "$want"
    rm -rf out
done
# MIP levels and other parts: the finest and the first count.
oiiotool $source --tile 32 32 -otex mip.exr || fail "oiiotool -otex"
expect_success "a MIP-mapped texture" -- "${bake[@]}" mip.exr
expect_equal "h0 of a MIP-mapped texture" "$(manifest_value out h0)" "${want%% *}"
rm -rf out

# --- sizes -----------------------------------------------------------------------------------------
for size in 1x1 1x7 7x1 2x2 3x3 63x1 1x65; do
    width=${size%x*} height=${size#*x}
    pfm "$size.pfm" "$width" "$height" "$two"
    for wrap in periodic clamp mirror black; do
        case $wrap in
        clamp) reconstruction=sobel ;;
        mirror) reconstruction=central ;;
        *) reconstruction=bilinear ;;
        esac
        expect_success "$size $wrap $reconstruction" -- "${bake[@]}" $size.pfm --wrap $wrap \
            --reconstruction $reconstruction
        expect_equal "$size $wrap: height range" "$(manifest_value out height_range)" '[2.0,2.0]'
        expect_equal "$size $wrap: size" \
            "$(manifest_value out width)x$(manifest_value out height)" "$size"
        rm -rf out
    done
    expect_success "$size bumpslopes" -- "${bake[@]}" $size.pfm --layout bumpslopes
    rm -rf out
    expect_success "$size with color" -- "${bake[@]}" $size.pfm --color $size.pfm
    rm -rf out
done

finish
