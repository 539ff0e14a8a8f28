#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace scree {

/// What is known about a sample without looking at it; NaN where nothing is.
///
/// The variances are central and over the whole map. Slopes are world units / world units, s to the
/// right, t down, heights in world units.
struct KnownAnswers {
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    double mean_s = kUnknown;
    double mean_t = kUnknown;
    double var_ss = kUnknown;
    double var_tt = kUnknown;
    double cov_st = kUnknown;
    double mean_height = kUnknown;
    double std_height = kUnknown;
};

/// A sample's metadata: what a bake has to be told, and what it has to find.
struct SampleInfo {
    std::string kind;
    std::string description; // one line, no full stop
    int width_texels = 0;
    int height_texels = 0;
    double world_width = 0; // of the whole map, so that slopes are plausible
    double world_height = 0;
    std::string wrap_s; // "periodic" or "clamp": the wrap the map was made for
    std::string wrap_t;

    /// Of the bilinear interpolation of the heights at the texel centres, continued by the wrap:
    /// what a bake measures. mean_height and std_height are of the texels' own values.
    KnownAnswers bilinear;
    /// Of the surface itself, before it was sampled: the limit of ever finer maps.
    KnownAnswers continuous;
};

/// A height map and a color map that exist one row at a time.
///
/// Rows may be asked for in any order and by any number of threads: nothing is kept between calls,
/// and an object holds no more than a few values per column. Same kind and size, same values, on
/// every run.
class SampleField {
public:
    virtual ~SampleField() = default;
    SampleField(const SampleField&) = delete;
    SampleField& operator=(const SampleField&) = delete;

    const SampleInfo& info() const { return info_; }

    /// One row of texels.
    ///
    /// y        row, 0 at t = 0; outside [0, height) it is brought inside by the wrap
    /// heights  receives width values, world units
    /// rgb      receives 3 x width values, interleaved, scene-linear in [0, 1]; may be null
    void row(int y, float* heights, float* rgb) const;

protected:
    explicit SampleField(SampleInfo info);

private:
    /// As row(), with y inside the map.
    virtual void evaluate(int y, float* heights, float* rgb) const = 0;

    SampleInfo info_;
};

/// The kinds make_sample() knows, in the order to list them.
std::vector<std::string> sample_kinds();

/// A field by name. The known answers of each kind are derived in analytic.cpp; the fractal and the
/// bricks only know that a periodic surface has no mean slope.
///
/// throws std::invalid_argument for an unknown kind (the message lists the known ones) or a size
///        below 1 or above 2^20 texels
std::unique_ptr<SampleField> make_sample(const std::string& kind, int width_texels,
                                         int height_texels);

} // namespace scree
