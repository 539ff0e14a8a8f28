#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "texset/manifest.h"

namespace scree {

class ColorReader;
class HeightReader;
class NormalReader;

/// A surface from a height or normal map and, if given, a color texture.
///
/// Heights become world units (offset + scale * value), normals slopes (-nx/nz, -ny/nz), colors
/// scene-linear and free of their alpha, as if the file were not premultiplied. A texel is without
/// data when its height, normal or color is not finite, when its normal does not face outward (nz
/// <= 0), when its height is the --no-data value, or, with
/// --alpha-weight, when its alpha is 0 or less.
class FileSource final : public Source {
public:
    /// Throws Error when a file cannot be used: see ImageRows; also when the sizes differ without
    /// --resample, when the height channel is not clear, when a normal map or a color texture has
    /// fewer than 3 channels, when --alpha-weight finds no alpha.
    explicit FileSource(const BakeOptions& options);
    ~FileSource() override;

    /// From now on, decoded rows are kept in unnamed files in this folder for the passes that
    /// follow, if there is room.
    void spool_in(const std::filesystem::path& folder);

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] int width() const override;
    [[nodiscard]] int height() const override;
    [[nodiscard]] bool has_heights() const override;
    [[nodiscard]] bool has_color() const override;
    void rewind(bool last_time) override;
    void read(int count, SurfaceRows& rows) override;
    void rest() override;
    [[nodiscard]] const Rejects& rejects() const override;

    /// Heights in the file that differ by one unit in the last place differ by this, world units;
    /// 0 for floating-point files and normal maps.
    [[nodiscard]] double quantum() const;
    [[nodiscard]] int integer_bits() const;
    [[nodiscard]] std::string working_space() const;
    [[nodiscard]] std::vector<InputRecord> records() const;
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    std::unique_ptr<HeightReader> height_;
    std::unique_ptr<NormalReader> normal_;
    std::unique_ptr<ColorReader> color_;
    int next_row_ = 0;
    Rejects rejects_;
};

} // namespace scree
