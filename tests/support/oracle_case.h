#pragma once

#include <string>

#include "pipeline/options.h"
#include "reference/statistics.h"
#include "support/memory_source.h"

namespace scree::test {

/// One surface, for the baker and for brute force.
struct OracleCase {
    std::string title;
    reference::StatisticsInput input;
    BakeOptions options;

    MemorySource source() const;
};

/// Random heights (white noise on a slanted wave, so that neither mean nor covariance is 0), with
/// colors that follow height and slope; all numbers are exact in float.
OracleCase random_case(int width, int height, unsigned seed);

/// The same with some texels missing, singly, in lines and in blocks, and random weights.
OracleCase holes_case(int width, int height, unsigned seed);

void set_wrap(OracleCase& c, Wrap wrap_s, Wrap wrap_t);
void set_reconstruction(OracleCase& c, Reconstruction reconstruction);
void set_texel_size(OracleCase& c, double width, double height);

} // namespace scree::test
