// What OSL needs to read scree_filter.h: include this file before it.

#ifndef SCREE_PRELUDE_OSL
#define SCREE_PRELUDE_OSL

#define SCREE_FUNCTION
#define Real float
#define LIT(x) x
#define OUT(type, name) output type name

// The four functions are explained in prelude_cpp.h.

// OSL sees no bits; 4097 = 2^12 + 1, Veltkamp's splitting. Above 1e34 a number is its own high
// part: the product would overflow.
float scree_high_part(float x)
{
    float shifted = 4097.0 * x;
    return abs(x) < 1e34 ? shifted - (shifted - x) : x;
}

// OSL has no bits to look at; no number of the kernel reaches 1e38.
float scree_opaque(float x) { return x < 1e38 ? x : 0.0; }

// exp2 of an integer is exact, with OSL's fast mathematics too.
float scree_exp2_minus_nearest(float x, output float n)
{
    n = trunc(x + 0.5);
    return n <= 118.0 ? exp2(-n) : 0.0;
}

// However roughly OSL takes log2: n only chooses, and the product is exact.
float scree_split(float x, output float n)
{
    n = floor(log2(x) + 0.5);
    return x * exp2(-n);
}

#endif
