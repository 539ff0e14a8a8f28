#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/file_source.h"
#include "pipeline/mesh_source.h"
#include "pipeline/surface.h"
#include "texset/udim.h"

namespace scree {

/// One map of a bake with what it is read from: all there is, or a tile.
class BakedMap {
public:
    /// A surface that comes from elsewhere than files; both must live longer.
    BakedMap(Source& source, const BakeOptions& options);

    /// tile  its number, for names with <UDIM>; 0: the files are those of the options
    /// Throws Error as FileSource does.
    BakedMap(const BakeOptions& options, int tile);

    [[nodiscard]] int number() const { return number_; } ///< 0: no tile
    [[nodiscard]] UdimTile tile() const { return number_ == 0 ? UdimTile() : udim_tile(number_); }
    [[nodiscard]] std::string name() const { return source().name(); } ///< for messages
    [[nodiscard]] const BakeOptions& options() const { return options_; }
    [[nodiscard]] Source& source() const;
    [[nodiscard]] FileSource* files() const { return files_.get(); } ///< null: from elsewhere
    [[nodiscard]] MeshSource* mesh() const { return mesh_.get(); }   ///< null: on a plane

    /// Lays it on a mesh, which must live longer; `folder` is for what MeshSource keeps.
    void lay_on(const BakedMesh& mesh, const std::filesystem::path& folder,
                const BakeMonitor& monitor);

    Survey found;                     ///< once it was surveyed
    std::unique_ptr<Surface> surface; ///< once `found` holds for all maps

private:
    BakeOptions options_; ///< with the files of the tile
    int number_ = 0;
    Source* given_ = nullptr;
    std::unique_ptr<FileSource> files_;
    std::unique_ptr<MeshSource> mesh_;
};

using BakedMaps = std::vector<std::unique_ptr<BakedMap>>;

} // namespace scree
