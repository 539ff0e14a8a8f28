#pragma once

#include <vector>

#include "pipeline/moment_pyramid.h"
#include "pipeline/texture_values.h"

namespace scree {

/// Measures what storing a map as half or as float costs, without writing it.
///
/// The error is that of what a reader recovers from the stored numbers, the largest over all
/// texels of all levels:
///   slope, bumpslopes  covariance (ss, tt, st), over the largest variance of its level or of the
///                      next, which filtering between texels brings in (one slope a texel, as of
///                      normal maps, has no variance of its own at level 0); of bumpslopes
///                      also the world height, over its deviation over the map
///   height             variance of hn, over 1 (the variance of the whole map, by normalisation)
///   color              mean color, over the largest of the level
///   visible            the color told from a component, likewise
///   colorheight        covariance with hn, over the map's standard deviation of color, or a tenth
///                      of its largest color where that is more
///   colorslope         covariance with the slope, over that times the deviation of the slope
///   rank               a coefficient, over the same as for colorheight
///   tail               the number itself
///   coverage           the number, over itself: a weight that gets lost is data that gets lost
/// Where a level's slope varies less than float resolves (1e-6 of its mean square) that is the
/// yardstick. A number beyond the type's range counts as an error of kLost. The gutter is not
/// looked at (pipeline/gutter.h): it has no truth, and means of stored numbers are in the type's
/// range.
class StorageError : public TexelVisitor {
public:
    static constexpr double kLost = 1e9;

    StorageError(Map map, const MomentLayout& layout, const ValueScale& scale, int width,
                 int height);

    void texels(int level, int y, int x0, int count, MomentRow row) override;

    [[nodiscard]] double half_error() const;
    [[nodiscard]] double float_error() const;

private:
    /// Largest figures of one block of columns of one level.
    struct Largest {
        double half = 0, single = 0;               ///< absolute errors
        double half_height = 0, single_height = 0; ///< of world heights, over h1
        double variance = 0, square = 0;           ///< of the slope
        double color = 0;
    };
    template <class Store>
    double largest_error(int level, MomentRow row, int count) const;
    template <class Store>
    double world_height_error(MomentRow row, int count) const;
    [[nodiscard]] Largest largest_of(size_t level) const;
    [[nodiscard]] double yardstick(const Largest& level, const Largest& next) const;
    [[nodiscard]] double relative(double Largest::*error, double Largest::*height_error) const;

    Map map_;
    MomentLayout layout_;
    ValueScale scale_;
    std::vector<std::vector<Largest>> blocks_;                             ///< [level][block]
    double color_deviation_ = 0, slope_deviation_ = 0, largest_color_ = 0; ///< of the whole map
};

} // namespace scree
