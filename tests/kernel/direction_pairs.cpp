#include "kernel/direction_pairs.h"

#include <cmath>
#include <random>

namespace scree::test {

namespace {

const double kPi = std::acos(-1.0);

Imath::V3d toward(double theta, double phi)
{
    // Exactly 0 at the horizon, where cos(pi / 2) is 6e-17.
    const double z = theta == kPi / 2 ? 0 : std::cos(theta);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), z};
}

void add_grid(std::vector<DirectionPair>& all)
{
    constexpr int kAngles = 19, kAzimuths = 24;
    for (int o = 0; o < kAngles; ++o)
        for (int i = 0; i < kAngles; ++i)
            for (int a = 0; a < kAzimuths; ++a)
                for (const double turned : {0.0, 2.1})
                    all.push_back({"grid",
                                   {toward(o * kPi / 36, turned),
                                    toward(i * kPi / 36, turned + 2 * kPi * a / kAzimuths)}});
}

void add_random(std::vector<DirectionPair>& all)
{
    std::mt19937 engine(7);
    const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    for (int n = 0; n < 20000; ++n) {
        const double o = std::acos(uniform()), i = std::acos(uniform());
        all.push_back(
            {"random",
             {toward(o, 2 * kPi * (uniform() - 0.5)), toward(i, 2 * kPi * (uniform() - 0.5))}});
    }
}

/// wi = wo, wi the mirror of wo, both at the horizon, opposite each other; and near there.
void add_singular(std::vector<DirectionPair>& all)
{
    std::vector<double> offsets = {0};
    for (int digits = 3; digits <= 15; ++digits)
        offsets.push_back(std::pow(10.0, -digits));
    for (const double theta : {0.0, 1e-9, 0.4, 1.0, 1.5, kPi / 2 - 1e-7, kPi / 2})
        for (const double phi : {0.0, 0.5, kPi / 2, 3.0, -2.0})
            for (const double offset : offsets)
                for (const double side : {0.0, 1.0}) {
                    const double near = std::max(theta - offset, 0.0);
                    const double beside = side * offset;
                    all.push_back({"same", {toward(theta, phi), toward(near, phi + beside)}});
                    all.push_back(
                        {"mirror", {toward(theta, phi), toward(near, phi + kPi + beside)}});
                    all.push_back(
                        {"horizon",
                         {toward(kPi / 2, phi), toward(kPi / 2 - offset, 2 * phi + theta)}});
                    all.push_back({"across", {toward(theta, phi), toward(theta, phi + kPi / 2)}});
                }
}

} // namespace

std::vector<DirectionPair> direction_pairs()
{
    std::vector<DirectionPair> all;
    add_grid(all);
    add_random(all);
    add_singular(all);
    return all;
}

} // namespace scree::test
