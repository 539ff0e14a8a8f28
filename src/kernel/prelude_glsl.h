// What GLSL (330 core, ES 300) needs to read scree_filter.h: put this file before it.

#ifndef SCREE_PRELUDE_GLSL
#define SCREE_PRELUDE_GLSL

#ifdef GL_ES // fragment shaders have no float by default, and integers of 16 bits
precision highp float;
precision highp int;
#endif

#define SCREE_FUNCTION
#define Real float
#define LIT(x) x
#define OUT(type, name) out type name

// The four functions are explained in prelude_cpp.h.

float scree_high_part(float x)
{
    return uintBitsToFloat((floatBitsToUint(x) + 0x800u) & 0xfffff000u);
}

// A test no compiler can decide: shifting the bits to and fro, Mesa 22.3 sees through. No number of
// the kernel has these bits; they are those of a NaN.
float scree_opaque(float x) { return floatBitsToUint(x) == 0x7fc5c4eeu ? 0.0 : x; }

float scree_exp2_minus_nearest(float x, out float n)
{
    int k = int(x + 0.5);
    n = float(k);
    return k <= 118 ? uintBitsToFloat(uint(127 - k) << 23u) : 0.0;
}

float scree_split(float x, out float n)
{
    int k = (floatBitsToInt(x) - 0x3f3504f3) >> 23;
    n = float(k);
    return intBitsToFloat(floatBitsToInt(x) - (k << 23));
}

#endif
