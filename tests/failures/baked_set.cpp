#include "failures/baked_set.h"

#include <cmath>
#include <utility>

#include "judge/asset_flags.h"
#include "pipeline/bake.h"

namespace scree::test {
namespace {

constexpr const char* kFolder = "set";

double red(const SetTexel& texel, ColorModel model, bool by_slope, const Vec3f& wo, double exponent)
{
    const auto lambda = static_cast<float>(exponent);
    return static_cast<double>(color_of_exponent(texel, {}, model, by_slope, wo, lambda)[0]);
}

} // namespace

BakedSet::BakedSet(std::unique_ptr<TempFolder> temp)
    : temp_(std::move(temp)), reader_(*temp_ / kFolder)
{}

int BakedSet::width(int level) const { return manifest().levels[static_cast<size_t>(level)].width; }

int BakedSet::height(int level) const
{
    return manifest().levels[static_cast<size_t>(level)].height;
}

const SetTexel& BakedSet::texel(int level, int x, int y)
{
    if (level != row_level_ || y != row_y_) {
        row_ = reader_.row(level, y);
        row_level_ = level;
        row_y_ = y;
    }
    return row_[static_cast<size_t>(x)];
}

BakeOptions plain_options(Wrap wrap)
{
    BakeOptions options;
    options.texel_size = {{1, 1}};
    options.wrap_s = options.wrap_t = wrap;
    options.pixel_type = PixelTypeChoice::float32;
    return options;
}

BakeOptions table_options(Wrap wrap)
{
    BakeOptions options = plain_options(wrap);
    options.maps = {Map::slope, Map::color, Map::visible};
    options.table.harmonics = 2;
    return options;
}

BakedSet baked(const MemorySource& surface, const BakeOptions& options)
{
    auto temp = std::make_unique<TempFolder>();
    MemorySource source = surface;
    BakeOptions all = options;
    all.output = *temp / kFolder;
    Manifest manifest;
    manifest.name = "asset";
    bake(source, all, manifest);
    return BakedSet(std::move(temp));
}

BakedSet baked_file(const BakeOptions& options)
{
    auto temp = std::make_unique<TempFolder>();
    BakeOptions all = options;
    all.output = *temp / kFolder;
    bake(all);
    return BakedSet(std::move(temp));
}

MemorySource scaled_to_slope(MemorySource surface, double rms_slope)
{
    BakeOptions options = plain_options();
    options.maps = {Map::slope};
    const double scale = rms_slope / *baked(surface, options).summary().rms_slope;
    for (double& height : surface.heights)
        height *= scale;
    return surface;
}

std::vector<OurWords> flags_of(const std::string& asset, const MemorySource& surface)
{
    MemorySource source = surface;
    const BakeOptions options = plain_options();
    const Original original = read_original(source, options, {});
    std::vector<OurWords> all;
    for (const std::string& flag : asset_flags(original, options.reconstruction))
        all.push_back({asset, flag});
    if (all.empty())
        all.push_back({asset, ""});
    return all;
}

double mean_over(BakedSet& set, int level, double (*of)(const SetTexel&))
{
    double sum = 0;
    for (int y = 0; y < set.height(level); ++y)
        for (int x = 0; x < set.width(level); ++x)
            sum += of(set.texel(level, x, y));
    return sum / (set.width(level) * set.height(level));
}

double mean_s(const SetTexel& texel) { return static_cast<double>(texel.slope.s); }
double mean_ss(const SetTexel& texel) { return static_cast<double>(texel.slope.ss); }
double raw_variance_s(const SetTexel& texel)
{
    return mean_ss(texel) - mean_s(texel) * mean_s(texel);
}

double red_by_rank(const SetTexel& texel, double exponent)
{
    return red(texel, ColorModel::rank, false, {0, 0, 1}, exponent);
}

double red_by_height(const SetTexel& texel, double exponent)
{
    return red(texel, ColorModel::height, false, {0, 0, 1}, exponent);
}

double red_by_slope(const SetTexel& texel, const Vec3f& wo)
{
    return red(texel, ColorModel::mean, true, wo, 0);
}

double red_by_map(const BakedSet& set, const SetTexel& texel, const Vec3f& wo)
{
    const auto lambda = static_cast<float>(lambda_of(slopes_of(texel), wo));
    return static_cast<double>(
        color_of_exponent(texel, set.colors(), ColorModel::map, false, wo, lambda)[0]);
}

double red_by_tables(const BakedSet& set, const SetTexel& texel, const Vec3f& wo)
{
    return static_cast<double>(visible_color(texel, set.colors(), ColorModel::visible, wo)[0]);
}

double lambda_of(const filter::Slopes<float>& slopes, const Vec3f& wo)
{
    return static_cast<double>(filter::masking(wo, slopes).lambda);
}

double g1_of(const filter::Slopes<float>& slopes, const Vec3f& wo)
{
    return static_cast<double>(filter::masking(wo, slopes).g1);
}

filter::Covariance<double> seen_covariance(const filter::Slopes<float>& slopes, const Vec3f& wo)
{
    const auto [ss, st, tt] = filter::visible_slopes(wo, slopes).covariance;
    return {static_cast<double>(ss), static_cast<double>(st), static_cast<double>(tt)};
}

Vec3f toward(double angle_deg, double azimuth_deg)
{
    const double degree = std::acos(-1.0) / 180;
    const double theta = angle_deg * degree, phi = azimuth_deg * degree;
    return {static_cast<float>(std::sin(theta) * std::cos(phi)),
            static_cast<float>(std::sin(theta) * std::sin(phi)),
            static_cast<float>(std::cos(theta))};
}

std::string degrees(double angle) { return std::to_string(std::lround(angle)) + " degrees"; }

} // namespace scree::test
