#pragma once

#include <cstdio>
#include <string>

#include "math/error.h"

namespace scree::test {

/// The main() of a program that prints figures: one word at most, the folder of the data; empty
/// where there is none.
template <class Run>
int run_with_data(int argc, char** argv, const Run& run)
{
    if (argc > 2) {
        std::fprintf(stderr, "usage: %s [DATA_FOLDER]\n", argv[0]);
        return 2;
    }
    try {
        run(std::string(argc == 2 ? argv[1] : ""));
    } catch (const Error& error) {
        std::fprintf(stderr, "%s: error: %s\n", argv[0], error.what());
        return 1;
    }
    return 0;
}

} // namespace scree::test
