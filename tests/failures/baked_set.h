#pragma once

#include <memory>
#include <string>
#include <vector>

#include "failures/failure_case.h"
#include "judge/set_reader.h"
#include "pipeline/options.h"
#include "support/files.h"
#include "support/memory_source.h"

namespace scree::test {

/// A set that was baked into a folder of its own, to be read as a renderer would.
class BakedSet {
public:
    explicit BakedSet(std::unique_ptr<TempFolder> temp);

    [[nodiscard]] const Manifest& manifest() const { return reader_.manifest(); }
    /// What the manifest says of the whole map.
    [[nodiscard]] const LevelSummary& summary() const { return manifest().levels.back(); }
    [[nodiscard]] const SetColors& colors() const { return reader_.colors(); }
    [[nodiscard]] int levels() const { return static_cast<int>(manifest().levels.size()); }
    [[nodiscard]] int width(int level) const;
    [[nodiscard]] int height(int level) const;

    [[nodiscard]] const SetTexel& texel(int level, int x, int y);
    /// The one texel of the 1x1 level: the whole map.
    [[nodiscard]] SetTexel top() { return texel(levels() - 1, 0, 0); }

private:
    std::unique_ptr<TempFolder> temp_;
    SetReader reader_;
    std::vector<SetTexel> row_; ///< the last one asked for
    int row_level_ = -1, row_y_ = -1;
};

/// Texels of one unit, edges as given, float, all maps the surface allows.
BakeOptions plain_options(Wrap wrap = Wrap::periodic);

/// The same with slope, color and tables of visibility alone: four nodes, two harmonics.
BakeOptions table_options(Wrap wrap = Wrap::periodic);

BakedSet baked(const MemorySource& surface, const BakeOptions& options);
/// From options.height_file.
BakedSet baked_file(const BakeOptions& options);

/// The heights scaled to an RMS slope (both axes together), texels of one unit.
MemorySource scaled_to_slope(MemorySource surface, double rms_slope);

/// What `scree validate` says of a surface (judge/asset_flags.h), one entry a sentence; an empty
/// one where it says nothing.
std::vector<OurWords> flags_of(const std::string& asset, const MemorySource& surface);

/// The mean of a number of the texels of a level.
double mean_over(BakedSet& set, int level, double (*of)(const SetTexel&));

/// Moments of the slope along s as stored: mean, mean square, and the variance they make in double
/// without any repair.
double mean_s(const SetTexel& texel);
double mean_ss(const SetTexel& texel);
double raw_variance_s(const SetTexel& texel);

/// Red of what is seen where a point of rank q is seen with probability q^exponent: by the rank
/// table, and by the line over height.
double red_by_rank(const SetTexel& texel, double exponent);
double red_by_height(const SetTexel& texel, double exponent);
/// Red of what `wo` sees, by the color's correlation with slope alone.
double red_by_slope(const SetTexel& texel, const Vec3f& wo);
/// The same by the table of the set's color map.
double red_by_map(const BakedSet& set, const SetTexel& texel, const Vec3f& wo);

/// The same by the set's tables of visibility.
double red_by_tables(const BakedSet& set, const SetTexel& texel, const Vec3f& wo);

/// Smith's masking by the kernel: Lambda, G1.
double lambda_of(const filter::Slopes<float>& slopes, const Vec3f& wo);
double g1_of(const filter::Slopes<float>& slopes, const Vec3f& wo);
/// Covariance of the slopes that `wo` sees.
filter::Covariance<double> seen_covariance(const filter::Slopes<float>& slopes, const Vec3f& wo);

/// Unit vector, degrees from the normal, azimuth from +s towards +t.
Vec3f toward(double angle_deg, double azimuth_deg = 0);

/// "80 degrees".
std::string degrees(double angle);

} // namespace scree::test
