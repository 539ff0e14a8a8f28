// Nanoseconds per evaluation of the visible slopes: ours, the published nine integrals (mended) and
// the covariance alone, as LEAN-style shading takes it, side by side in one run.
//
//   scree_bench_kernel --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
//
// `scalar` calls a function that is not inlined, once for every footprint; `array` is a loop over
// arrays that the compiler may vectorise. All read the same 1024 random footprints.

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "bench/per_footprint.h"
#include "kernel/filter.h"
#include "kernel/published.h"

namespace {

using scree::bench::kCount;
using scree::bench::per_footprint;
using scree::test::Form;
using scree::test::PublishedResult;

/// Sigma 0.1 to 0.6, any correlation, views from 3 to 89 degrees, mean slopes to 0.5.
struct Footprints {
    std::array<std::vector<double>, 10> columns; // wx wy wz ms mt css cst ctt theta phi
    std::array<std::vector<float>, 10> floats;

    Footprints()
    {
        std::mt19937 random(3);
        const auto uniform = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
        };
        for (int i = 0; i < kCount; ++i) {
            const double theta = uniform(0.05, 1.55), phi = uniform(-3.14, 3.14);
            const double s = uniform(0.1, 0.6), t = uniform(0.1, 0.6), r = uniform(-0.9, 0.9);
            const std::array<double, 10> row = {std::sin(theta) * std::cos(phi),
                                                std::sin(theta) * std::sin(phi),
                                                std::cos(theta),
                                                uniform(-0.5, 0.5),
                                                uniform(-0.5, 0.5),
                                                s * s,
                                                r * s * t,
                                                t * t,
                                                theta,
                                                phi};
            for (size_t c = 0; c < row.size(); ++c) {
                columns[c].push_back(row[c]);
                floats[c].push_back(static_cast<float>(row[c]));
            }
        }
    }

    template <typename Real>
    const std::array<std::vector<Real>, 10>& as() const
    {
        if constexpr (std::is_same_v<Real, float>)
            return floats;
        else
            return columns;
    }
};

const Footprints& footprints()
{
    static const Footprints all;
    return all;
}

template <typename Real>
[[gnu::noinline]] scree::filter::VisibleSlopes<Real> ours(Real wx, Real wy, Real wz,
                                                          const scree::filter::Slopes<Real>& slopes)
{
    return scree::filter::visible_slopes<Real>({wx, wy, wz}, slopes);
}

template <typename Real>
void scalar_ours(benchmark::State& state)
{
    const auto& c = footprints().as<Real>();
    for (auto _ : state)
        for (size_t i = 0; i < kCount; ++i) {
            scree::filter::Slopes<Real> slopes;
            slopes.mean = {c[3][i], c[4][i]};
            slopes.covariance = {c[5][i], c[6][i], c[7][i]};
            benchmark::DoNotOptimize(ours<Real>(c[0][i], c[1][i], c[2][i], slopes));
        }
    per_footprint(state);
}

/// The same with K0 tails mixed in.
void scalar_ours_mixture(benchmark::State& state)
{
    const auto& c = footprints().as<float>();
    for (auto _ : state)
        for (size_t i = 0; i < kCount; ++i) {
            scree::filter::Slopes<float> slopes;
            slopes.mean = {c[3][i], c[4][i]};
            slopes.covariance = {c[5][i], c[6][i], c[7][i]};
            slopes.tau = 0.4F;
            benchmark::DoNotOptimize(ours<float>(c[0][i], c[1][i], c[2][i], slopes));
        }
    per_footprint(state);
}

[[gnu::noinline]] PublishedResult mended(double ms, double mt, double css, double cst, double ctt,
                                         double theta, double phi)
{
    return scree::test::published_visible_slopes(ms, mt, css, cst, ctt, theta, phi, Form::mended);
}

void scalar_published(benchmark::State& state)
{
    const auto& c = footprints().as<double>();
    for (auto _ : state)
        for (size_t i = 0; i < kCount; ++i)
            benchmark::DoNotOptimize(
                mended(c[3][i], c[4][i], c[5][i], c[6][i], c[7][i], c[8][i], c[9][i]));
    per_footprint(state);
}

struct LeanResult {
    float ss, st, tt;
};

[[gnu::noinline]] LeanResult lean(float s, float t, float ss, float st, float tt)
{
    return {ss - s * s, st - s * t, tt - t * t};
}

void scalar_lean(benchmark::State& state)
{
    const auto& c = footprints().as<float>();
    for (auto _ : state)
        for (size_t i = 0; i < kCount; ++i)
            benchmark::DoNotOptimize(lean(c[3][i], c[4][i], c[5][i], c[6][i], c[7][i]));
    per_footprint(state);
}

/// Columns of `count` numbers: 8 in, 6 out.
[[gnu::target_clones("avx2", "default")]] void
ours_over_arrays(const float* __restrict in, float* __restrict area, float* __restrict vs,
                 float* __restrict vt, float* __restrict vss, float* __restrict vst,
                 float* __restrict vtt, int count)
{
    for (int i = 0; i < count; ++i) {
        const float* at = in + i;
        float n = 0, s = 0, t = 0, ss = 0, st = 0, tt = 0;
        scree::kernel::scree_visible_slopes(at[0], at[count], at[2 * count], at[3 * count],
                                            at[4 * count], at[5 * count], at[6 * count],
                                            at[7 * count], 0.0F, n, s, t, ss, st, tt);
        area[i] = n;
        vs[i] = s;
        vt[i] = t;
        vss[i] = ss;
        vst[i] = st;
        vtt[i] = tt;
    }
}

void array_ours(benchmark::State& state)
{
    std::vector<float> in;
    for (size_t c = 0; c < 8; ++c)
        in.insert(in.end(), footprints().floats[c].begin(), footprints().floats[c].end());
    std::vector<float> out(6 * kCount);
    for (auto _ : state) {
        float* o = out.data();
        ours_over_arrays(in.data(), o, o + kCount, o + 2 * kCount, o + 3 * kCount, o + 4 * kCount,
                         o + 5 * kCount, kCount);
        benchmark::DoNotOptimize(o);
        benchmark::ClobberMemory();
    }
    per_footprint(state);
}

void array_published(benchmark::State& state)
{
    const auto& c = footprints().as<double>();
    std::vector<PublishedResult> out(kCount);
    for (auto _ : state) {
        for (size_t i = 0; i < kCount; ++i)
            out[i] = scree::test::published_visible_slopes(c[3][i], c[4][i], c[5][i], c[6][i],
                                                           c[7][i], c[8][i], c[9][i], Form::mended);
        benchmark::DoNotOptimize(out.data());
        benchmark::ClobberMemory();
    }
    per_footprint(state);
}

[[gnu::target_clones("avx2", "default")]] void lean_over_arrays(const float* __restrict in,
                                                                float* __restrict ss,
                                                                float* __restrict st,
                                                                float* __restrict tt, int count)
{
    for (int i = 0; i < count; ++i) {
        const float* at = in + i;
        const float s = at[3 * count], t = at[4 * count];
        ss[i] = at[5 * count] - s * s;
        st[i] = at[6 * count] - s * t;
        tt[i] = at[7 * count] - t * t;
    }
}

void array_lean(benchmark::State& state)
{
    std::vector<float> in;
    for (size_t c = 0; c < 8; ++c)
        in.insert(in.end(), footprints().floats[c].begin(), footprints().floats[c].end());
    std::vector<float> out(3 * kCount);
    for (auto _ : state) {
        lean_over_arrays(in.data(), out.data(), out.data() + kCount, out.data() + 2 * kCount,
                         kCount);
        benchmark::DoNotOptimize(out.data());
        benchmark::ClobberMemory();
    }
    per_footprint(state);
}

BENCHMARK(scalar_published);
BENCHMARK_TEMPLATE(scalar_ours, float);
BENCHMARK_TEMPLATE(scalar_ours, double);
BENCHMARK(scalar_ours_mixture);
BENCHMARK(scalar_lean);
BENCHMARK(array_published);
BENCHMARK(array_ours);
BENCHMARK(array_lean);

} // namespace

BENCHMARK_MAIN();
