# Headers that claim no pixels or more than there can be: an error at once, without taking the
# memory or the time of the claim.
. "$(dirname "$0")/lib.sh"
need oiiotool

"$scree" sample plane --size 32 -o pair --quiet || fail "scree sample plane"
oiiotool pair/plane.height.exr --compression zip --tile 16 16 -o tiled.exr -d uint16 --scanline \
    -o plain.png --compression lzw -o plain.tif || fail "oiiotool: making images"
cp pair/plane.height.exr plain.exr

# What a claim may cost: 1 GiB of address space beyond the libraries', 10 seconds.
bake=(bash -c 'ulimit -v 2097152; exec timeout -k 1 10 "$@"' - "$scree" bake -o out --height)

# offset_of FILE TEXT: where the bytes of an attribute's name begin.
offset_of()
{
    grep -abo -- "$2" "$1" | head -n 1 | cut -d: -f1
}

# claim FILE NAME OFFSET BYTES WHAT: FILE with some header bytes changed must fail.
claim()
{
    local changed="changed.${1##*.}"
    cp "$1" "$changed"
    put "$changed" "$3" "$4"
    expect_error "$1: $2" "changed\.${1##*.}: " -- "${bake[@]}" "$changed"
    expect_error "$1 as color: $2" "changed\.${1##*.}: " -- "${bake[@]}" plain.exr \
        --color "$changed" --resample
}

zero='\0\0\0\0' minus_one='\377\377\377\377' most='\377\377\377\177'
million='\0\0\020\0' thirty_thousand='\060\165\0\0'
for file in plain.exr tiled.exr; do
    # "dataWindow" 0 "box2i" 0 size(4): 21 bytes before xmin, ymin, xmax, ymax.
    window=$(($(offset_of $file dataWindow) + 21))
    claim $file "zero width" $((window + 8)) "$minus_one"
    claim $file "negative height" $((window + 12)) '\360\377\377\377'
    claim $file "2^31 wide" $((window + 8)) "$most"
    claim $file "2^31 high" $((window + 12)) "$most"
    claim $file "2^31 square" $((window + 8)) "$most$most"
    claim $file "all of the plane" "$window" '\0\0\0\200\0\0\0\200'"$most$most"
    claim $file "a million wide and high" $((window + 8)) "$million$million"
    claim $file "30,000 square" $((window + 8)) "$thirty_thousand$thirty_thousand"
done
# "tiles" 0 "tiledesc" 0 size(4): 19 bytes before xsize and ysize.
tiles=$(($(offset_of tiled.exr tiledesc) + 13))
claim tiled.exr "tiles of no size" $tiles "$zero$zero"
claim tiled.exr "huge tiles" $tiles "$most$most"
claim tiled.exr "tiles of a million" $tiles "$million$million"

# PNG: IHDR's width and height at 16 and 20, big-endian, under a checksum that then fails; so with
# the checksum of the changed header as well.
claim plain.png "zero width" 16 "$zero"
claim plain.png "zero height" 20 "$zero"
claim plain.png "2^31 wide" 16 '\177\377\377\377'
claim plain.png "30,000 square, checksum right" 16 '\0\0\165\060\0\0\165\060\020\0\0\0\0\141\103\043\051'

# TIFF, little-endian: an entry is tag(2) type(2) count(4) value(4); 256 is the width, 257 the
# length, 278 the rows a strip, 277 the samples a pixel.
entry()
{
    LC_ALL=C grep -aboP "$1[\x03\x04]\x00\x01\x00\x00\x00" plain.tif | head -n 1 | cut -d: -f1
}
width=$(($(entry '\x00\x01') + 8)) length=$(($(entry '\x01\x01') + 8))
samples=$(($(entry '\x15\x01') + 8))
claim plain.tif "zero width" $width '\0\0'
claim plain.tif "zero height" $length '\0\0'
claim plain.tif "65535 wide" $width '\377\377'
claim plain.tif "65535 high" $length '\377\377'
claim plain.tif "no samples" $samples '\0\0'
claim plain.tif "65535 samples" $samples '\377\377'

# A size the decoder takes but this file cannot hold, and what a portable float map may say.
printf 'Pf\n0 0\n-1.0\n' > changed.pfm
expect_error "plain.pfm: zero size" 'changed\.pfm: ' -- "${bake[@]}" changed.pfm
printf 'Pf\n1000000 1000000\n-1.0\n' > changed.pfm
expect_error "plain.pfm: a million square" 'changed\.pfm: ' -- "${bake[@]}" changed.pfm
printf 'Pf\n-4 4\n-1.0\n' > changed.pfm
expect_error "plain.pfm: negative size" 'changed\.pfm: ' -- "${bake[@]}" changed.pfm

finish
