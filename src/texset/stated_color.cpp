#include "texset/stated_color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace scree {

namespace {

using Chromaticities = std::array<float, 8>;

struct LinearSpace {
    const char* name;
    Chromaticities xy;
};

/// ITU-R BT.709 and BT.2020, SMPTE EG 432-1 with a D65 white, SMPTE ST 2065-1, S-2014-004.
constexpr LinearSpace kLinearSpaces[] = {
    {"lin_rec709", {0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F}},
    {"lin_rec2020", {0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F}},
    {"lin_p3d65", {0.680F, 0.320F, 0.265F, 0.690F, 0.150F, 0.060F, 0.3127F, 0.3290F}},
    {"ACES2065-1", {0.7347F, 0.2653F, 0, 1, 0.0001F, -0.0770F, 0.32168F, 0.33767F}},
    {"ACEScg", {0.713F, 0.293F, 0.165F, 0.830F, 0.128F, 0.044F, 0.32168F, 0.33767F}},
};
constexpr float kSamePrimaries = 1e-3F;
constexpr size_t kLongestName = 80;

/// Names end up in messages and in the manifest, which is UTF-8: nothing of a file's bytes goes
/// there unseen.
std::string printable(const std::string& text)
{
    std::string kept = text.substr(0, std::min(text.find('\0'), kLongestName));
    std::replace_if(
        kept.begin(), kept.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return kept;
}

bool contains(const std::string& text, const std::string& lower_case_part)
{
    const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == b; };
    return std::search(text.begin(), text.end(), lower_case_part.begin(), lower_case_part.end(),
                       same) != text.end();
}

std::string space_of(const Chromaticities& xy)
{
    const auto same = [](float a, float b) { return std::abs(a - b) <= kSamePrimaries; };
    for (const LinearSpace& space : kLinearSpaces)
        if (std::equal(xy.begin(), xy.end(), space.xy.begin(), same))
            return space.name;
    return fmt::format("primaries ({:.4g}, {:.4g}) ({:.4g}, {:.4g}) ({:.4g}, {:.4g}), white "
                       "({:.4g}, {:.4g})",
                       xy[0], xy[1], xy[2], xy[3], xy[4], xy[5], xy[6], xy[7]);
}

} // namespace

StatedColor stated_color(const ColorHeader& header)
{
    const std::string plain = printable(header.space);
    if (header.icc_profile) {
        const std::string profile = printable(*header.icc_profile);
        if (contains(profile, "srgb") && !contains(profile, "linear"))
            return {"sRGB", ""};
        return {profile.empty() ? "unnamed ICC profile" : profile, plain};
    }
    if (header.chromaticities)
        return {space_of(*header.chromaticities), plain};
    if (header.aces_container)
        return {"ACES2065-1", ""};
    return {plain, plain == "Gamma2.2" ? "sRGB" : ""};
}

} // namespace scree
