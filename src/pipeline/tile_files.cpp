#include "pipeline/tile_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "math/error.h"
#include "pipeline/baked_mesh.h"
#include "texset/udim.h"

namespace scree {

namespace {

std::vector<int> without(const std::vector<int>& numbers, const std::vector<int>& others)
{
    std::vector<int> left;
    std::set_difference(numbers.begin(), numbers.end(), others.begin(), others.end(),
                        std::back_inserter(left));
    return left;
}

std::vector<int> united(const std::vector<int>& numbers, const std::vector<int>& others)
{
    std::vector<int> all;
    std::set_union(numbers.begin(), numbers.end(), others.begin(), others.end(),
                   std::back_inserter(all));
    return all;
}

/// Numbers between two others of the same row.
std::vector<int> gaps_of(const std::vector<int>& numbers)
{
    std::vector<int> gaps;
    for (size_t i = 1; i < numbers.size(); ++i)
        if (udim_tile(numbers[i]).v == udim_tile(numbers[i - 1]).v)
            for (int number = numbers[i - 1] + 1; number < numbers[i]; ++number)
                gaps.push_back(number);
    return gaps;
}

std::string tiles(const std::vector<int>& numbers)
{
    return (numbers.size() == 1 ? "tile " : "tiles ") + tile_list(numbers);
}

} // namespace

TileFiles find_tiles(const BakeOptions& options, const BakedMesh* mesh)
{
    const std::string height = options.height_file.string(), color = options.color_file.string();
    TileFiles found;
    found.numbers = tiles_of(options.height_file);
    if (found.numbers.empty())
        throw Error(fmt::format("{}: there is no tile; expected {}, or another number from {} on",
                                height, file_of_tile(options.height_file, kFirstUdim).string(),
                                kFirstUdim));
    const auto warn = [&found](const std::vector<int>& numbers, const std::string& why) {
        if (!numbers.empty())
            found.warnings.push_back(tiles(numbers) + ": " + why);
    };
    std::vector<int> any = found.numbers; // of height or color
    if (!color.empty()) {
        const std::vector<int> colored = tiles_of(options.color_file);
        any = united(any, colored);
        const std::vector<int> plain = without(found.numbers, colored);
        warn(plain, fmt::format("no {}; left out", color));
        warn(without(colored, found.numbers), fmt::format("no {}; left out", height));
        found.numbers = without(found.numbers, plain);
        if (found.numbers.empty())
            throw Error(fmt::format("{} and {} have no tile in common", height, color));
    }
    if (mesh == nullptr) {
        warn(gaps_of(any), fmt::format("no {}, though the row goes on", height));
        return found;
    }
    const std::vector<int> reached = mesh->tiles();
    const std::vector<int> idle = without(found.numbers, reached);
    warn(without(reached, found.numbers),
         fmt::format("no {}, though faces of {} reach there", height, mesh->name()));
    warn(idle, fmt::format("no face of {} reaches there; left out", mesh->name()));
    found.numbers = without(found.numbers, idle);
    if (found.numbers.empty())
        throw Error(fmt::format("{}: has faces in {} of the texture, {} has none of them",
                                mesh->name(), tiles(reached), height));
    return found;
}

} // namespace scree
