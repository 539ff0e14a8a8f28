#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/baked_mesh.h"
#include "pipeline/displacements.h"
#include "pipeline/map_edges.h"
#include "pipeline/source.h"
#include "surface/texel_metric.h"
#include "texset/spool.h"
#include "texset/udim.h"

namespace scree {

/// A surface whose texture lies on a mesh: heights and colors of another source, with what the mesh
/// says of every texel.
///
/// Texels whose centres lie outside of all UV charts have no data. The others count by the world
/// area of the texel, over that of the largest; and their slopes, found of heights over the texture
/// (one unit wide and high), go through J^-T into the frame that a renderer makes of dP/ds and
/// dP/dt (surface/metric.h, docs/surfaces.md). Normals of a normal map are in that frame already.
class MeshSource final : public Source {
public:
    /// Finds the charts in one tile of the texture.
    ///
    /// flat    must live longer, as the mesh
    /// folder  where what is found takes its room, 20 bytes a texel; without room there it is found
    ///         again for every pass
    MeshSource(Source& flat, const BakedMesh& mesh, const UdimTile& tile,
               const std::filesystem::path& folder, const BakeMonitor& monitor);

    [[nodiscard]] std::string name() const override { return flat_.name(); }
    [[nodiscard]] int width() const override { return flat_.width(); }
    [[nodiscard]] int height() const override { return flat_.height(); }
    [[nodiscard]] bool has_heights() const override { return flat_.has_heights(); }
    [[nodiscard]] bool has_color() const override { return flat_.has_color(); }
    void rewind(bool last_time) override;
    void read(int count, SurfaceRows& rows) override;
    void rest() override;
    [[nodiscard]] const Rejects& rejects() const override { return flat_.rejects(); }

    [[nodiscard]] const BakedMesh& mesh() const { return mesh_; }

    /// Largest world area of a texel, over that of the texture; 0: none lies in a chart.
    [[nodiscard]] double largest_area() const { return largest_area_; }
    /// The area whose texels weigh 1: that of the largest of all tiles.
    void weigh_by(double area) { unit_area_ = area; }

    /// Where the surface is along the sides of the map; without heights.
    [[nodiscard]] const MapEdges& edges() const { return edges_; }

    /// Of the rows read since the last rewind.
    [[nodiscard]] MeshRecord record() const;
    /// What is odd about the charts, a sentence each.
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    /// What a mesh says of a texel, as it is kept.
    struct Texel {
        float area = 0;            ///< world units^2 per texture unit^2; 0: outside
        float a = 1, b = 0, c = 1; ///< SlopeMap
        float curvature = 0;       ///< 1 / world unit
    };

    void find_charts(const BakeMonitor& monitor);
    void find(int first, int count);
    void note_edges(int first, int count);
    void apply(const Texel& texel, size_t index, int y, int x, SurfaceRows& rows);

    Source& flat_;
    const BakedMesh& mesh_;
    UdimTile tile_;
    Spool spool_;
    std::vector<TexelMetric> found_;
    std::vector<Texel> texels_; ///< of the rows read
    MeshRecord record_;
    std::optional<UvOverlap> first_overlap_;
    MapEdges edges_;
    Displacements displacements_;
    double largest_area_ = 0, unit_area_ = 0;
    int next_row_ = 0;
};

} // namespace scree
