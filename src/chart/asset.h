#pragma once

#include <string>

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "reference/relief.h"

namespace scree {

/// A surface to judge ways of filtering on, whole in memory: a source of bakes, and the relief that
/// the reference renderer sees.
struct Asset {
    std::string name;
    reference::Relief relief; ///< with colors: white where there were none
    /// Wrap and texel size; the files were read and are not named any more.
    BakeOptions options;
};

/// A built-in sample (sample/field.h), square, with the wrap and scale it was made for.
/// Throws Error for an unknown kind, or a size that no sample has.
Asset sample_asset(const std::string& kind, int size_texels);

/// What asset_of() calls it: as the options say, else as the height file.
std::string asset_name(const BakeOptions& options);

/// What `scree bake` with these options would read; a color map is already looked up.
/// Throws Error as a bake does, and for normal maps, which have no heights.
Asset asset_of(const BakeOptions& options, const BakeMonitor& monitor = {});

/// An asset's rows, for a bake; the asset must outlive it.
class AssetSource final : public Source {
public:
    explicit AssetSource(const Asset& asset) : asset_(asset) {}

    [[nodiscard]] std::string name() const override { return asset_.name; }
    [[nodiscard]] int width() const override { return asset_.relief.width; }
    [[nodiscard]] int height() const override { return asset_.relief.height; }
    [[nodiscard]] bool has_heights() const override { return true; }
    [[nodiscard]] bool has_color() const override { return true; }
    void rewind(bool /*last_time*/) override { next_row_ = 0; }
    void read(int count, SurfaceRows& rows) override;
    [[nodiscard]] const Rejects& rejects() const override { return rejects_; }

private:
    const Asset& asset_;
    Rejects rejects_;
    int next_row_ = 0;
};

} // namespace scree
