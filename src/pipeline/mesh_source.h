#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "texset/manifest.h"
#include "texset/spool.h"

namespace scree {

class LimitSurface;
class TexelMetrics;
struct TexelMetric;

/// A surface whose texture lies on a mesh: heights and colors of another source, with what the mesh
/// says of every texel.
///
/// Texels whose centres lie outside of all UV charts have no data. The others count by the world
/// area of the texel, over that of the largest; and their slopes, found of heights over the texture
/// (one unit wide and high), go through J^-T into the frame that a renderer makes of dP/ds and
/// dP/dt (surface/metric.h, docs/surfaces.md). Normals of a normal map are in that frame already.
class MeshSource final : public Source {
public:
    /// Reads the mesh and finds its charts.
    ///
    /// flat    must live longer
    /// folder  where what is found takes its room, 20 bytes a texel; without room there it is found
    ///         again for every pass
    /// Throws Error as read_mesh() and LimitSurface do, and where no texel lies in a chart.
    MeshSource(Source& flat, const BakeOptions& options, const std::filesystem::path& folder,
               const BakeMonitor& monitor);
    ~MeshSource() override;

    [[nodiscard]] std::string name() const override { return flat_.name(); }
    [[nodiscard]] int width() const override { return flat_.width(); }
    [[nodiscard]] int height() const override { return flat_.height(); }
    [[nodiscard]] bool has_heights() const override { return flat_.has_heights(); }
    [[nodiscard]] bool has_color() const override { return flat_.has_color(); }
    void rewind(bool last_time) override;
    void read(int count, SurfaceRows& rows) override;
    [[nodiscard]] const Rejects& rejects() const override { return flat_.rejects(); }

    [[nodiscard]] InputRecord input() const;
    /// Of the rows read since the last rewind.
    [[nodiscard]] MeshRecord record() const { return record_; }
    /// What is odd about the mesh, a sentence each.
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    /// What a mesh says of a texel, as it is kept.
    struct Texel {
        float area = 0;            ///< world units^2 per texture unit^2; 0: outside
        float a = 1, b = 0, c = 1; ///< SlopeMap
        float curvature = 0;       ///< 1 / world unit
    };

    void find_charts(const BakeMonitor& monitor);
    void find(int first, int count, std::vector<Texel>& texels);
    void apply(const Texel& texel, size_t index, int y, int x, SurfaceRows& rows);

    Source& flat_;
    std::filesystem::path file_;
    std::unique_ptr<LimitSurface> surface_;
    std::unique_ptr<TexelMetrics> metrics_;
    Spool spool_;
    std::vector<TexelMetric> found_;
    std::vector<Texel> texels_; ///< of the rows read
    std::vector<std::string> warnings_;
    MeshRecord record_;
    double largest_area_ = 0;
    int next_row_ = 0;
};

} // namespace scree
