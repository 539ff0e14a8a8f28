// Visibility tables as the C++ front reads them: interpolation, and color where it is known.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "kernel/visibility_table.h"

namespace scree::test {
namespace {

using Imath::V2d;
using Imath::V3d;
using Imath::V3f;

constexpr double kPi = 3.14159265358979324;

double degrees(double angle) { return angle * kPi / 180; }

V3d toward(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A table by the meaning of its numbers, without an order.
struct Table {
    struct Component {
        double a = 0;
        V3d beta{0, 0, 0};
    };
    std::vector<double> thetas;                         ///< of the nodes, rising
    std::vector<Component> means;                       ///< one a node
    std::vector<std::array<Component, 2>> cos_h, sin_h; ///< a node, h - 1
    int harmonics = 0;

    void add_node(double theta)
    {
        thetas.push_back(theta);
        means.emplace_back();
        cos_h.emplace_back();
        sin_h.emplace_back();
    }
};

/// The same as a file has it.
template <typename Real>
struct Packed {
    std::vector<Real> values, cosines;
    filter::VisibilityTable<Real> table;

    explicit Packed(const Table& from)
    {
        const auto add = [&](const Table::Component& c) {
            for (const double number : {c.a, c.beta.z, c.beta.y, c.beta.x})
                values.push_back(static_cast<Real>(number));
        };
        for (size_t k = 0; k < from.thetas.size(); ++k) {
            cosines.push_back(static_cast<Real>(std::cos(from.thetas[k])));
            add(from.means[k]);
            for (const auto* kind : {&from.cos_h, &from.sin_h})
                for (int h = 0; h < from.harmonics; ++h)
                    add((*kind)[k][static_cast<size_t>(h)]);
        }
        table = {values.data(), cosines.data(), static_cast<int>(from.thetas.size()),
                 from.harmonics};
    }
};

/// What a table tells of a direction, by the definition; theta below 89 degrees.
Table::Component by_definition(const Table& table, double theta, double phi)
{
    const auto at_node = [&](size_t k) {
        Table::Component sum = table.means[k];
        for (int h = 1; h <= table.harmonics; ++h) {
            const auto i = static_cast<size_t>(h - 1);
            const auto &c = table.cos_h[k][i], &s = table.sin_h[k][i];
            sum.a += c.a * std::cos(h * phi) + s.a * std::sin(h * phi);
            sum.beta += c.beta * std::cos(h * phi) + s.beta * std::sin(h * phi);
        }
        return sum;
    };
    double before = 0;
    Table::Component from;
    for (size_t k = 0; k < table.thetas.size(); ++k) {
        const double after = std::tan(table.thetas[k]);
        const Table::Component to = at_node(k);
        if (std::tan(theta) <= after) {
            const double share = (std::tan(theta) - before) / (after - before);
            return {from.a + share * (to.a - from.a), from.beta + (to.beta - from.beta) * share};
        }
        before = after;
        from = to;
    }
    return from;
}

class Random {
public:
    double uniform(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    Table::Component component(double size)
    {
        const auto one = [&] { return uniform(-size, size); };
        return {one(), {one(), one(), one()}};
    }
    Table table(int nodes, int harmonics)
    {
        Table out;
        out.harmonics = harmonics;
        for (int k = 0; k < nodes; ++k) {
            // At least a quarter of their distance apart.
            out.add_node(degrees(88.0 * (k + uniform(0.25, 1)) / nodes));
            out.means.back() = component(0.4);
            for (size_t h = 0; h < 2; ++h) {
                out.cos_h.back()[h] = component(0.1);
                out.sin_h.back()[h] = component(0.1);
            }
        }
        return out;
    }

private:
    std::mt19937 engine_{7};
};

template <typename Real>
class VisibilityTables : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(VisibilityTables, Reals);

// Tolerance: a direction known to a few roundings has x to that times tan theta <= 29 and more
// where a node is near it, and tables here change by up to 1 between nodes.
TYPED_TEST(VisibilityTables, AreSumsOfHarmonicsInterpolatedInTheTangent)
{
    using Real = TypeParam;
    const double tolerance = sizeof(Real) == 4 ? 2e-5 : 5e-14;
    Random random;
    double worst = 0, most = 0;
    for (int nodes = 1; nodes <= 6; ++nodes)
        for (int harmonics = 0; harmonics <= 2; ++harmonics)
            for (int i = 0; i < 300; ++i) {
                const Table table = random.table(nodes, harmonics);
                const Packed<Real> packed(table);
                const double theta = degrees(random.uniform(1, 89.2));
                const double phi = random.uniform(-kPi, kPi);
                const Table::Component want = by_definition(table, theta, phi);
                const auto got =
                    filter::visibility(packed.table, Imath::Vec3<Real>(toward(theta, phi)));
                double error = std::abs(static_cast<double>(got.a) - want.a);
                for (int c = 0; c < 3; ++c)
                    error =
                        std::max(error, std::abs(static_cast<double>(got.beta[c]) - want.beta[c]));
                worst = std::max(worst, error);
                most = std::max(most, std::abs(want.a));
                ASSERT_LE(error, tolerance) << got.a << ' ' << got.beta << " for " << want.a << ' '
                                            << want.beta << ", " << nodes << " nodes, " << harmonics
                                            << " harmonics, theta " << theta << " phi " << phi;
            }
    EXPECT_GT(most, 0.3);
    this->RecordProperty("worst", testing::PrintToString(worst));
}

/// A table along axes, by the meaning of its numbers: functions of a tangent, their values at the
/// nodes.
struct AxesTable {
    struct Function {
        std::vector<double> of_a; ///< a node each
        double at(const std::vector<double>& tangents, double x) const
        {
            double before = 0, from = 0;
            for (size_t k = 0; k < tangents.size(); ++k) {
                if (x <= tangents[k])
                    return from + (of_a[k] - from) * (x - before) / (tangents[k] - before);
                before = tangents[k];
                from = of_a[k];
            }
            return from;
        }
    };
    Function all, x_negative, x_positive, y_negative, y_positive;
};

// Of a alone; that beta is read alike is what harmonics are tested for. Tolerance: the cosine of a
// small tangent x is off by a rounding, and so x by that over x, at most by its root.
TYPED_TEST(VisibilityTables, AlongAxesAreSumsOfFunctionsOfTheTangentsAlongThem)
{
    using Real = TypeParam;
    const double rounding = std::numeric_limits<Real>::epsilon();
    const auto off_by = [rounding](double x) {
        return rounding / std::max(x, std::sqrt(rounding));
    };
    Random random;
    double worst = 0;
    for (int nodes = 1; nodes <= 6; ++nodes)
        for (int i = 0; i < 300; ++i) {
            const double turn = random.uniform(-kPi, kPi);
            std::vector<double> tangents;
            std::vector<Real> values, cosines;
            AxesTable table;
            for (int k = 0; k < nodes; ++k) {
                const double theta = degrees(88.0 * (k + random.uniform(0.25, 1)) / nodes);
                tangents.push_back(std::tan(theta));
                cosines.push_back(static_cast<Real>(std::cos(theta)));
                for (auto* function : {&table.all, &table.x_negative, &table.x_positive,
                                       &table.y_negative, &table.y_positive}) {
                    function->of_a.push_back(random.uniform(-0.4, 0.4));
                    values.push_back(static_cast<Real>(function->of_a.back()));
                    values.insert(values.end(), 3, Real(0));
                }
            }
            const filter::VisibilityTable<Real> packed{values.data(),
                                                       cosines.data(),
                                                       nodes,
                                                       0,
                                                       true,
                                                       static_cast<Real>(std::cos(turn)),
                                                       static_cast<Real>(std::sin(turn))};
            const double theta = degrees(random.uniform(1, 89.2));
            const double phi = random.uniform(-kPi, kPi);
            const double x = std::tan(theta) * std::cos(phi - turn);
            const double y = std::tan(theta) * std::sin(phi - turn);
            const double want =
                table.all.at(tangents, std::tan(theta)) +
                (x < 0 ? table.x_negative : table.x_positive).at(tangents, std::abs(x)) +
                (y < 0 ? table.y_negative : table.y_positive).at(tangents, std::abs(y));
            const auto got = filter::visibility(packed, Imath::Vec3<Real>(toward(theta, phi)));
            double closest = tangents.front();
            for (size_t k = 1; k < tangents.size(); ++k)
                closest = std::min(closest, tangents[k] - tangents[k - 1]);
            const double roundings = off_by(std::abs(x)) + off_by(std::abs(y)) +
                                     off_by(std::tan(theta)) + 30 * rounding * std::tan(theta);
            worst = std::max(worst, std::abs(static_cast<double>(got.a) - want));
            ASSERT_NEAR(static_cast<double>(got.a), want,
                        2 * roundings * 0.8 / closest + 30 * rounding)
                << nodes << " nodes, theta " << theta << " phi " << phi << " turn " << turn;
        }
    this->RecordProperty("worst", testing::PrintToString(worst));
}

TYPED_TEST(VisibilityTables, AtANodeAreThatNode)
{
    using Real = TypeParam;
    Random random;
    const Table table = random.table(5, 2);
    const Packed<Real> packed(table);
    for (size_t k = 0; k < 5; ++k)
        for (const double phi : {0.0, 1.0, -2.0}) {
            const Imath::Vec3<Real> w(toward(table.thetas[k], phi));
            const auto got = filter::visibility(packed.table, w);
            const double want = table.means[k].a + table.cos_h[k][0].a * std::cos(phi) +
                                table.cos_h[k][1].a * std::cos(2 * phi) +
                                table.sin_h[k][0].a * std::sin(phi) +
                                table.sin_h[k][1].a * std::sin(2 * phi);
            EXPECT_NEAR(got.a, want, sizeof(Real) == 4 ? 1e-6 : 1e-15) << "node " << k;
        }
}

TEST(VisibilityTable, StraightAboveIsTheMeanColorAndAllOfTheArea)
{
    Random random;
    const V3f color(0.2F, 0.5F, 0.7F), up(0, 0, 1);
    for (int nodes = 1; nodes <= 6; ++nodes)
        for (int harmonics = 0; harmonics <= 2; ++harmonics) {
            const Packed<float> packed(random.table(nodes, harmonics));
            EXPECT_EQ(filter::visible_color(color, packed.table, up), color);
            EXPECT_EQ(filter::visible_area(packed.table, up), 1);
            // A little off it differs a little: azimuths have no say there.
            const V3f seen =
                filter::visible_color(color, packed.table, V3f(1e-5F, -1e-5F, 1).normalized());
            EXPECT_LT((seen - color).length(), 1e-3F);
        }
}

TEST(VisibilityTable, BeyondTheLastNodeIsThatNodeAndUnderThePlaneShowsNoArea)
{
    Random random;
    Table table = random.table(3, 1);
    for (auto& mean : table.means)
        mean.a = 0.3;
    const Packed<double> packed(table);
    const double last = table.thetas.back(), phi = 0.8;
    const auto at = [&](double theta) {
        return filter::visibility(packed.table, toward(theta, phi));
    };
    for (const double theta : {0.5 * (last + kPi / 2), kPi / 2, 2.0, kPi - 0.01}) {
        EXPECT_NEAR(at(theta).a, at(last).a, 1e-12);
        EXPECT_LT((at(theta).beta - at(last).beta).length(), 1e-12);
    }
    EXPECT_GT(filter::visible_area(packed.table, toward(last, phi)), 0);
    EXPECT_EQ(filter::visible_area(packed.table, toward(2, phi)), 0);
}

/// A plane of that slope and color shows v = 1 - tan(theta) (slope along the azimuth): a first
/// harmonic. Added with a weight, as a footprint adds up.
void add_plane(Table& table, double weight, const V2d& slope, const V3d& color)
{
    table.harmonics = 1;
    for (size_t k = 0; k < table.thetas.size(); ++k) {
        const double reach = -weight * std::tan(table.thetas[k]);
        auto &c = table.cos_h[k][0], &s = table.sin_h[k][0];
        c.a += reach * slope.x;
        s.a += reach * slope.y;
        c.beta += color * (reach * slope.x);
        s.beta += color * (reach * slope.y);
    }
}

// As long as no facet faces away nothing hides anything, so colors mix by their projected areas.
TEST(VisibilityTable, OfFacetsThatHideNothingIsExactAtEveryAngle)
{
    struct Facet {
        double weight;
        V2d slope;
        V3d color;
    };
    const Facet facets[] = {{0.3, {0.3, 0.1}, {0.9, 0.2, 0.1}},
                            {0.5, {-0.25, 0.2}, {0.1, 0.5, 0.3}},
                            {0.2, {0.1, -0.4}, {0.2, 0.3, 0.8}}};
    Table table;
    for (const double theta : {30.0, 50.0, 65.0})
        table.add_node(degrees(theta));
    V3d mean(0);
    for (const Facet& facet : facets) {
        add_plane(table, facet.weight, facet.slope, facet.color);
        mean += facet.color * facet.weight;
    }
    const Packed<double> packed(table);
    double shift = 0;
    for (int i = 0; i <= 26; ++i)
        for (int j = 0; j < 13; ++j) {
            const double theta = 2.5 * i, phi = 0.5 * j - 3;
            const V3d w = toward(degrees(theta), phi);
            double area = 0;
            V3d color(0);
            for (const Facet& facet : facets) {
                const double seen = w.z - w.x * facet.slope.x - w.y * facet.slope.y;
                ASSERT_GT(seen, 0);
                area += facet.weight * seen;
                color += facet.color * (facet.weight * seen);
            }
            color /= area;
            const V3d got = filter::visible_color(mean, packed.table, w);
            EXPECT_LT((got - color).length(), 1e-14) << theta << ' ' << phi;
            EXPECT_NEAR(filter::visible_area(packed.table, w), area, 1e-14) << theta << ' ' << phi;
            shift = std::max(shift, (color - mean).length());
        }
    EXPECT_GT(shift, 0.15);
}

// --- color, one channel -------------------------------------------------------------------------

TEST(ColorByVisibility, OfOneColorIsThatColorWhateverIsSeen)
{
    for (const double a : {-1.4, -1.0, -0.99, -0.5, 0.0, 2.0, 100.0})
        EXPECT_NEAR(kernel::scree_color_by_visibility(0.3, a * 0.3, a), 0.3, 1e-15) << a;
}

TEST(ColorByVisibility, StaysFiniteAndContinuousWhereNothingIsSeen)
{
    EXPECT_EQ(kernel::scree_color_by_visibility(0.3, -0.3, -1.0), 0.3) << "nothing: the mean color";
    // With 1/8 seen, all of it red 0.8, the other half of 1/4 is the mean color.
    EXPECT_NEAR(kernel::scree_color_by_visibility(0.3, 0.8 / 8 - 0.3, 1.0 / 8 - 1),
                0.5 * (0.8 + 0.3), 1e-14);
    // From 1/4 on it is what is seen.
    for (const double v : {0.25, 0.3, 1.0})
        EXPECT_NEAR(kernel::scree_color_by_visibility(0.3, 0.8 * v - 0.3, v - 1), 0.8, 1e-14) << v;
    double before = kernel::scree_color_by_visibility(0.3, -0.31, -2.0);
    for (int i = 0; i < 16000; ++i) {
        const double a = -2 + 1e-4 * i;
        const double now = kernel::scree_color_by_visibility(0.3, -0.31, a);
        EXPECT_LT(std::abs(now - before), 4 * 0.8 * 1e-4) << a;
        EXPECT_GE(now, 0);
        before = now;
    }
    EXPECT_EQ(kernel::scree_color_by_visibility(0.3, -0.9, 0.2), 0) << "less than black";
    EXPECT_EQ(kernel::scree_visible_area(0.5, -1.2), 0);
    EXPECT_EQ(kernel::scree_visible_area(0.5, 0.5), 0.75);
}

// A series that rings to thousands below what can be seen, as of absurd slopes.
TEST(ColorByVisibility, FarBelowNothingShiftsInProportion)
{
    for (const double v : {-1e3, -1e6})
        EXPECT_NEAR(kernel::scree_color_by_visibility(0.3, 0.8 * v - 0.3, v - 1), 0, 1e-14) << v;
    for (const double v : {-1e3, -1e6})
        EXPECT_NEAR(kernel::scree_color_by_visibility(0.3, 0.1 * v - 0.3, v - 1), 0.5, 1e-9) << v;
}

TEST(ColorSeenAndLit, IsTheOneWhereTheOtherHidesNothing)
{
    const V3d c(0.2, 0.3, 0.4), seen(0.1, 0.5, 0.4);
    const V3d wo = toward(1.2, 0.3), wi = toward(0.9, -2.0);
    const V3d got = filter::color_seen_and_lit(c, seen, c, wo, wi);
    EXPECT_LT((got - seen).length(), 1e-15);
    EXPECT_EQ(got, filter::color_seen_and_lit(c, c, seen, wi, wo)) << "they change places";
}

// Grazing from one side, from both sides and across: the constants of the fit.
TEST(ColorSeenAndLit, AddsTheShiftsButForWhatTheyHaveInCommon)
{
    const V3d c(0.5, 0.5, 0.5), seen(0.7, 0.4, 0.6), lit(0.8, 0.2, 0.3); // same, same, opposite
    const double down = kPi / 2;
    struct {
        V3d wi;
        double together;
    } const cases[] = {{toward(down, 0.7), 0.85},
                       {toward(down, 0.7 + kPi), 0.05},
                       {toward(down, 0.7 + kPi / 2), 0.45},
                       {toward(0, 0), 0.45},
                       {toward(degrees(30), 0.7), 0.65}};
    for (const auto& [wi, together] : cases) {
        const V3d want(1.0 - together * 0.2, 0.1 + together * 0.1, 0.4);
        const V3d got = filter::color_seen_and_lit(c, seen, lit, toward(down, 0.7), wi);
        EXPECT_LT((got - want).length(), 1e-15) << got << " for " << want;
        const V3d exchanged = filter::color_seen_and_lit(c, lit, seen, wi, toward(down, 0.7));
        EXPECT_EQ(exchanged, got) << "view and light change places";
    }
}

TEST(ColorSeenAndLit, IsNeverLessThanBlack)
{
    EXPECT_EQ(kernel::scree_color_seen_and_lit(0.5F, 0.0F, 0.0F, 0.45F), 0);
    EXPECT_EQ(kernel::scree_color_seen_and_lit(0.5F, 0.125F, 0.25F, 0.05F), 0);
    EXPECT_EQ(kernel::scree_color_seen_and_lit(0.0F, 0.0F, 0.0F, 0.45F), 0);
    EXPECT_EQ(kernel::scree_color_seen_and_lit(0.5F, 0.0F, 0.75F, 0.85F), 0.25F);
}

} // namespace
} // namespace scree::test
