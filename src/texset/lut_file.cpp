#include "texset/lut_file.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "color/refined_map.h"
#include "math/error.h"

namespace scree {

namespace ocio = OCIO_NAMESPACE;

namespace {

constexpr int kPlaces = 65537;
/// Of the largest color: the error of float arithmetic through a LUT.
constexpr double kFloatError = 5e-7;

/// Far beyond any light, but for numbers that stand for infinity.
constexpr float kLargestEntry = 1e30F;

/// What stands before a LUT, per channel: the LUT is asked for gain x + offset.
struct Scaling {
    std::array<double, 3> gain = {1, 1, 1}, offset = {0, 0, 0};

    /// The x that the LUT is asked for `t` by.
    [[nodiscard]] double undone(double t, size_t channel) const
    {
        return (t - offset[channel]) / gain[channel];
    }
};

/// The LUT's place in what OpenColorIO made of the file.
struct Structure {
    Scaling before;
    /// Of the one LUT; 0 when something else than scalings stands beside it, or it is not even.
    unsigned long entries = 0;
};

void follow(Scaling& scaling, const ocio::MatrixTransform& matrix)
{
    std::array<double, 16> m{};
    std::array<double, 4> offset{};
    matrix.getMatrix(m.data());
    matrix.getOffset(offset.data());
    for (size_t c = 0; c < 3; ++c) {
        scaling.gain[c] *= m[5 * c];
        scaling.offset[c] = scaling.offset[c] * m[5 * c] + offset[c];
    }
}

/// OpenColorIO makes 0 of what is not a number, and of infinity the largest there is.
void expect_finite(const ocio::Lut1DTransform& lut, const std::string& file)
{
    for (unsigned long i = 0; i < lut.getLength(); ++i) {
        std::array<float, 3> rgb{};
        lut.getValue(i, rgb[0], rgb[1], rgb[2]);
        for (const float value : rgb)
            if (!(std::abs(value) < kLargestEntry))
                throw Error(fmt::format("{}: entry {} of the LUT is not a finite number", file, i));
    }
}

/// Empty when there is no 1-D LUT; throws when one holds what is no number. Only what runs forward
/// is taken for a scaling: OpenColorIO turns what it can that way itself.
std::optional<Structure> structure_of(const ocio::GroupTransform& group, const std::string& file)
{
    std::optional<Structure> found;
    Scaling before;
    bool plain = true; // nothing but scalings and one LUT so far
    for (int i = 0; i < group.getNumTransforms(); ++i) {
        const auto transform = group.getTransform(i);
        const bool forward = transform->getDirection() == ocio::TRANSFORM_DIR_FORWARD;
        const auto lut = OCIO_DYNAMIC_POINTER_CAST<const ocio::Lut1DTransform>(transform);
        const auto matrix = OCIO_DYNAMIC_POINTER_CAST<const ocio::MatrixTransform>(transform);
        if (lut)
            expect_finite(*lut, file);
        if (lut && !found) {
            plain = plain && forward && !lut->getInputHalfDomain();
            found = Structure{before, lut->getLength()};
        } else if (matrix && forward) {
            if (plain && !found)
                follow(before, *matrix);
        } else {
            plain = false;
        }
    }
    if (found && !plain)
        found->entries = 0;
    return found;
}

ocio::ConstProcessorRcPtr load(const std::filesystem::path& path)
{
    try {
        // What was read from a file of that name before may have changed since.
        ocio::ClearAllCaches();
        ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE); // what is wrong is in the exception
        const auto transform = ocio::FileTransform::Create();
        transform->setSrc(std::filesystem::absolute(path).c_str());
        transform->setInterpolation(ocio::INTERP_LINEAR);
        return ocio::Config::CreateRaw()->getProcessor(transform);
    } catch (const ocio::Exception& e) {
        std::string reason = e.what();
        std::replace(reason.begin(), reason.end(), '\n', ' ');
        throw Error(fmt::format("{}: OpenColorIO cannot read it as a LUT; give a 1-D LUT (.spi1d, "
                                ".cube, .csp, .clf), a .cpt or an image: {}",
                                path.string(), reason));
    }
}

/// Where to put knots: the entries of the LUT, or places evenly over its domain.
std::vector<double> places_of(const Structure& structure, double low, double high)
{
    std::vector<double> places = {low, high};
    for (unsigned long i = 0; structure.entries > 1 && i < structure.entries; ++i)
        for (size_t c = 0; c < 3; ++c)
            places.push_back(structure.before.undone(
                static_cast<double>(i) / static_cast<double>(structure.entries - 1), c));
    for (int i = 1; structure.entries == 0 && i < kPlaces - 1; ++i)
        places.push_back(low + (high - low) * i / (kPlaces - 1));
    std::sort(places.begin(), places.end());
    // The channels' domains are nearly always one and the same, but for rounding.
    const double same = 1e-9 * (high - low);
    places.erase(std::unique(places.begin(), places.end(),
                             [same](double a, double b) { return b - a <= same; }),
                 places.end());
    places.back() = high;
    return places;
}

std::vector<Knot> sampled(const ocio::Processor& processor, const std::vector<double>& places,
                          const std::string& file)
{
    std::vector<float> rgb;
    for (const double x : places)
        rgb.insert(rgb.end(), 3, static_cast<float>(x));
    ocio::PackedImageDesc image(rgb.data(), static_cast<long>(places.size()), 1, 3);
    processor.getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS)->apply(image);
    std::vector<Knot> knots;
    for (size_t i = 0; i < places.size(); ++i) {
        Knot knot{places[i], {}};
        for (size_t c = 0; c < 3; ++c) {
            knot.color[c] = static_cast<double>(rgb[3 * i + c]);
            if (!std::isfinite(knot.color[c]))
                throw Error(fmt::format("{}: the LUT gives no finite color at {}", file, knot.x));
        }
        knots.push_back(knot);
    }
    return knots;
}

} // namespace

bool is_lut_ending(const std::string& ending)
{
    for (int i = 0; i < ocio::FileTransform::GetNumFormats(); ++i)
        if (ending == std::string(".") + ocio::FileTransform::GetFormatExtensionByIndex(i))
            return true;
    return false;
}

ColorMapFile read_lut(const std::filesystem::path& path)
{
    const auto name = path.string();
    const auto processor = load(path);
    if (processor->hasChannelCrosstalk())
        throw Error(fmt::format("{}: a 3-D LUT or another mixing of channels; expected a 1-D LUT, "
                                "which gives a color for each number",
                                name));
    const auto structure = structure_of(*processor->createGroupTransform(), name);
    if (!structure)
        throw Error(fmt::format("{}: holds no LUT; expected a 1-D LUT", name));

    double low = structure->before.undone(0, 0), high = low;
    for (size_t c = 0; c < 3; ++c)
        for (const double end : {0.0, 1.0}) {
            low = std::min(low, structure->before.undone(end, c));
            high = std::max(high, structure->before.undone(end, c));
        }
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high))
        throw Error(fmt::format("{}: the LUT's domain is {} to {}; expected a range of numbers",
                                name, low, high));
    // "From 0 1" may come back as 1e-17.
    const bool unit = std::abs(low) < 1e-6 && std::abs(high - 1) < 1e-6;
    if (unit) {
        low = 0;
        high = 1;
    }
    const ColorMap map(sampled(*processor, places_of(*structure, low, high), name));
    double largest = 0;
    for (const Knot& k : map.knots())
        for (const double c : k.color)
            largest = std::max(largest, std::abs(c));
    return {without_collinear_knots(map, kFloatError * largest), !unit, std::nullopt,
            ocio::ROLE_SCENE_LINEAR, "lut"};
}

} // namespace scree
