#include "chart/asset.h"

#include <fmt/format.h>

#include <stdexcept>

#include "judge/original.h"
#include "math/error.h"
#include "sample/field.h"

namespace scree {

namespace {

/// A sample's rows as a source.
class SampleSource final : public Source {
public:
    explicit SampleSource(const SampleField& field) : field_(field) {}

    [[nodiscard]] std::string name() const override { return field_.info().kind; }
    [[nodiscard]] int width() const override { return field_.info().width_texels; }
    [[nodiscard]] int height() const override { return field_.info().height_texels; }
    [[nodiscard]] bool has_heights() const override { return true; }
    [[nodiscard]] bool has_color() const override { return true; }
    void rewind(bool /*last_time*/) override { next_row_ = 0; }

    void read(int count, SurfaceRows& rows) override
    {
        const auto across = static_cast<size_t>(width());
        std::vector<float> heights(across);
        rows = {};
        rows.color.resize(3 * across * static_cast<size_t>(count));
        for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
            field_.row(next_row_++, heights.data(), rows.color.data() + 3 * across * i);
            rows.height.insert(rows.height.end(), heights.begin(), heights.end());
        }
    }

    [[nodiscard]] const Rejects& rejects() const override { return rejects_; }

private:
    const SampleField& field_;
    Rejects rejects_;
    int next_row_ = 0;
};

std::unique_ptr<SampleField> field_named(const std::string& kind, int size_texels)
{
    try {
        return make_sample(kind, size_texels, size_texels);
    } catch (const std::invalid_argument& e) {
        throw Error(e.what());
    }
}

/// The part of an asset's options that still matters once its files were read.
BakeOptions shape_of(const BakeOptions& options, const reference::Relief& relief)
{
    BakeOptions shape;
    shape.wrap_s = options.wrap_s;
    shape.wrap_t = options.wrap_t;
    shape.texel_size = {relief.texel_width, relief.texel_height};
    shape.threads = options.threads;
    return shape;
}

} // namespace

Asset sample_asset(const std::string& kind, int size_texels)
{
    const auto field = field_named(kind, size_texels);
    const SampleInfo& info = field->info();
    BakeOptions options;
    options.world_size = {info.world_width, info.world_height};
    options.wrap_s = wrap_named(info.wrap_s);
    options.wrap_t = wrap_named(info.wrap_t);
    SampleSource source(*field);
    reference::Relief relief = read_original(source, options, {}).relief;
    const BakeOptions shape = shape_of(options, relief);
    return {kind, std::move(relief), shape};
}

std::string asset_name(const BakeOptions& options)
{
    return options.name.empty() ? options.height_file.stem().string() : options.name;
}

Asset asset_of(const BakeOptions& options, const BakeMonitor& monitor)
{
    if (options.normal_input)
        throw Error(fmt::format("{}: a normal map has no heights, and without them nothing can be "
                                "displaced to compare with; expected a height map",
                                options.height_file.string()));
    Original original = read_original(options, monitor);
    reference::Relief& relief = original.relief;
    if (!original.has_color)
        relief.colors.assign(relief.heights.size(), {1, 1, 1});
    const BakeOptions shape = shape_of(options, relief);
    return {asset_name(options), std::move(relief), shape};
}

void AssetSource::read(int count, SurfaceRows& rows)
{
    const reference::Relief& relief = asset_.relief;
    const auto across = static_cast<size_t>(relief.width);
    const size_t first = across * static_cast<size_t>(next_row_);
    const size_t last = first + across * static_cast<size_t>(count);
    rows = {};
    for (size_t i = first; i < last; ++i) {
        rows.height.push_back(relief.heights[i]);
        for (const double c : relief.colors[i])
            rows.color.push_back(static_cast<float>(c));
        if (!relief.weights.empty())
            rows.weight.push_back(relief.weights[i]);
    }
    next_row_ += count;
}

} // namespace scree
