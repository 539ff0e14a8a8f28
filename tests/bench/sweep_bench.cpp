// Nanoseconds a texel, azimuth and elevation of the visibility sweep, and of plain ways to the same
// numbers, side by side in one run.
//
//   scree_bench_sweep --benchmark_repetitions=5 --benchmark_report_aggregates_only=true

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "visibility/memory_heights.h"
#include "visibility/sweep.h"

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSize = 1024;

/// Hills of all sizes, rms slope 0.22, 92 texels from the lowest to the highest: at 86 degrees what
/// hides is up to 1300 texels away.
scree::MemoryHeights hills()
{
    std::mt19937 random(5);
    const auto uniform = [&] { return static_cast<double>(random()) * 0x1p-32; };
    std::vector<float> heights(static_cast<size_t>(kSize) * kSize);
    for (int i = 0; i < 12; ++i) {
        const double waves = std::pow(1.5, i);
        const double ks = std::round(waves * std::cos(2.4 * waves));
        const double kt = std::round(waves * std::sin(2.4 * waves));
        const double phase = uniform();
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                heights[static_cast<size_t>(y) * kSize + static_cast<size_t>(x)] +=
                    static_cast<float>(20 / waves *
                                       std::cos(2 * kPi * ((ks * x + kt * y) / kSize + phase)));
    }
    scree::HeightGrid::Shape shape;
    shape.width = shape.height = kSize;
    return {shape, heights};
}

const scree::MemoryHeights& grid()
{
    static const scree::MemoryHeights heights = hills();
    return heights;
}

/// 45, 65, 78 and 86 degrees.
std::vector<double> cotangents() { return {1, 0.46631, 0.21256, 0.069927}; }

void per_texel(benchmark::State& state, double texels)
{
    state.counters["per_texel"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * texels,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Of what was seen from the last azimuth: that ways agree.
double mean_of(const std::vector<std::vector<float>>& visible)
{
    double sum = 0;
    for (const auto& elevation : visible)
        for (const float v : elevation)
            sum += static_cast<double>(v);
    return sum / static_cast<double>(visible.size() * visible.front().size());
}

/// A block in the middle of the map, swept from 8 azimuths.
///
/// range  its width, height, near steps and lines a texel
void sweep_block(benchmark::State& state)
{
    const auto width = static_cast<int>(state.range(0)), height = static_cast<int>(state.range(1));
    const scree::TexelBlock block{(kSize - width) / 2, (kSize - height) / 2, width, height};
    scree::SweepOptions options;
    options.near_steps = static_cast<int>(state.range(2));
    options.lines_per_texel = static_cast<int>(state.range(3));
    const std::vector<double> nodes = cotangents();
    const auto texels = static_cast<size_t>(width) * static_cast<size_t>(height);
    std::vector<std::vector<float>> visible(nodes.size(), std::vector<float>(texels));
    std::vector<float*> rows(nodes.size());
    std::transform(visible.begin(), visible.end(), rows.begin(), [](auto& v) { return v.data(); });
    for (auto _ : state)
        for (int azimuth = 0; azimuth < 8; ++azimuth) {
            scree::sweep(grid(), block, (azimuth + 0.5) * kPi / 4, nodes, rows.data(), options);
            benchmark::DoNotOptimize(visible.back().data());
        }
    state.counters["mean"] = mean_of(visible);
    per_texel(state, static_cast<double>(texels * nodes.size() * 8));
}

// The plain ways get the heights in one array, and lines whose heights are read from it one at a
// time; they begin kBefore texels before the block and know of nothing beyond.

constexpr int kBefore = 128, kMargin = 1024;
constexpr int kWide = kSize + 2 * kMargin;

const std::vector<float>& wide_heights()
{
    static const std::vector<float> heights = [] {
        std::vector<float> all(static_cast<size_t>(kWide) * kWide);
        grid().read(0, -kMargin, -kMargin, kWide, kWide, all.data());
        return all;
    }();
    return heights;
}

struct Node {
    float away, height; ///< world units, away from the viewer
};

/// Heights along a line at the centres and edges of its places: fewer nodes than the sweep has.
///
/// place, position  of the first node, half a place before the first centre
void profile(bool along_s, int away, double place, double position, double shift, double length,
             std::vector<Node>& nodes)
{
    const float* heights = wide_heights().data();
    for (size_t n = 0; n < nodes.size(); ++n) {
        const double along = place + 0.5 * away * static_cast<double>(n);
        const double across = position + 0.5 * shift * static_cast<double>(n);
        const double s = (along_s ? along : across) + kMargin;
        const double t = (along_s ? across : along) + kMargin;
        const auto x = static_cast<int>(s), y = static_cast<int>(t);
        const auto u = static_cast<float>(s - x), v = static_cast<float>(t - y);
        const float* h = heights + static_cast<ptrdiff_t>(y) * kWide + x;
        const float above = h[0] + u * (h[1] - h[0]);
        const float below = h[kWide] + u * (h[kWide + 1] - h[kWide]);
        nodes[n] = {static_cast<float>(0.5 * length * static_cast<double>(n)),
                    above + v * (below - above)};
    }
}

/// Slope of the steepest sight from a node to those nearer to the viewer, by a hull of them that is
/// kept as they come: constant time a node on average.
class Hull {
public:
    void begin() { hull_.clear(); }
    float horizon_of(const Node& node)
    {
        const auto sight = [](const Node& from, const Node& to) {
            return (to.height - from.height) / (from.away - to.away);
        };
        while (hull_.size() > 1 &&
               sight(node, hull_.back()) <= sight(node, hull_[hull_.size() - 2]))
            hull_.pop_back();
        const float horizon = hull_.empty() ? -1e30F : sight(node, hull_.back());
        hull_.push_back(node);
        return horizon;
    }

private:
    std::vector<Node> hull_;
};

/// The same by looking at all of them.
class March {
public:
    void begin() { nodes_.clear(); }
    float horizon_of(const Node& node)
    {
        float horizon = -1e30F;
        const size_t first =
            nodes_.size() - std::min(nodes_.size(), 2 * static_cast<size_t>(kBefore));
        for (size_t i = first; i < nodes_.size(); ++i) {
            const float sight = (nodes_[i].height - node.height) / (node.away - nodes_[i].away);
            horizon = sight > horizon ? sight : horizon;
        }
        nodes_.push_back(node);
        return horizon;
    }

private:
    std::vector<Node> nodes_;
};

/// A block by the horizons of its nodes, each of which stands for half a step: not exact areas.
///
/// range  width and height
template <class Horizon>
void horizon_block(benchmark::State& state)
{
    const auto width = static_cast<int>(state.range(0)), height = static_cast<int>(state.range(1));
    const int x0 = (kSize - width) / 2, y0 = (kSize - height) / 2;
    const std::vector<double> nodes_at = cotangents();
    const auto texels = static_cast<size_t>(width) * static_cast<size_t>(height);
    std::vector<std::vector<float>> visible(nodes_at.size(), std::vector<float>(texels));
    Horizon horizon;
    std::vector<Node> nodes;
    for (auto _ : state)
        for (int azimuth = 0; azimuth < 8; ++azimuth) {
            const double ds = std::cos((azimuth + 0.5) * kPi / 4);
            const double dt = std::sin((azimuth + 0.5) * kPi / 4);
            const bool along_s = std::abs(ds) > std::abs(dt);
            const double along = along_s ? ds : dt, over = along_s ? dt : ds;
            const int away = along > 0 ? -1 : 1;
            const double length = 1 / std::abs(along), shift = -over * length;
            const int steps = along_s ? width : height, count = along_s ? height : width;
            const int low = along_s ? x0 : y0, from = along_s ? y0 : x0;
            const int first = away > 0 ? low : low + steps - 1;
            for (auto& v : visible)
                std::fill(v.begin(), v.end(), 0.0F);
            nodes.resize(2 * static_cast<size_t>(kBefore + steps) + 1);
            const int drift = static_cast<int>(std::ceil(std::abs(shift) * (steps - 1)));
            for (int line = shift > 0 ? -drift : 0; line < count + (shift > 0 ? 0 : drift);
                 ++line) {
                profile(along_s, away, first - (kBefore + 0.5) * away,
                        from + line + 0.2 - (kBefore + 0.5) * shift, shift, length, nodes);
                horizon.begin();
                for (size_t n = 0; n < nodes.size(); ++n) {
                    const float slope = horizon.horizon_of(nodes[n]);
                    const int step = (static_cast<int>(n) - 1) / 2 - kBefore;
                    const int place = low + (away > 0 ? step : steps - 1 - step);
                    const int position =
                        from + line + static_cast<int>(std::floor(0.7 + shift * step));
                    if (n == 0 || step < 0 || step >= steps || position < from ||
                        position >= from + count)
                        continue;
                    const int x = (along_s ? place : position) - x0;
                    const int y = (along_s ? position : place) - y0;
                    const auto texel = static_cast<size_t>(y) * static_cast<size_t>(width) +
                                       static_cast<size_t>(x);
                    const float rise = nodes[n].height - nodes[n - 1].height;
                    for (size_t k = 0; k < nodes_at.size(); ++k) {
                        const auto drop = static_cast<float>(nodes_at[k] * length);
                        const float area = 0.5F + rise / drop;
                        visible[k][texel] +=
                            slope < static_cast<float>(nodes_at[k]) && area > 0 ? area : 0;
                    }
                }
            }
            benchmark::DoNotOptimize(visible.back().data());
        }
    state.counters["mean"] = mean_of(visible);
    per_texel(state, static_cast<double>(texels * nodes_at.size() * 8));
}
BENCHMARK_TEMPLATE(horizon_block, Hull)->Args({512, 256})->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(horizon_block, March)->Args({64, 64})->Unit(benchmark::kMillisecond);

void blocks(benchmark::internal::Benchmark* bench)
{
    for (const int near : {64, 128, 256})
        for (const auto& [width, height] :
             {std::pair(128, 128), {256, 256}, {512, 256}, {1024, 256}, {1024, 1024}})
            bench->Args({width, height, near, 1});
    for (const int lines : {2, 4})
        bench->Args({512, 256, 256, lines});
}
BENCHMARK(sweep_block)->Apply(blocks)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
