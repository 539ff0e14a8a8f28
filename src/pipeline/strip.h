#pragma once

#include <memory>
#include <vector>

#include "pipeline/mapped_color.h"
#include "pipeline/options.h"
#include "pipeline/source.h"
#include "pipeline/survey.h"
#include "stats/height_rows.h"
#include "stats/moment_layout.h"
#include "visibility/visible_bands.h"

namespace scree {

/// What lies beyond the edge of a map with this wrap.
Edge edge_of(Wrap wrap, Reconstruction reconstruction);

/// A strip of rows with what its texels need from beside it.
struct Strip {
    int first_row = 0, count = 0;
    SurfaceRows rows; ///< heights excepted, which `padded` holds
    /// Rows first_row - 1 to first_row + count, each width + 2 heights in world units, the texels
    /// beyond the map filled in from its surroundings, or by its wrap; empty for a normal map.
    std::vector<std::vector<double>> padded;
    std::shared_ptr<const VisibleBand> seen; ///< band with these rows; null where none is asked for
};

/// Cuts a source into strips, in order, reading one strip ahead.
class StripReader {
public:
    /// seen       gives every strip what views see of it; may be null
    /// last_time  nothing will read the source after this
    StripReader(Source& source, const Survey& survey, const BakeOptions& options,
                VisibleBands* seen, bool last_time);

    /// False at the end of the map. `strip` may hold another, whose memory is used again.
    bool next(Strip& strip);

private:
    void read_ahead();
    /// y  the row that it is of
    void pad(const double* heights, int y, std::vector<double>& row) const;
    /// The row above the first, or below the last.
    [[nodiscard]] std::vector<double> beyond(Side side, const std::vector<double>& last,
                                             const std::vector<double>& before_last) const;

    Source& source_;
    const Survey& survey_;
    VisibleBands* seen_;
    const Surroundings* around_;
    Edge edge_s_, edge_t_;
    int next_row_ = 0;
    SurfaceRows ahead_; ///< the strip at next_row_
    std::vector<std::vector<double>> ahead_padded_;
    std::vector<double> above_; ///< the padded row before next_row_
};

/// Level-0 moments from strips.
class TexelMoments {
public:
    /// mapped  colors texels instead of the source; may be null
    TexelMoments(const MomentLayout& layout, const Survey& survey, const BakeOptions& options,
                 const MappedColor* mapped, int width, double texel_width, double texel_height);

    /// Texels [x0, x0 + count) of row `y` of the map, which lies in `strip`.
    void fill(const Strip& strip, int y, int x0, int count, MomentRow out) const;

private:
    void fill_heights(const double* heights, int count, MomentRow out) const;
    void fill_colors(const float* rgb, int count, MomentRow out) const;
    void fill_mapped_colors(const double* heights, int count, MomentRow out) const;
    void fill_seen(const VisibleBand& seen, int y, int x0, int count, MomentRow out) const;

    MomentLayout layout_;
    const Survey& survey_;
    const MappedColor* mapped_;
    Reconstruction reconstruction_;
    int width_;
    double texel_width_, texel_height_;
};

} // namespace scree
