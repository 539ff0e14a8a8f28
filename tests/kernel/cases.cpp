#include "kernel/cases.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace scree::test {

namespace {

const double kPi = std::acos(-1.0);
double degrees(double angle) { return angle * kPi / 180; }

struct Direction {
    double x, y, z;
};

Direction toward(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

struct Spread {
    double ss, st, tt;
};

/// Uniform and normal numbers that are the same on every machine.
class Random {
public:
    double uniform(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }

private:
    std::mt19937 engine_{20261122};
};

class Table {
public:
    KernelCase& add(const std::string& name, Direction view, double ms, double mt, Spread c,
                    double tau = 0)
    {
        KernelCase row;
        row.name = name;
        auto set = [&](int input, double value) { row.in[input] = static_cast<float>(value); };
        const Direction light = toward(random_.uniform(0, 1.5), random_.uniform(-3.14, 3.14));
        set(kWox, view.x), set(kWoy, view.y), set(kWoz, view.z);
        set(kWix, light.x), set(kWiy, light.y), set(kWiz, light.z);
        set(kMeanS, ms), set(kMeanT, mt);
        set(kCss, c.ss), set(kCst, c.st), set(kCtt, c.tt);
        set(kTau, tau);
        set(kBaseAlpha, random_.uniform(0.02, 0.5));
        // Heights, color and slope that fit together: c = mean + r_h hn + r_s slope + noise.
        const double h = random_.uniform(-1, 1), sigma = random_.uniform(0.05, 1.5);
        const double color = random_.uniform(0.1, 0.9), by_height = random_.uniform(-0.3, 0.3);
        set(kH, h), set(kHh, h * h + sigma * sigma), set(kC, color);
        set(kCh, color * h + by_height * sigma);
        const double rs = random_.uniform(-0.2, 0.2), rt = random_.uniform(-0.2, 0.2);
        set(kCs, color * ms + rs * c.ss + rt * c.st);
        set(kCt, color * mt + rs * c.st + rt * c.tt);
        for (int n = kA1; n <= kA8; ++n)
            set(n, random_.uniform(-0.3, 0.3) / (n - kA1 + 1));
        const double reach = std::sqrt(std::max(c.ss, c.tt));
        const double raw_s = random_.uniform(-1, 1) * reach, raw_t = random_.uniform(-1, 1) * reach;
        set(kRawS, raw_s), set(kRawT, raw_t);
        set(kRawSs, c.ss + raw_s * raw_s), set(kRawSt, c.st + raw_s * raw_t);
        set(kRawTt, c.tt + raw_t * raw_t);
        set(kSecondSs, c.ss + ms * ms), set(kSecondSt, c.st + ms * mt);
        set(kSecondTt, c.tt + mt * mt);
        add_table(row);
        rows_.push_back(row);
        return rows_.back();
    }

    Random& random() { return random_; }
    std::vector<KernelCase> take() { return std::move(rows_); }

private:
    /// What a table may tell of the direction, and what it should not but may: no area or less than
    /// none, black, a color that visibility does not touch. And an exponent as it may be measured.
    void add_table(KernelCase& row)
    {
        static constexpr double kNodeDegrees[][2] = {{0, 30},  {30, 60}, {45, 72},  {60, 80},
                                                     {80, 87}, {0, 87},  {87, 89.7}};
        const size_t turn = rows_.size();
        auto set = [&](Input input, double value) {
            row.in[static_cast<size_t>(input)] = static_cast<float>(value);
        };
        const auto& nodes = kNodeDegrees[turn % std::size(kNodeDegrees)];
        set(kNodeNear, std::cos(degrees(nodes[0]))), set(kNodeFar, std::cos(degrees(nodes[1])));
        const double c = turn % 11 == 3 ? 0 : of_tables_.uniform(0, 0.9);
        const double excess =
            turn % 7 == 5 ? -1 - of_tables_.uniform(-0.04, 0.3) : of_tables_.uniform(-0.9, 1.5);
        const double shift = turn % 5 == 1 ? 0 : of_tables_.uniform(-0.8, 0.8) * (c + 0.02);
        set(kTableC, c), set(kA, excess);
        set(kBeta, excess * c + shift * std::max(1 + excess, 0.02));
        set(kLitC, turn % 13 == 4 ? 0 : (c + 0.01) * of_tables_.uniform(0, 6));
        set(kGain, turn % 17 == 6 ? 0 : of_tables_.uniform(0.2, 8));
        set(kPower, of_tables_.uniform(0.1, 3));
        set(kThreshold, turn % 3 == 0 ? 0 : of_tables_.uniform(0, 0.3));
    }

    Random random_;
    Random of_tables_; ///< apart, so that the rest of a row does not depend on it
    std::vector<KernelCase> rows_;
};

void add_table_3(Table& table)
{
    table.add("table 3 row 1", toward(0, 0), 1, 0, {1, 0, 1});
    table.add("table 3 row 2", toward(1.56, 0), 1, 0, {1, 0, 1});
    table.add("table 3 row 3", toward(1.56, kPi / 2), 1, 1, {1, 0.5, 1});
    table.add("table 3 row 4", toward(1.56, -kPi / 2), 1, 1, {1, 0.75, 1});
    table.add("table 3 row 5", toward(1.56, -kPi / 2), 1, 0, {1, 0, 5});
}

void add_failure_cases(Table& table)
{
    for (double phi : {0.0, 1.1, -2.0})
        table.add("1 straight above", toward(0, phi), 0.2, -0.4, {0.3, 0.1, 0.2});
    table.add("1 nearly straight above", {1e-9, -2e-9, 1}, 0.2, -0.4, {0.3, 0.1, 0.2});
    table.add("1 less nearly", {1e-4, 1e-4, 1}, 0.2, -0.4, {0.3, 0.1, 0.2});
    for (double z : {1e-2, 1e-3, 1e-4, 1e-6, 0.0})
        for (double tau : {0.0, 0.4, 1.0})
            table.add("2 grazing", {std::sqrt(1 - z * z), 0, z}, 0, 0, {0.09, 0.02, 0.04}, tau);
    for (double slope : {0.5, 1.0, 2.0, 10.0})
        for (double tau : {0.0, 0.4, 1.0})
            table.add("3 mean plane turned away", toward(1.3, 0.4), slope, 0.3 * slope,
                      {0.09, 0.02, 0.04}, tau);
    for (double theta : {0.3, 1.2, 1.55}) {
        table.add("4 flat", toward(theta, 0.7), 0, 0, {0, 0, 0});
        table.add("4 plane", toward(theta, 0.7), 0.5, 0.2, {0, 0, 0});
        table.add("4 plane turned away", toward(theta, 0.7), 50, 2, {0, 0, 0});
        table.add("4 groove along s", toward(theta, 0.7), 0, 0, {0, 0, 0.25});
        table.add("4 groove along t", toward(theta, 0.7), 0, 0, {0.25, 0, 0});
        table.add("4 groove, view along it", toward(theta, kPi / 2), 0.1, 0.1, {0.25, 0, 0});
        table.add("4 diagonal groove", toward(theta, 0.7), 0, 0, {0.25, 0.25, 0.25});
        table.add("4 oblique groove", toward(theta, 2.7), 0.1, 0.2, {0.25, -0.125, 0.0625});
        table.add("5 variance below 0", toward(theta, 0.7), 0.2, 0.1, {-1e-3, 0.01, 0.04});
        table.add("5 determinant below 0", toward(theta, 0.7), 0.2, 0.1, {0.04, 0.0401, 0.04});
        table.add("6 groove at +45", toward(theta, kPi / 4), 0, 0, {0.2, 0.19, 0.2});
        table.add("6 groove at -45", toward(theta, -kPi / 4), 0, 0, {0.2, -0.19, 0.2});
    }
    for (double theta : {60.0, 70.0, 75.0, 80.0, 85.0})
        table.add("7 V-groove", toward(degrees(theta), 0), 0, 0, {0.25, 0, 0});
    for (double mu : {0.1, 0.6, 1.0})
        for (double tau : {0.0, 0.5, 1.0})
            table.add("8 heavy tails", {0.8944, 0, 0.4472}, 0.5 - mu, 0, {0.09, 0.01, 0.09}, tau);
    for (double theta : {0.0, 1.0, 1.5}) {
        auto& bricks = table.add("9 two heights", toward(theta, 0.2), 0, 0, {0.04, 0, 0.04});
        bricks.in[kH] = 0.5F, bricks.in[kHh] = 0.5F; // half at 0, half at 1
        auto& one = table.add("9 one height", toward(theta, 0.2), 0, 0, {0.04, 0, 0.04});
        one.in[kH] = 2.0F, one.in[kHh] = 4.0F;
    }
}

/// Long thin covariances and the whole range of z. View azimuths are taken at random, along the
/// least spread (where w' C w cancels) and along the most, in turn.
void add_sweep(Table& table, const std::vector<double>& zs, const std::vector<double>& taus)
{
    int turn = 0;
    for (double z : zs)
        for (double ratio : {1.0, 10.0, 100.0, 1e4})
            for (double correlation : {0.0, 0.9, -0.99, 0.9999}) {
                const double large = table.random().uniform(0.05, 1);
                const double small = large / ratio;
                const bool swap = turn % 2 == 1;
                Spread c{large * large, correlation * large * small, small * small};
                if (swap)
                    std::swap(c.ss, c.tt);
                double phi = table.random().uniform(-kPi, kPi);
                const double most = 0.5 * std::atan2(2 * c.st, c.ss - c.tt);
                if (turn % 3 == 1)
                    phi = most + kPi / 2;
                if (turn % 3 == 2)
                    phi = most;
                const Direction w = toward(table.random().uniform(0.1, 1.57), phi);
                const double b = std::sqrt(
                    std::max(0.0, c.ss * w.x * w.x + 2 * c.st * w.x * w.y + c.tt * w.y * w.y));
                const double along = (w.z - z * b) / (w.x * w.x + w.y * w.y);
                const double aside = table.random().uniform(-1, 1);
                const double tau = taus[static_cast<size_t>(turn) % taus.size()];
                std::ostringstream name;
                name << "sweep z " << z << " ratio " << ratio << " correlation " << correlation
                     << " tau " << tau;
                table.add(name.str(), w, along * w.x - aside * w.y, along * w.y + aside * w.x, c,
                          tau);
                ++turn;
            }
}

void add_surfaces(Table& table)
{
    for (int i = 0; i < 120; ++i) {
        Random& random = table.random();
        const double sigma_s = std::exp(random.uniform(std::log(1e-3), std::log(1.0)));
        const double sigma_t = sigma_s * std::exp(random.uniform(-2, 2));
        const double correlation = random.uniform(-0.95, 0.95);
        const Direction view = toward(random.uniform(0, 1.56), random.uniform(-kPi, kPi));
        table.add("surface " + std::to_string(i), view, random.uniform(-0.5, 0.5),
                  random.uniform(-0.5, 0.5),
                  {sigma_s * sigma_s, correlation * sigma_s * sigma_t, sigma_t * sigma_t},
                  i % 3 == 0 ? random.uniform(0, 1) : 0);
    }
}

} // namespace

std::vector<KernelCase> kernel_cases()
{
    Table table;
    add_table_3(table);
    add_failure_cases(table);
    add_sweep(table, {-40,  -30, -20, -15, -12.5, -10, -8, -6, -5, -4, -3, -2, -1,
                      -0.3, 0,   0.3, 1,   2,     3,   4,  5,  6,  8,  12, 20, 40},
              {0});
    add_sweep(table, {-40, -20, -8, -3, -1, -0.1, 0, 0.1, 1, 3, 8, 20, 40}, {1, 0.3, 0.02});
    add_surfaces(table);
    return table.take();
}

const char* output_name(int output)
{
    static const char* const names[kOutputs] = {"raw css",
                                                "raw cst",
                                                "raw ctt",
                                                "N",
                                                "visible s",
                                                "visible t",
                                                "visible ss",
                                                "visible st",
                                                "visible tt",
                                                "Lambda",
                                                "G1",
                                                "height mean",
                                                "height variance",
                                                "color by height",
                                                "color by rank",
                                                "color by slope",
                                                "map u",
                                                "map v",
                                                "alpha x",
                                                "alpha y",
                                                "angle",
                                                "specular",
                                                "diffuse",
                                                "projected area",
                                                "slope along",
                                                "steepness",
                                                "steepness spread",
                                                "node coordinate",
                                                "node share",
                                                "cos phi",
                                                "cos 2 phi",
                                                "sin phi",
                                                "sin 2 phi",
                                                "visible area",
                                                "color by visibility",
                                                "overlap of view and light",
                                                "color seen and lit",
                                                "Lambda of raw moments",
                                                "measured exponent",
                                                "cosine along an axis"};
    return names[output];
}

std::string describe(const KernelCase& row)
{
    std::ostringstream out;
    out.precision(9);
    out << row.name << ": wo " << row.in[kWox] << ' ' << row.in[kWoy] << ' ' << row.in[kWoz]
        << " wi " << row.in[kWix] << ' ' << row.in[kWiy] << ' ' << row.in[kWiz] << " mean "
        << row.in[kMeanS] << ' ' << row.in[kMeanT] << " covariance " << row.in[kCss] << ' '
        << row.in[kCst] << ' ' << row.in[kCtt] << " tau " << row.in[kTau];
    return out.str();
}

} // namespace scree::test
