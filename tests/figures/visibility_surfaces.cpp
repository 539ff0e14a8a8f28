#include "figures/visibility_surfaces.h"

#include <string>

#include "chart/temp_folder.h"
#include "pipeline/bake.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSampleTexels = 512;

/// channel  of the height; empty: the only one
Asset from_files(const std::string& name, const fs::path& height, const fs::path& color,
                 const std::string& channel = "")
{
    BakeOptions options;
    options.name = name;
    options.height_file = height;
    options.height_channel = channel;
    options.color_file = color;
    return asset_of(options);
}

} // namespace

std::vector<Asset> visibility_surfaces(const fs::path& data)
{
    std::vector<Asset> all;
    for (const char* kind : {"fractal", "bricks", "vgroove", "sine"})
        all.push_back(sample_asset(kind, kSampleTexels));
    if (data.empty())
        return all;
    const fs::path rock_05 = data / "heights/material/rock_05",
                   rock023 = data / "heights/material/rock023/rock023_alb_ht.png",
                   bricks_02 = data / "heights/structured/bricks_02_256",
                   floor = data / "heights/structured/e7brickfloor01";
    all.push_back(
        from_files("rock_05", rock_05 / "rock_05_bump_1k.png", rock_05 / "rock_05_diff_1k.png"));
    all.push_back(from_files("rock023", rock023, rock023, "A"));
    all.push_back(from_files("bricks_02", bricks_02 / "bricks_02_height_2k_raw.exr",
                             bricks_02 / "bricks_02_basecolor_2k_acescg.exr"));
    all.push_back(from_files("e7brickfloor01", floor / "e7brickfloor01_bump.jpg",
                             floor / "e7brickfloor01.jpg"));
    return all;
}

double rms_slope(const Asset& asset)
{
    const TempFolder folder;
    BakeOptions options = asset.options;
    options.output = folder.path() / "set";
    options.maps = {Map::slope};
    Manifest start;
    start.name = asset.name;
    AssetSource source(asset);
    return bake(source, options, start).levels.front().rms_slope.value();
}

Asset with_heights_scaled(Asset asset, double factor)
{
    for (double& height : asset.relief.heights)
        height *= factor;
    return asset;
}

} // namespace scree::test
