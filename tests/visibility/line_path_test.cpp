// How lines go through a row of texels.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "visibility/line_path.h"

namespace scree {
namespace {

/// The row and column of a node, from its texel centres.
double row_of(const LineNode& node) { return node.row + static_cast<double>(node.along); }
double column_of(const LineNode& node) { return node.column + static_cast<double>(node.across); }

constexpr double kRounding = 1e-6; // of the fractions, floats

bool is_half(double x) { return std::abs(2 * x - std::round(2 * x)) < 4 * kRounding; }

void expect_path(int row, int away, double centre, double shift)
{
    const LinePath path(row, away, centre - shift / 2, centre, centre + shift / 2, true);
    ASSERT_LE(path.node_count, LinePath::kMostNodes);
    ASSERT_LE(path.piece_count, LinePath::kMostPieces);
    const auto at = [&](double rows) { return centre + shift * rows; };
    LineNode before = path.beginning;
    EXPECT_NEAR(row_of(before), row - 0.5 * away, kRounding);
    double columns = 0; // crossed
    int next = 0;
    for (int p = 0; p < path.piece_count; ++p) {
        const LinePath::Piece& piece = path.pieces[p];
        ASSERT_EQ(piece.begin, next);
        ASSERT_GT(piece.end, piece.begin);
        for (; next < piece.end; ++next) {
            const LineNode& node = path.nodes[next];
            const double rows = (row_of(node) - row) * away; // past the centres
            EXPECT_NEAR(column_of(node), at(rows), 2 * kRounding);
            EXPECT_NEAR(static_cast<double>(node.drop), (row_of(node) - row_of(before)) * away,
                        2 * kRounding);
            EXPECT_GE(node.drop, 0);
            EXPECT_TRUE(is_half(column_of(node)) || is_half(rows)) << column_of(node);
            const double middle = (column_of(before) + column_of(node)) / 2;
            EXPECT_LE(std::abs(middle - piece.texel), 0.5 + 2 * kRounding);
            columns += is_half(column_of(node)) ? 1 : 0;
            before = node;
        }
    }
    EXPECT_EQ(next, path.node_count);
    EXPECT_NEAR(row_of(before), row + 0.5 * away, kRounding);
    // All halves strictly in between.
    const double low = 2 * std::min(at(-0.5), at(0.5)), high = 2 * std::max(at(-0.5), at(0.5));
    EXPECT_GE(columns, std::ceil(high - 1e-4) - std::floor(low + 1e-4) - 1);
}

TEST(LinePath, CrossesCentresAndEdgesOfTexels)
{
    for (const int away : {1, -1})
        for (const double shift : {0.0, 1e-17, 0.02, 0.25, 0.5, 0.77, 1.0, 1 + 4e-16})
            for (const double sign : {1.0, -1.0})
                for (int i = -40; i < 40; ++i) // ties too: all is crossed at once
                    for (const double beyond : {0.0, 1e-15, -1e-15, 0.013}) {
                        SCOPED_TRACE(testing::Message() << "away " << away << " shift "
                                                        << sign * shift << " from " << i / 8.0);
                        expect_path(-3, away, i / 8.0 + beyond, sign * shift);
                    }
}

TEST(LinePath, IsOnePieceOfTheNearestTexelWithoutColumns)
{
    const LinePath path(5, -1, -7, -3.2, 0.6, false);
    ASSERT_EQ(path.piece_count, 1);
    ASSERT_EQ(path.node_count, 2);
    EXPECT_EQ(path.pieces[0].texel, -3);
    EXPECT_NEAR(column_of(path.nodes[0]), -3.2, kRounding);
    EXPECT_NEAR(row_of(path.nodes[1]), 4.5, kRounding);
    EXPECT_NEAR(column_of(path.nodes[1]), 0.6, kRounding);
}

} // namespace
} // namespace scree
