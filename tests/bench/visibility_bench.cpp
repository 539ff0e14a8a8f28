// Nanoseconds per visible color from visibility tables of four nodes, by the number of harmonics
// (-1: along axes); part of scree_bench_kernel. A function that is not inlined is called for every
// one of 1024 tables, views from 3 to 89 degrees.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "bench/per_footprint.h"
#include "kernel/visibility_table.h"

namespace {

using Imath::V3f;
using scree::bench::kCount;

constexpr int kNodes = 4;

struct Tables {
    std::vector<float> values;
    std::vector<V3f> colors, views, lights;
    float cosines[kNodes];
    int harmonics; ///< -1: along axes

    explicit Tables(int count) : harmonics(count)
    {
        std::mt19937 random(5);
        const auto uniform = [&](double low, double high) {
            return static_cast<float>(low +
                                      (high - low) * static_cast<double>(random()) / 4294967296.0);
        };
        const auto direction = [&] {
            const float theta = uniform(0.05, 1.55), phi = uniform(-3.14, 3.14);
            return V3f(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                       std::cos(theta));
        };
        for (int k = 0; k < kNodes; ++k)
            cosines[k] = std::cos(0.39F * static_cast<float>(k + 1));
        for (int i = 0; i < kCount; ++i) {
            colors.emplace_back(uniform(0.1, 0.9), uniform(0.1, 0.9), uniform(0.1, 0.9));
            views.push_back(direction());
            lights.push_back(direction());
            for (size_t n = 0; n < stride(); ++n)
                values.push_back(uniform(-0.2, 0.3));
        }
    }

    size_t stride() const
    {
        return 4 * kNodes * (harmonics < 0 ? 5 : 1 + 2 * static_cast<size_t>(harmonics));
    }

    scree::filter::VisibilityTable<float> at(size_t i) const
    {
        const float* of_table = values.data() + i * stride();
        if (harmonics < 0)
            return {of_table, cosines, kNodes, 0, true, 0.8F, 0.6F};
        return {of_table, cosines, kNodes, harmonics};
    }
};

[[gnu::noinline]] V3f seen(const V3f& color, const scree::filter::VisibilityTable<float>& table,
                           const V3f& w)
{
    return scree::filter::visible_color(color, table, w);
}

void visible_color(benchmark::State& state)
{
    const Tables tables(static_cast<int>(state.range(0)));
    for (auto _ : state)
        for (size_t i = 0; i < kCount; ++i)
            benchmark::DoNotOptimize(seen(tables.colors[i], tables.at(i), tables.views[i]));
    scree::bench::per_footprint(state);
}

[[gnu::noinline]] V3f seen_and_lit(const V3f& color,
                                   const scree::filter::VisibilityTable<float>& table,
                                   const V3f& view, const V3f& light)
{
    return scree::filter::color_seen_and_lit(
        color, scree::filter::visible_color(color, table, view),
        scree::filter::visible_color(color, table, light), view, light);
}

void color_seen_and_lit(benchmark::State& state)
{
    const Tables tables(static_cast<int>(state.range(0)));
    for (auto _ : state)
        for (size_t i = 0; i < kCount; ++i)
            benchmark::DoNotOptimize(
                seen_and_lit(tables.colors[i], tables.at(i), tables.views[i], tables.lights[i]));
    scree::bench::per_footprint(state);
}

BENCHMARK(visible_color)->ArgName("harmonics")->DenseRange(-1, 2);
BENCHMARK(color_seen_and_lit)->ArgName("harmonics")->DenseRange(-1, 2);

} // namespace
