#pragma once

#include <stdexcept>

namespace scree {

/// What went wrong at an edge of the program (a file, an option), in one line for the user:
/// what, where and what to do. Thrown by texset/ and pipeline/, caught once in main().
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The user asked to stop (Ctrl-C); whatever was being written is removed on the way out.
class Cancelled : public Error {
public:
    Cancelled() : Error("cancelled") {}
};

} // namespace scree
