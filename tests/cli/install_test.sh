#!/bin/bash
# What `cmake --install` puts in place is enough: the tool runs from there, and a project of its own
# finds the library, builds and bakes with it.
. "$(dirname "$0")/lib.sh"
need cmake c++

build=$(dirname "$(dirname "$scree")")
[ -f "$build/CMakeCache.txt" ] || skip_all "$build is no build directory"
prefix=$work/prefix

# cached NAME: a variable of the build.
cached()
{
    sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"
}
flags=$(cached CMAKE_CXX_FLAGS) # those of a sanitizer, say: the consumer must link alike

expect_success "install" -- cmake --install "$build" --prefix "$prefix"
rm -rf "$work/moved" && mv "$prefix" "$work/moved" && prefix=$work/moved # packages are relocatable

# --- the tool ------------------------------------------------------------------------------------

tool=$prefix/bin/scree
expect_success "the installed tool tells its version" -- "$tool" --version
expect_success "the installed tool makes a sample" -- "$tool" sample plane -o sample --quiet
height=sample/plane.height.exr
expect_success "the installed tool bakes" -- "$tool" bake --height "$height" -o out --quiet
[ -n "$(find out -name '*.scree.json')" ] || fail "the installed tool left no manifest"
for recipe in "$prefix"/share/scree/configs/*.toml; do
    expect_success "the installed recipe $(basename "$recipe")" -- \
        "$tool" bake "$recipe" --height "$height" \
        --color sample/plane.color.exr --texel-size 1 -o out --quiet
done

for shader in scree_surface.osl scree_raw.osl scree_set_osl.h scree_set.glsl scree_visible.glsl \
              scree_plane.frag; do
    [ -f "$prefix/share/scree/shaders/$shader" ] || fail "the shader $shader is not installed"
done
if [ -x "${OSL_ROOT:-}/bin/oslc" ]; then
    expect_success "the installed shader compiles" -- "$OSL_ROOT/bin/oslc" \
        "-I$prefix/include/scree" "$prefix/share/scree/shaders/scree_surface.osl"
fi

# --- a project that uses the library -------------------------------------------------------------

expect_success "configure the consumer" -- cmake -S "$repo/tests/consumer" -B consumer \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="$flags"
[ "$status" -eq 0 ] || finish
grep -q "$prefix" consumer/CMakeCache.txt || fail "the consumer found another scree"
expect_success "build the consumer" -- cmake --build consumer
expect_success "run the consumer" -- consumer/consumer consumed
grep -qx 'plane 40x24, 6 levels, slope 0.500000 -0.250000' stdout ||
    fail "the consumer printed: $(cat stdout)"
grep -qx 'shaded 0.139' stdout || fail "the consumer shaded: $(cat stdout)"
expect_success "the tool reads what the consumer baked" -- "$tool" info consumed

# A consumer sees nothing of the source tree or the build tree.
if grep -rl -e "$repo/src" -e "$build" "$prefix/lib" --include='*.cmake' > leaks; then
    fail "files that name the build: $(cat leaks)"
fi

# Every header can be included, and leaves nothing out. The kernel's text and its preludes are read
# through filter.h, or by another language.
headers=$(cd "$prefix/include/scree" && find . -name '*.h' | sed 's|^\./||' |
    grep -Ev '^kernel/(scree_filter|prelude_[a-z]+)\.h$' | sort)
[ -n "$headers" ] || fail "no headers are installed"
for header in $headers; do
    printf '#include <%s>\n' "$header"
done > all.cpp
expect_success "include every header" -- c++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only \
    -I "$prefix/include/scree" all.cpp

finish
