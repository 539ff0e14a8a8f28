#include "sample/field.h"

#include "sample/kinds.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace scree {
namespace {

// Keeps the fixed-point phases of lattice_noise.h and every index below inside their types.
constexpr int kMaxTexels = 1 << 20;

struct Maker {
    const char* kind;
    std::unique_ptr<SampleField> (*make)(int width, int height);
};

constexpr Maker kMakers[] = {
    {"fractal", make_fractal}, {"bricks", make_bricks}, {"vgroove", make_vgroove},
    {"sine", make_sine},       {"plane", make_plane},
};

} // namespace

SampleField::SampleField(SampleInfo info) : info_(std::move(info)) {}

void SampleField::row(int y, float* heights, float* rgb) const
{
    const int n = info_.height_texels;
    if (info_.wrap_t == "periodic")
        y = (y % n + n) % n;
    else
        y = std::clamp(y, 0, n - 1);
    evaluate(y, heights, rgb);
}

std::vector<std::string> sample_kinds()
{
    std::vector<std::string> kinds;
    for (const Maker& maker : kMakers)
        kinds.push_back(maker.kind);
    return kinds;
}

std::unique_ptr<SampleField> make_sample(const std::string& kind, int width_texels,
                                         int height_texels)
{
    if (std::min(width_texels, height_texels) < 1 ||
        std::max(width_texels, height_texels) > kMaxTexels)
        throw std::invalid_argument("sample " + kind + ": size " + std::to_string(width_texels) +
                                    "x" + std::to_string(height_texels) + ", expected 1 to " +
                                    std::to_string(kMaxTexels) + " texels a side");
    std::string known;
    for (const Maker& maker : kMakers) {
        if (kind == maker.kind)
            return maker.make(width_texels, height_texels);
        known += known.empty() ? maker.kind : std::string(", ") + maker.kind;
    }
    throw std::invalid_argument("unknown sample \"" + kind + "\"; choose one of " + known);
}

} // namespace scree
