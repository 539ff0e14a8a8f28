#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree {

/// A tile of the texture plane: u in [u, u + 1], v (up) in [v, v + 1].
struct UdimTile {
    int u = 0, v = 0;

    [[nodiscard]] int number() const { return 1001 + u + 10 * v; }
};

/// Numbers are 1001 + u + 10 v, u from 0 to 9, up to 9999.
constexpr int kFirstUdim = 1001, kLastUdim = 9999;
UdimTile udim_tile(int number);

/// False for a tile that has no number: v < 0, or u not in [0, 9].
bool has_number(const UdimTile& tile);

/// Whether a file's name stands for those of many tiles: it has "<UDIM>" for their number.
bool is_tiled(const std::filesystem::path& file);

/// The file of one tile; the file itself where it is not tiled.
std::filesystem::path file_of_tile(const std::filesystem::path& file, int number);

/// The tiles whose files are there, rising.
///
/// Throws Error when the marker is in there twice, or in a folder's name, or the folder cannot be
/// read.
std::vector<int> tiles_of(const std::filesystem::path& tiled);

/// The stem of a file's name without the marker and what joins it to the rest: "rock" of
/// "rock.<UDIM>.exr" and of "rock_<UDIM>.exr".
std::string stem_of(const std::filesystem::path& file);

/// "1001, 1002 and 7 more": at most `most` numbers.
std::string tile_list(const std::vector<int>& numbers, size_t most = 8);

} // namespace scree
