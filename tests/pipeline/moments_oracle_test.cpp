// Every statistic of every texel of every level, in double, against brute force from level 0.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "pipeline/moment_pyramid.h"
#include "pipeline/strip.h"
#include "pipeline/survey.h"
#include "stats/kurtosis.h"
#include "support/oracle_case.h"
#include "support/truth.h"

namespace scree::test {
namespace {

/// Everything a baker can carry, of all texels, copied as the pyramid makes it.
class Recorder : public TexelVisitor {
public:
    explicit Recorder(const MomentLayout& layout, int width, int height) : layout_(layout)
    {
        for (int l = 0; l < level_count(width, height); ++l)
            levels_.emplace_back(std::max(1, width >> l), std::max(1, height >> l), layout.planes);
    }

    void texels(int level, int y, int x0, int count, MomentRow row) override
    {
        Level& to = levels_[static_cast<size_t>(level)];
        for (int plane = 0; plane < layout_.planes; ++plane)
            for (int x = 0; x < count; ++x)
                *to.row(y).from(x0 + x).plane(plane) = row.plane(plane)[x];
    }

    int levels() const { return static_cast<int>(levels_.size()); }
    MomentRow row(int level, int y) { return levels_[static_cast<size_t>(level)].row(y); }

private:
    struct Level {
        Level(int w, int h, int p)
            : width(w), planes(p),
              data(static_cast<size_t>(w) * static_cast<size_t>(h) * static_cast<size_t>(p))
        {}
        MomentRow row(int y)
        {
            return {data.data() + static_cast<ptrdiff_t>(y) * width * planes, width};
        }
        int width, planes;
        std::vector<double> data;
    };
    MomentLayout layout_;
    std::vector<Level> levels_;
};

MomentLayout everything(bool heights, bool colors)
{
    MomentSet set;
    set.slope = set.tail = true;
    set.height = heights;
    set.color = set.color_slope = set.color_height = colors;
    return MomentLayout(set);
}

/// Differences relative to the largest value of that kind in this level and the finer ones.
class Comparison {
public:
    Comparison(const OracleCase& c, double tolerance) : case_(c), tolerance_(tolerance) {}

    void run()
    {
        const Truth truth = brute_force(case_.input);
        MemorySource source = case_.source();
        const Survey found = survey(source, {});
        const MomentLayout layout = everything(source.has_heights(), source.has_color());
        const TexelMoments texels(layout, found, case_.options, nullptr, source.width(),
                                  case_.input.relief.texel_width, case_.input.relief.texel_height);
        Recorder recorder(layout, source.width(), source.height());
        MomentPyramid pyramid(layout, source.width(), source.height(), {&recorder});
        StripReader strips(source, found, case_.options, nullptr, true);
        Strip strip;
        while (strips.next(strip))
            pyramid.push(strip.count, [&](int y, int x0, int count, MomentRow row) {
                texels.fill(strip, y, x0, count, row);
            });

        ASSERT_EQ(static_cast<int>(truth.levels.size()), recorder.levels()) << case_.title;
        if (source.has_heights()) {
            EXPECT_NEAR(found.h0, truth.h0, 1e-12 * truth.h1) << case_.title;
            EXPECT_NEAR(found.h1, truth.h1, 1e-12 * truth.h1) << case_.title;
        }
        for (int l = 0; l < recorder.levels(); ++l)
            compare_level(layout, recorder, l, truth.levels[static_cast<size_t>(l)]);
    }

private:
    using Values = std::map<std::string, std::pair<double, double>>; // ours, truth

    static Values values_of(const MomentLayout& layout, MomentRow row, int x,
                            const reference::Texel& truth)
    {
        auto ours = [&](int plane) { return row.plane(plane)[x]; };
        Values v;
        v["1 coverage"] = {ours(MomentLayout::weight), static_cast<double>(truth.coverage)};
        v["2 slope s"] = {ours(layout.slope_s), static_cast<double>(truth.mean_slope[0])};
        v["2 slope t"] = {ours(layout.slope_t), static_cast<double>(truth.mean_slope[1])};
        v["3 slope ss"] = {ours(layout.slope_ss), static_cast<double>(truth.cov_slope[0])};
        v["3 slope tt"] = {ours(layout.slope_tt), static_cast<double>(truth.cov_slope[1])};
        v["3 slope st"] = {ours(layout.slope_st), static_cast<double>(truth.cov_slope[2])};
        const char* third[] = {"4 sss", "4 sst", "4 stt", "4 ttt"};
        const char* fourth[] = {"5 ssss", "5 ssst", "5 sstt", "5 sttt", "5 tttt"};
        for (int i = 0; i < 4; ++i)
            v[third[i]] = {ours(layout.slope_tail + i),
                           static_cast<double>(truth.third_slope[static_cast<size_t>(i)])};
        for (int i = 0; i < 5; ++i)
            v[fourth[i]] = {ours(layout.slope_tail + 4 + i),
                            static_cast<double>(truth.fourth_slope[static_cast<size_t>(i)])};
        if (layout.height >= 0) {
            v["6 hn"] = {ours(layout.height), static_cast<double>(truth.mean_hn)};
            v["7 var hn"] = {ours(layout.height_var), static_cast<double>(truth.var_hn)};
        }
        for (int c = 0; layout.color >= 0 && c < 3; ++c) {
            const auto k = static_cast<size_t>(c);
            const std::string channel(1, "RGB"[c]);
            if (truth.coverage > 0) // without data the baker fills in the mean color
                v["8 color " + channel] = {ours(layout.color + c),
                                           static_cast<double>(truth.mean_color[k])};
            v["9 var " + channel] = {ours(layout.color_var + c),
                                     static_cast<double>(truth.var_color[k])};
            if (layout.color_height >= 0)
                v["a cov hn " + channel] = {ours(layout.color_height + c),
                                            static_cast<double>(truth.cov_color_hn[k])};
            v["b cov s " + channel] = {ours(layout.color_slope_s + c),
                                       static_cast<double>(truth.cov_color_s[k])};
            v["b cov t " + channel] = {ours(layout.color_slope_t + c),
                                       static_cast<double>(truth.cov_color_t[k])};
        }
        return v;
    }

    void compare_level(const MomentLayout& layout, Recorder& recorder, int l,
                       const TrueLevel& truth)
    {
        std::map<char, double>& scale = scale_;
        for (int y = 0; y < truth.height; ++y)
            for (int x = 0; x < truth.width; ++x)
                for (const auto& [name, pair] :
                     values_of(layout, recorder.row(l, y), x, truth.at(x, y)))
                    scale[name[0]] = std::max(scale[name[0]], std::abs(pair.second));
        for (int y = 0; y < truth.height; ++y)
            for (int x = 0; x < truth.width; ++x) {
                const MomentRow row = recorder.row(l, y);
                for (const auto& [name, pair] : values_of(layout, row, x, truth.at(x, y)))
                    ASSERT_NEAR(pair.first, pair.second, tolerance_ * (scale[name[0]] + kDust))
                        << case_.title << " level " << l << " texel " << x << "," << y << " "
                        << name;
                const auto& t = truth.at(x, y);
                const double trace = static_cast<double>(t.cov_slope[0] + t.cov_slope[1]);
                const double det = static_cast<double>(t.cov_slope[0] * t.cov_slope[1] -
                                                       t.cov_slope[2] * t.cov_slope[2]);
                const bool well_posed = det > 1e-4 * trace * trace && trace > 1e-6;
                if (well_posed) {
                    ASSERT_NEAR(tail_of(layout, row, x).kurtosis / static_cast<double>(t.kurtosis),
                                1, 1e-6)
                        << case_.title << " level " << l << " texel " << x << "," << y;
                }
            }
    }

    static constexpr double kDust = 1e-3; ///< yardstick where the truth is 0; heights are near 1

    const OracleCase& case_;
    double tolerance_;
    std::map<char, double> scale_; ///< largest of each kind in this level and the finer ones
};

// Rounding of double through ten levels of merging, and of brute force.
constexpr double kRounding = 1e-12;

TEST(Moments, OfEveryLevelAgreeWithBruteForceAtAllSizes)
{
    const std::pair<int, int> sizes[] = {{1, 1},   {1, 7},    {7, 1},     {2, 2},
                                         {3, 3},   {17, 31},  {99, 99},   {100, 128},
                                         {63, 65}, {300, 20}, {129, 257}, {15, 200}};
    unsigned seed = 1;
    for (const auto& [width, height] : sizes) {
        const OracleCase c = random_case(width, height, seed++);
        Comparison(c, kRounding).run();
        if (HasFatalFailure())
            return;
    }
}

TEST(Moments, HonourEveryWrapAndReconstruction)
{
    for (const Wrap wrap_s : {Wrap::periodic, Wrap::clamp, Wrap::mirror, Wrap::black})
        for (const Wrap wrap_t : {Wrap::periodic, Wrap::clamp, Wrap::mirror, Wrap::black})
            for (const auto reconstruction :
                 {Reconstruction::bilinear, Reconstruction::central, Reconstruction::sobel}) {
                OracleCase c = random_case(13, 70, 77);
                set_wrap(c, wrap_s, wrap_t);
                set_reconstruction(c, reconstruction);
                set_texel_size(c, 0.25, 3);
                Comparison(c, kRounding).run();
                if (HasFatalFailure())
                    return;
            }
}

TEST(Moments, LeaveOutTexelsWithoutData)
{
    const std::pair<int, int> sizes[] = {{1, 1}, {7, 9}, {64, 64}, {33, 130}, {260, 11}};
    unsigned seed = 100;
    for (const auto& [width, height] : sizes)
        for (const Wrap wrap : {Wrap::periodic, Wrap::clamp, Wrap::black})
            for (const auto reconstruction : {Reconstruction::bilinear, Reconstruction::sobel}) {
                OracleCase c = holes_case(width, height, seed++);
                set_wrap(c, wrap, wrap);
                set_reconstruction(c, reconstruction);
                Comparison(c, kRounding).run();
                if (HasFatalFailure())
                    return;
            }
}

TEST(Moments, OfGivenSlopesAgreeWithBruteForce)
{
    OracleCase c = random_case(37, 50, 9);
    for (size_t i = 0; i < c.input.relief.heights.size(); ++i)
        c.input.slopes.push_back({c.input.relief.heights[i], c.input.relief.colors[i][0] - 0.5});
    c.input.slopes[40][0] = std::nan("");
    c.input.relief.heights.clear();
    Comparison(c, kRounding).run();
}

} // namespace
} // namespace scree::test
