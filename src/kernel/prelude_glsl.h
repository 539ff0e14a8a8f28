// What GLSL (330 core, ES 300) needs to read scree_filter.h: put this file before it. ES shaders
// say `precision highp float;` first.

#ifndef SCREE_PRELUDE_GLSL
#define SCREE_PRELUDE_GLSL

#define SCREE_FUNCTION
#define Real float
#define LIT(x) x
#define OUT(type, name) out type name

// The four functions are explained in prelude_cpp.h.

float scree_high_part(float x) { return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u); }

float scree_opaque(float x)
{
    uint bits = floatBitsToUint(x);
    return uintBitsToFloat(((bits >> 1u) << 1u) | (bits & 1u));
}

float scree_exp2_minus(float k) { return uintBitsToFloat(uint(127 - min(int(k), 127)) << 23u); }

float scree_truncate(float x) { return trunc(x); }

#endif
