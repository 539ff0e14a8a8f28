#include "chart/footprints.h"

#include <fmt/format.h>

#include <algorithm>

#include "chart/height_regression.h"
#include "chart/mean_normals.h"
#include "chart/temp_folder.h"
#include "judge/picked_texels.h"
#include "judge/set_reader.h"
#include "math/error.h"
#include "pipeline/bake.h"
#include "texset/mip_reader.h"

namespace scree {

namespace {

constexpr int kFinestLevel = 2;    ///< footprints of 4 x 4 texels
constexpr size_t kChartNodes = 4;  ///< of the tables of visibility
constexpr int kChartHarmonics = 2; ///< likewise, but along axes
constexpr int kChartAzimuths = 8;  ///< that are swept for them

/// A set of the asset in a folder that goes with it.
class TempSet {
public:
    TempSet(const Asset& asset, BakeOptions options, const BakeMonitor& monitor)
    {
        options.output = folder();
        Manifest start;
        start.name = "asset";
        AssetSource source(asset);
        manifest_ = bake(source, options, start, monitor);
    }

    [[nodiscard]] std::filesystem::path folder() const { return folder_.path() / "set"; }
    [[nodiscard]] const Manifest& manifest() const { return manifest_; }

    [[nodiscard]] const TextureRecord& texture(Map map) const
    {
        return *std::find_if(manifest_.textures.begin(), manifest_.textures.end(),
                             [map](const TextureRecord& texture) { return texture.map == map; });
    }

private:
    TempFolder folder_;
    Manifest manifest_;
};

BakeOptions with_all_maps(const Asset& asset)
{
    BakeOptions options = asset.options;
    options.maps = {Map::slope, Map::height, Map::color,    Map::colorheight, Map::colorslope,
                    Map::rank,  Map::tail,   Map::exponent, Map::visible};
    options.rank_terms = 8;
    options.table = {best_node_angles(kChartNodes), kChartHarmonics, kChartAzimuths};
    return options;
}

BakeOptions with_axes(const Asset& asset)
{
    BakeOptions options = asset.options;
    options.maps = {Map::slope, Map::color, Map::visible};
    options.table = {best_node_angles(kChartNodes), 0, kChartAzimuths, true};
    return options;
}

BakeOptions with_sobel_slopes(const Asset& asset)
{
    BakeOptions options = asset.options;
    options.maps = {Map::slope};
    options.reconstruction = Reconstruction::sobel;
    return options;
}

std::map<MethodTexture, PixelType> types_of(const TempSet& set, const TempSet& axes,
                                            const TempSet& sobel)
{
    const PixelType visible = set.texture(Map::visible).type;
    return {{MethodTexture::normal, PixelType::half},
            {MethodTexture::slope, set.texture(Map::slope).type},
            {MethodTexture::sobel, sobel.texture(Map::slope).type},
            {MethodTexture::tail, set.texture(Map::tail).type},
            {MethodTexture::height, set.texture(Map::height).type},
            {MethodTexture::color, set.texture(Map::color).type},
            {MethodTexture::colorheight, set.texture(Map::colorheight).type},
            {MethodTexture::colorslope, set.texture(Map::colorslope).type},
            {MethodTexture::rank, set.texture(Map::rank).type},
            {MethodTexture::visible_2x1, visible},
            {MethodTexture::visible_4x1, visible},
            {MethodTexture::visible_4x3, visible},
            {MethodTexture::visible_4x5, visible},
            {MethodTexture::visible_axes, axes.texture(Map::visible).type}};
}

/// Fewer nodes and harmonics of set.visible.
void take_smaller_tables(FootprintData& data)
{
    constexpr size_t kColors = 4, kTerms = 1 + 2 * kChartHarmonics; // A B G R, of 1 c1 c2 s1 s2
    constexpr std::array<size_t, 3> kFirstHarmonic = {0, 1, 3};     // and the mean
    const auto copy = [&data](size_t node, size_t term, float* to) {
        std::copy_n(data.set.visible.data() + kColors * (kTerms * node + term), kColors, to);
    };
    for (size_t node = 0; node < kChartNodes; ++node) {
        copy(node, 0, data.visible_4x1.data() + kColors * node);
        for (size_t i = 0; i < kFirstHarmonic.size(); ++i)
            copy(node, kFirstHarmonic[i],
                 data.visible_4x3.data() + kColors * (kFirstHarmonic.size() * node + i));
    }
    copy(1, 0, data.visible_2x1.data());
    copy(3, 0, data.visible_2x1.data() + kColors);
}

/// Mean slopes of all texels of level 0.
std::vector<filter::Vec2<float>> finest_slopes(const TempSet& set)
{
    const TextureRecord& texture = set.texture(Map::slope);
    MipReader reader(set.folder() / texture.file);
    const size_t channels = reader.channels().size();
    const auto place = [&reader](const char* name) {
        const auto& all = reader.channels();
        return static_cast<size_t>(std::find(all.begin(), all.end(), name) - all.begin());
    };
    const size_t s = place("s"), t = place("t");
    std::vector<filter::Vec2<float>> slopes;
    for (int y = 0; y < reader.height(0); ++y) {
        const std::vector<float> row = reader.rows(0, y, 1);
        for (size_t i = 0; i < row.size(); i += channels)
            slopes.emplace_back(row[i + s], row[i + t]);
    }
    return slopes;
}

} // namespace

ChartFootprints bake_footprints(const Asset& asset, int count, uint64_t seed,
                                const BakeMonitor& monitor)
{
    const reference::Relief& relief = asset.relief;
    if (std::min(relief.width, relief.height) < 1 << kFinestLevel)
        throw Error(fmt::format("{}: is {}x{} texels; expected at least {}x{}, the smallest "
                                "footprint of a chart",
                                asset.name, relief.width, relief.height, 1 << kFinestLevel,
                                1 << kFinestLevel));
    const TempSet set(asset, with_all_maps(asset), monitor);
    const TempSet axes(asset, with_axes(asset), monitor);
    const TempSet sobel(asset, with_sobel_slopes(asset), monitor);
    const MeanNormals normals(relief, finest_slopes(set));

    ChartFootprints all;
    all.types = types_of(set, axes, sobel);
    all.visibility = set.manifest().visibility.value();
    all.visibility_axes = axes.manifest().visibility.value();
    all.height_colors =
        filtered_by_height(color_by_height(relief, set.manifest().h0, set.manifest().h1));
    SetReader reader(set.folder()), axes_reader(axes.folder()), sobel_reader(sobel.folder());
    for (PickedTexel& picked : pick_texels(reader, kFinestLevel, count, seed)) {
        FootprintData data;
        data.set = picked.texel;
        take_smaller_tables(data);
        const auto same_texel = [&picked](SetReader& of) {
            return of.row(picked.level, picked.y)[static_cast<size_t>(picked.x)];
        };
        const SetTexel along_axes = same_texel(axes_reader);
        std::copy_n(along_axes.visible.begin(), data.visible_axes.size(),
                    data.visible_axes.begin());
        data.sobel = same_texel(sobel_reader).slope;
        data.normal = normals.over(picked.footprint);
        all.data.push_back(data);
        all.places.push_back(std::move(picked.footprint));
    }
    return all;
}

int bytes_per_texel(const Method& method, const std::map<MethodTexture, PixelType>& types)
{
    int bytes = 0;
    for (const Reading& reading : method.reads)
        if (reading.texture != MethodTexture::exponent)
            bytes += reading.channels * static_cast<int>(pixel_bytes(types.at(reading.texture)));
    return bytes;
}

} // namespace scree
