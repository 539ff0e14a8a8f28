#pragma once

#include <string>
#include <vector>

#include "failures/failure_case.h"

namespace scree::test {

struct Result {
    FailureCase entry;
    Measured measured;
};

std::string verdict_name(Verdict verdict);

/// docs/failure-cases.md: an overview, and a section a case.
///
/// Throws Error when a number of maketx's is missing because there is none on PATH.
std::string page_of(const std::vector<Result>& results);

} // namespace scree::test
