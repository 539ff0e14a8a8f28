#include "pipeline/options.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <utility>

#include "math/error.h"

namespace scree {

namespace {

template <class T>
using Choices = std::initializer_list<std::pair<const char*, T>>;

template <class T>
T named(const char* option, const std::string& name, const Choices<T>& choices)
{
    std::string known;
    for (const auto& [word, value] : choices) {
        if (name == word)
            return value;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", word);
    }
    throw Error(fmt::format("{} '{}' is unknown; use one of {}", option, name, known));
}

template <class T>
std::string name_of(T value, const Choices<T>& choices)
{
    for (const auto& [word, known] : choices)
        if (known == value)
            return word;
    return {};
}

const Choices<Wrap> kWraps = {{"periodic", Wrap::periodic},
                              {"clamp", Wrap::clamp},
                              {"mirror", Wrap::mirror},
                              {"black", Wrap::black}};
const Choices<Reconstruction> kReconstructions = {{"bilinear", Reconstruction::bilinear},
                                                  {"central", Reconstruction::central},
                                                  {"sobel", Reconstruction::sobel}};
const Choices<Layout> kLayouts = {{"scree", Layout::scree}, {"bumpslopes", Layout::bumpslopes}};

} // namespace

void expect_sensible(const BakeOptions& options)
{
    if (options.texel_size && options.world_size)
        throw Error("--texel-size and --world-size say the same thing; give one of them");
    auto expect_positive = [](const auto& size, const char* option) {
        if (size)
            for (const double side : *size)
                if (!(side > 0) || !std::isfinite(side))
                    throw Error(
                        fmt::format("{}: {} is no size; give world units above 0", option, side));
    };
    expect_positive(options.texel_size, "--texel-size");
    expect_positive(options.world_size, "--world-size");
    if (!std::isfinite(options.height_scale) || !std::isfinite(options.height_offset))
        throw Error("--height-scale and --height-offset must be finite");
    if (!(options.half_tolerance >= 0))
        throw Error("--half-tolerance must be 0 or more");
    if (options.output.empty())
        throw Error("no output folder; give -o DIR");
    if (options.layout == Layout::bumpslopes && !options.maps.empty())
        throw Error("--maps goes with --layout scree; bumpslopes is one file of its own");
}

void BakeMonitor::report(const char* phase, double done) const
{
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed))
        throw Cancelled();
    if (progress)
        progress(phase, done);
}

Wrap wrap_named(const std::string& name) { return named("--wrap", name, kWraps); }

std::string wrap_name(Wrap wrap) { return name_of(wrap, kWraps); }

Reconstruction reconstruction_named(const std::string& name)
{
    return named("--reconstruction", name, kReconstructions);
}

std::string reconstruction_name(Reconstruction reconstruction)
{
    return name_of(reconstruction, kReconstructions);
}

PixelTypeChoice pixel_type_choice_named(const std::string& name)
{
    return named<PixelTypeChoice>("--pixel-type", name,
                                  {{"auto", PixelTypeChoice::automatic},
                                   {"half", PixelTypeChoice::half},
                                   {"float", PixelTypeChoice::float32}});
}

Layout layout_named(const std::string& name) { return named("--layout", name, kLayouts); }

std::string layout_name(Layout layout) { return name_of(layout, kLayouts); }

NormalRange normal_range_named(const std::string& name)
{
    return named<NormalRange>("--normal-range", name,
                              {{"auto", NormalRange::automatic},
                               {"unsigned", NormalRange::unsigned_unit},
                               {"signed", NormalRange::signed_unit}});
}

bool input_is_normal(const std::string& name)
{
    return named<bool>("--input", name, {{"height", false}, {"normal", true}});
}

} // namespace scree
