#pragma once

#include <memory>
#include <string>
#include <vector>

#include "stats/slope_map.h"

namespace scree {

/// Rows of a surface, in world units and scene-linear color.
///
/// NaN in `height` (or in `slope_s` of a normal map) marks a texel without data; its weight is 0.
struct SurfaceRows {
    std::vector<double> height;           ///< count x width, or empty
    std::vector<double> slope_s, slope_t; ///< count x width, or empty
    std::vector<float> color;             ///< count x width x 3, or empty
    std::vector<float> weight;            ///< count x width, or empty: 1 where there is data
    /// Of slopes found from the heights; count x width, or empty: they stay as they are.
    std::vector<SlopeMap> slope_map;
};

/// Texels that could not be used, by reason, and the first of each.
struct Rejects {
    struct Count {
        long long texels = 0;
        std::string first; ///< file, channel and texel

        Count& operator+=(const Count& other)
        {
            if (first.empty())
                first = other.first;
            texels += other.texels;
            return *this;
        }
    };
    Count not_finite;  ///< NaN or infinity
    Count turned_away; ///< normals with nz <= 0
    Count marked;      ///< equal to --no-data

    Rejects& operator+=(const Rejects& other)
    {
        not_finite += other.not_finite;
        turned_away += other.turned_away;
        marked += other.marked;
        return *this;
    }
};

/// Where a bake gets its surface from: image files, or a field made on the fly.
///
/// Rows are read from the top, as often as the bake needs: rewind() starts over, and says when it
/// is for the last time, so that a source can let go of what it kept. A source gives the same rows
/// every time.
class Source {
public:
    virtual ~Source() = default;

    /// What to call it in messages.
    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual int width() const = 0;
    [[nodiscard]] virtual int height() const = 0;
    [[nodiscard]] virtual bool has_heights() const = 0; ///< else slopes
    [[nodiscard]] virtual bool has_color() const = 0;

    virtual void rewind(bool last_time) = 0;
    /// The next `count` rows; `rows` may hold others, whose memory is used again.
    virtual void read(int count, SurfaceRows& rows) = 0;

    /// Nothing is read before the next rewind: lets go of memory and files that can be had again.
    virtual void rest() {}

    /// Texels rejected since the last rewind.
    [[nodiscard]] virtual const Rejects& rejects() const = 0;
};

} // namespace scree
