#pragma once

#include <benchmark/benchmark.h>

namespace scree::bench {

/// Footprints of one iteration of every benchmark of the kernel.
constexpr int kCount = 1024;

/// Time per footprint, as a counter.
inline void per_footprint(benchmark::State& state)
{
    state.counters["per_footprint"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * kCount,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

} // namespace scree::bench
