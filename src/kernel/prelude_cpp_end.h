// Takes back the macros of prelude_cpp.h, and gives their names what they had before it.

#undef SCREE_FUNCTION
#undef LIT
#undef OUT
#pragma pop_macro("OUT")
#pragma pop_macro("LIT")
