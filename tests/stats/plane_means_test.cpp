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

} // namespace
} // namespace scree::test
