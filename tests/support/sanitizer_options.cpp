// Defaults of the address sanitizer, so that any way of running the tests under it has them.

extern "C" const char* __asan_default_options(); // NOLINT: the name the sanitizer looks for

/// OpenImageIO and OpenColorIO keep what they allocate until the program ends, and
/// OpenImageIO 2.4 deletes its texture system through a pointer of another type.
extern "C" const char* __asan_default_options() // NOLINT
{
    return "detect_leaks=0:new_delete_type_mismatch=0";
}
