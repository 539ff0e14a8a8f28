// Nanoseconds per evaluation of K0 slopes, beside the Gaussian ones: density, mean over a pixel,
// masking, samples. One by one, of functions that are not inlined, float; part of
// scree_bench_kernel.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "bench/per_footprint.h"
#include "kernel/k0.h"

namespace {

using scree::bench::kCount;
using scree::bench::per_footprint;
using Slopes = scree::filter::Slopes<float>;
using Vec2 = Imath::V2f;
using Vec3 = Imath::V3f;

/// A footprint, a view from 3 to 89 degrees, a slope within four deviations, random numbers.
struct Row {
    Slopes slopes;
    Vec3 view;
    Vec2 slope;
    float u[5];
};

const std::vector<Row>& rows()
{
    static const std::vector<Row> all = [] {
        std::vector<Row> out;
        std::mt19937 random(5);
        const auto uniform = [&](double low, double high) {
            return static_cast<float>(low + (high - low) *
                                                (static_cast<double>(random()) / 4294967296.0));
        };
        for (int i = 0; i < kCount; ++i) {
            const float theta = uniform(0.05, 1.55), phi = uniform(-3.14, 3.14);
            const float s = uniform(0.1, 0.6), t = uniform(0.1, 0.6), r = uniform(-0.9, 0.9);
            Row row;
            row.slopes = {{uniform(-0.5, 0.5), uniform(-0.5, 0.5)}, {s * s, r * s * t, t * t}, 0};
            row.view = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                        std::cos(theta)};
            row.slope = row.slopes.mean + Vec2(s * uniform(-2, 2), t * uniform(-2, 2));
            for (float& u : row.u)
                u = uniform(0, 1 - 1e-7);
            out.push_back(row);
        }
        return out;
    }();
    return all;
}

/// evaluate(row), for all rows.
template <typename F>
void over_rows(benchmark::State& state, const F& evaluate)
{
    const auto& all = rows();
    for (auto _ : state)
        for (const Row& row : all)
            benchmark::DoNotOptimize(evaluate(row));
    per_footprint(state);
}

[[gnu::noinline]] float gaussian_density(const Row& row)
{
    const auto& [ss, st, tt] = row.slopes.covariance;
    return scree::kernel::scree_slope_pdf(row.slope.x, row.slope.y, row.slopes.mean.x,
                                          row.slopes.mean.y, ss, st, tt);
}

[[gnu::noinline]] float k0_density(const Row& row)
{
    return scree::k0::slope_pdf(row.slope, row.slopes);
}

[[gnu::noinline]] float k0_pixel(const Row& row)
{
    return scree::k0::slope_pdf(row.slope, row.slopes, 0.3F);
}

[[gnu::noinline]] float gaussian_masking(const Row& row)
{
    return scree::filter::masking(row.view, row.slopes).g1;
}

[[gnu::noinline]] float k0_masking(const Row& row)
{
    return scree::k0::masking(row.view, row.slopes).g1;
}

[[gnu::noinline]] Vec2 k0_sample(const Row& row)
{
    const float u[3] = {row.u[0], row.u[1], row.u[2]};
    return scree::k0::sample(u, row.slopes);
}

[[gnu::noinline]] Vec2 k0_sample_visible(const Row& row)
{
    return scree::k0::sample_visible(row.u, row.view, row.slopes);
}

void scalar_gaussian_density(benchmark::State& state) { over_rows(state, gaussian_density); }
void scalar_k0_density(benchmark::State& state) { over_rows(state, k0_density); }
void scalar_k0_pixel(benchmark::State& state) { over_rows(state, k0_pixel); }
void scalar_gaussian_masking(benchmark::State& state) { over_rows(state, gaussian_masking); }
void scalar_k0_masking(benchmark::State& state) { over_rows(state, k0_masking); }
void scalar_k0_sample(benchmark::State& state) { over_rows(state, k0_sample); }
void scalar_k0_sample_visible(benchmark::State& state) { over_rows(state, k0_sample_visible); }

BENCHMARK(scalar_gaussian_density);
BENCHMARK(scalar_k0_density);
BENCHMARK(scalar_k0_pixel);
BENCHMARK(scalar_gaussian_masking);
BENCHMARK(scalar_k0_masking);
BENCHMARK(scalar_k0_sample);
BENCHMARK(scalar_k0_sample_visible);

} // namespace
