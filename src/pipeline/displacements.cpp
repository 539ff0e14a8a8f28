#include "pipeline/displacements.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace scree {

namespace {

/// Of a float's 23 bits behind its exponent, 4 tell one bin from the next: they rise as it does.
constexpr int kDropped = 19;
constexpr size_t kBins = size_t{1} << (31 - kDropped);

size_t bin_of(float x)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits >> kDropped;
}

float end_of(size_t bin)
{
    const auto bits = static_cast<uint32_t>((bin + 1) << kDropped);
    float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

} // namespace

Displacements::Displacements() : areas_(kBins) {}

void Displacements::clear() { *this = {}; }

void Displacements::add(float displacement, float area, int x, int y)
{
    if (!(displacement >= 0)) // no height, no displacement
        return;
    areas_[bin_of(displacement)] += static_cast<double>(area);
    if (displacement > largest_) {
        largest_ = displacement;
        place_ = {x, y};
    }
}

double Displacements::quantile(double share) const
{
    double total = 0;
    for (const double area : areas_)
        total += area;
    double below = 0;
    for (size_t bin = 0; bin < kBins && total > 0; ++bin) {
        below += areas_[bin];
        if (below >= share * total)
            return static_cast<double>(std::min(end_of(bin), largest_));
    }
    return 0;
}

} // namespace scree
