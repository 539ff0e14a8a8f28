#pragma once

#include <array>
#include <string>
#include <vector>

#include "color/map_table.h"
#include "pipeline/moment_pyramid.h"
#include "pipeline/texture_values.h"
#include "texset/manifest.h"

namespace scree {

/// Measures what every way to show the visible color costs, over the views a recipe allows.
///
/// Truth is the footprint itself, its points of rank u seen with probability u^Lambda
/// (stats/ranks.h), Lambda being that of the kernel; so what is measured is the loss of the
/// color model, not that of Smith's masking. Elevations are a quarter, a half, three quarters and
/// all of the largest view angle, azimuths +s, +t, -s, -t. The error of a model is the rms over
/// texels, azimuths and R, G, B, of the worst level and elevation, relative to the rms of the map's
/// mean color. The models stop at black, as the kernel does: of negative colors that is part of
/// their error.
///
/// Two maps are judged by what the view loses without them: color-slope by the color it would
/// add, likewise relative; tail by how much it changes the projected area, relative, and the
/// visible mean slope.
///
/// Texels are picked by a hash of their place, about 2^18 level-0 texels' worth a level, 64 texels
/// at least; the same ones for any number of threads.
class ModelErrors : public TexelVisitor {
public:
    /// layout  with slope and color; with ranks where there are heights
    /// scale   world heights from normalised ones, which `table` is looked up with
    /// table   of a color map by height, or null
    ModelErrors(const MomentLayout& layout, const ValueScale& scale, const MapTable* table,
                double max_view_angle_deg, int width, int height);

    void texels(int level, int y, int x0, int count, MomentRow row) override;
    void profiles(int level, int y, int x0, int count, MomentRow row,
                  const ProfileRow& profiles) override;

    /// The models of color by height, cheapest first.
    [[nodiscard]] std::vector<ModelRecord> color_models() const;
    /// What is lost without a map.
    [[nodiscard]] double without_colorslope() const;
    [[nodiscard]] double without_tail() const;

private:
    static constexpr int kElevations = 4, kAzimuths = 4;

    /// Squared errors of one model.
    using Squares = std::array<double, kElevations>;
    struct Sums {
        double seen = 0, judged = 0; ///< weight of the texels in texels() and in profiles()
        std::vector<Squares> models;
        Squares colorslope{}, tail{};
    };
    struct Model {
        std::string name;
        int channels;
        int rank_terms; ///< of a rank table, else 0
    };
    struct View {
        double x, y, z;
    };
    [[nodiscard]] bool is_picked(int level, int x, int y) const;
    [[nodiscard]] Rgb shown(const Model& model, MomentRow texel, double lambda) const;
    void add_profile(MomentRow texel, const RankProfile& profile, Sums& sums) const;
    void add_slopes(MomentRow texel, Sums& sums) const;
    /// Rms over texels of the worst level and elevation.
    template <class Of>
    [[nodiscard]] double worst(double Sums::*weight, Of squares) const;

    MomentLayout layout_;
    ValueScale scale_;
    const MapTable* table_;
    std::vector<Model> models_;
    std::array<std::array<View, kAzimuths>, kElevations> views_;
    std::vector<double> picked_;            ///< share of the texels of a level
    std::vector<std::vector<Sums>> blocks_; ///< [level][block]
    Rgb mean_color_{};                      ///< of the whole map: of the last level's one texel
};

} // namespace scree
