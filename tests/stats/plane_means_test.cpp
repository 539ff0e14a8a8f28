// Weighted means of planes against sums over the fine texels, one by one.

#include "stats/plane_means.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace scree::test {
namespace {

TEST(PlaneMeans, AreWeightedMeansOfTheShares)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-1, 1);
    for (const auto& [fine_width, fine_height] :
         {std::pair(400, 6), std::pair(401, 7), std::pair(3, 3), std::pair(1, 2)}) {
        const int width = coarser_size(fine_width), height = coarser_size(fine_height);
        constexpr int kPlanes = 4; // the weight, one that is left alone, two that are averaged
        std::vector<double> fine(static_cast<size_t>(kPlanes * fine_width * fine_height));
        auto fine_row = [&](int y) {
            return MomentRow{fine.data() + static_cast<ptrdiff_t>(y) * kPlanes * fine_width,
                             fine_width};
        };
        for (double& number : fine)
            number = value(random);
        for (int y = 0; y < fine_height; ++y)
            for (int x = 0; x < fine_width; ++x)
                fine_row(y).plane(0)[x] = random() % 3 == 0 ? 0 : 0.5 + 0.5 * value(random);
        for (int x = 0; x < std::min(fine_width, 6); ++x) // some texels with nothing in them
            for (int y = 0; y < fine_height; ++y)
                fine_row(y).plane(0)[x] = 0;

        std::vector<Share> columns;
        for (int x = 0; x < width; ++x)
            columns.push_back(share_of(x, fine_width, width));
        std::vector<double> coarse(static_cast<size_t>(kPlanes * width), -7);
        const MomentRow out{coarse.data(), width};
        for (int y = 0; y < height; ++y) {
            const Share rows = share_of(y, fine_height, height);
            MomentRow fine_rows[3];
            for (int j = 0; j < rows.count; ++j)
                fine_rows[j] = fine_row(rows.first + j);
            mean_planes(2, 2, fine_rows, rows, columns.data(), 0, width, out);
            for (int plane = 2; plane < kPlanes; ++plane)
                for (int x = 0; x < width; ++x) {
                    const Share& share = columns[static_cast<size_t>(x)];
                    double sum = 0, weight = 0;
                    for (int j = 0; j < rows.count; ++j)
                        for (int i = 0; i < share.count; ++i) {
                            const double part = rows.parts[j] * share.parts[i] *
                                                fine_rows[j].plane(0)[share.first + i];
                            sum += part * fine_rows[j].plane(plane)[share.first + i];
                            weight += part;
                        }
                    EXPECT_NEAR(out.plane(plane)[x], weight > 0 ? sum / weight : 0, 1e-13)
                        << fine_width << "x" << fine_height << " at " << x << ", " << y;
                }
        }
        EXPECT_EQ(out.plane(1)[0], -7) << "other planes are left alone";
    }
}

// E[v] and E[v c] of B, G, R against sums over the texels; a texel without weight may hold
// anything.
TEST(PlaneMeans, OfWhatIsSeenOfTexelsAreThoseOfTheirColors)
{
    MomentSet set;
    set.slope = false;
    set.color = true;
    set.visible_nodes = 2;
    set.views = 1;
    const MomentLayout layout(set);
    constexpr int kWidth = 301, kHeight = 3, kComponents = 3;
    ASSERT_EQ(layout.seen_components(), kComponents);
    ASSERT_EQ(layout.planes, layout.texel_planes + 4 * kComponents);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1, 1);
    std::vector<double> fine(static_cast<size_t>(layout.texel_planes * kWidth * kHeight));
    std::vector<float> seen(static_cast<size_t>(kComponents * kWidth * kHeight));
    for (double& number : fine)
        number = 1 + value(random);
    for (float& number : seen)
        number = static_cast<float>(value(random));
    MomentRow fine_rows[kHeight];
    for (int y = 0; y < kHeight; ++y) {
        fine_rows[y] = {fine.data() + static_cast<ptrdiff_t>(y) * layout.texel_planes * kWidth,
                        kWidth, seen.data() + static_cast<ptrdiff_t>(y) * kComponents * kWidth};
        fine_rows[y].plane(0)[7] = 0;
    }
    const int width = coarser_size(kWidth);
    std::vector<Share> columns;
    for (int x = 0; x < width; ++x)
        columns.push_back(share_of(x, kWidth, width));
    std::vector<double> coarse(static_cast<size_t>(layout.planes * width), -7);
    const MomentRow out{coarse.data(), width};
    const Share rows = share_of(0, kHeight, 1);
    mean_seen(layout, fine_rows, rows, columns.data(), 0, width, out);
    for (int component = 0; component < kComponents; ++component)
        for (int i = 0; i < 4; ++i)
            for (int x = 0; x < width; ++x) {
                const Share& share = columns[static_cast<size_t>(x)];
                double sum = 0, weight = 0;
                for (int j = 0; j < rows.count; ++j)
                    for (int k = 0; k < share.count; ++k) {
                        const MomentRow texel = fine_rows[j].from(share.first + k);
                        const double part = rows.parts[j] * share.parts[k] * texel.plane(0)[0];
                        const double color = i == 0 ? 1 : texel.plane(layout.color + 3 - i)[0];
                        sum += part * static_cast<double>(texel.seen_of(component)[0]) * color;
                        weight += part;
                    }
                EXPECT_NEAR(out.plane(layout.texel_planes + 4 * component + i)[x], sum / weight,
                            1e-13)
                    << component << ", " << i << " at " << x;
            }
    EXPECT_EQ(out.plane(layout.color)[0], -7) << "other planes are left alone";
}

} // namespace
} // namespace scree::test
