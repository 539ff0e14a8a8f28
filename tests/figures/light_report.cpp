#include "figures/light_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/markdown.h"

namespace scree::test {
namespace {

constexpr size_t kBytesOfNumber = 2; ///< half floats

enum class Of { light, pairs };

const char* title(Of of)
{
    return of == Of::light ? "Light alone, seen from straight above" : "View and light together";
}

/// Mean of the squares, every pair of angles alike.
double mean_square(const SquaresOfPairs& squares, Of of)
{
    const size_t lights = judged_pairs().light_angles_deg.size();
    const auto straight_above = squares.begin() + static_cast<std::ptrdiff_t>(lights);
    const auto first = of == Of::light ? squares.begin() : straight_above;
    const auto last = of == Of::light ? straight_above : squares.end();
    double sum = 0;
    for (auto square = first; square != last; ++square)
        sum += *square;
    return sum / static_cast<double>(last - first);
}

/// Means over surfaces and slopes.
class Pool {
public:
    /// square, first  of a way, and of the way it is held against
    void add(double square, double first)
    {
        const double ratio = square / first;
        squares_ += square;
        ratios_ += ratio;
        largest_ = std::max(largest_, ratio);
        worse_ += ratio > 1 ? 1 : 0;
        ++count_;
    }
    [[nodiscard]] double rms() const { return std::sqrt(squares_ / count_); }
    [[nodiscard]] double rms_ratio() const { return std::sqrt(ratios_ / count_); }
    [[nodiscard]] double largest_ratio() const { return std::sqrt(largest_); }
    [[nodiscard]] std::string worse() const { return fmt::format("{} of {}", worse_, count_); }

private:
    double squares_ = 0, ratios_ = 0, largest_ = 0;
    int worse_ = 0, count_ = 0;
};

/// Ways that tell something of their own.
std::vector<size_t> ways_to_show(const std::vector<LightWayInfo>& ways, Of of)
{
    std::vector<size_t> shown;
    for (size_t w = 0; w < ways.size(); ++w)
        if (of == Of::pairs || ways[w].of_light_alone)
            shown.push_back(w);
    return shown;
}

std::vector<std::string> footprints(const std::vector<LightFigures>& all)
{
    std::vector<std::string> names;
    for (const LightFigures& surface : all)
        for (const LightSizeFigures& size : surface.sizes)
            if (std::find(names.begin(), names.end(), size.footprint) == names.end())
                names.push_back(size.footprint);
    return names;
}

std::string bytes(const LightWayInfo& way)
{
    return way.numbers ? std::to_string(kBytesOfNumber * *way.numbers) : "-";
}

void print_pooled(const std::vector<LightFigures>& all, Of of)
{
    const std::vector<LightWayInfo>& ways = all.front().ways;
    const std::vector<std::string> sizes = footprints(all);
    fmt::print("\n### {}\n\nError over that of {}: rms over {} surfaces and slopes / largest; of "
               "all, rms in % of the mean color, and how often worse than {}.\n\n",
               title(of), ways.front().name, all.size(), ways.front().name);
    print_head(joined(joined({"way", "bytes a texel"}, sizes), {"rms, %", "worse"}));
    for (const size_t w : ways_to_show(ways, of)) {
        std::vector<std::string> cells = {ways[w].name, bytes(ways[w])};
        Pool every;
        for (const std::string& name : sizes) {
            Pool of_size;
            for (const LightFigures& surface : all)
                for (const LightSizeFigures& size : surface.sizes)
                    if (size.footprint == name) {
                        const double square = mean_square(size.squares[w], of);
                        const double first = mean_square(size.squares.front(), of);
                        of_size.add(square, first);
                        every.add(square, first);
                    }
            cells.push_back(
                fmt::format("{:.3f} / {:.3f}", of_size.rms_ratio(), of_size.largest_ratio()));
        }
        print_row(joined(cells, {percent(every.rms()), every.worse()}));
    }
}

/// Root of the mean over surfaces, slopes and footprints of what `squares` takes of each.
template <typename Squares>
double root_of_mean(const std::vector<LightFigures>& all, Squares&& squares)
{
    double sum = 0;
    int count = 0;
    for (const LightFigures& surface : all)
        for (const LightSizeFigures& size : surface.sizes) {
            sum += squares(size);
            ++count;
        }
    return std::sqrt(sum / count);
}

void print_angles(const std::vector<LightFigures>& all)
{
    const LightPairs pairs = judged_pairs();
    fmt::print("\nBy angle of the view and of the light from the normal, rms over surfaces, slopes "
               "and footprints, in % of the mean color:\n\n");
    std::vector<std::string> head = {"way", "view"};
    for (const double angle : pairs.light_angles_deg)
        head.push_back(fmt::format("light {:g}", angle));
    print_head(head);
    const std::vector<LightWayInfo>& ways = all.front().ways;
    for (size_t w = 0; w < ways.size(); ++w)
        for (size_t view = 0; view < pairs.view_angles_deg.size(); ++view) {
            std::vector<std::string> cells = {ways[w].name,
                                              fmt::format("{:g}", pairs.view_angles_deg[view])};
            for (size_t light = 0; light < pairs.light_angles_deg.size(); ++light) {
                const size_t cell = view * pairs.light_angles_deg.size() + light;
                cells.push_back(percent(root_of_mean(
                    all, [&](const LightSizeFigures& size) { return size.squares[w][cell]; })));
            }
            print_row(cells);
        }
}

void print_surfaces(const std::vector<LightFigures>& all, Of of)
{
    const std::vector<LightWayInfo>& ways = all.front().ways;
    fmt::print("\nBy surface, rms over slopes and footprints, in % of the mean color; noise is the "
               "reference's own:\n\n");
    std::vector<std::string> head = {"surface"};
    for (const size_t w : ways_to_show(ways, of))
        head.push_back(ways[w].name);
    print_head(joined(head, {"noise"}));
    for (size_t first = 0; first < all.size();) {
        std::vector<LightFigures> slopes;
        while (first < all.size() && (slopes.empty() || all[first].surface == slopes[0].surface))
            slopes.push_back(all[first++]);
        std::vector<std::string> cells = {slopes.front().surface};
        for (const size_t w : ways_to_show(ways, of))
            cells.push_back(percent(root_of_mean(slopes, [&](const LightSizeFigures& size) {
                return mean_square(size.squares[w], of);
            })));
        cells.push_back(percent(root_of_mean(
            slopes, [&](const LightSizeFigures& size) { return mean_square(size.noise, of); })));
        print_row(cells);
    }
}

} // namespace

void print_light_figures(const std::vector<LightFigures>& all)
{
    for (const Of of : {Of::light, Of::pairs}) {
        print_pooled(all, of);
        print_surfaces(all, of);
    }
    print_angles(all);
}

} // namespace scree::test
