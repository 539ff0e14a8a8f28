// Bakes a fractal terrain made on the fly, so that sizes beyond any disk can be tried.
//
//   scree_bench_synthetic SIZE [FOLDER] [half|float|auto] [none|zip]
//
// Memory is for /usr/bin/time to measure; the program prints the time of the bake alone and deletes
// what it wrote.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/bake.h"
#include "sample/field.h"

namespace {

/// A built-in sample as a source of rows; heights only.
class FieldSource final : public scree::Source {
public:
    explicit FieldSource(int size) : field_(scree::make_sample("fractal", size, size)) {}

    [[nodiscard]] std::string name() const override { return "fractal"; }
    [[nodiscard]] int width() const override { return field_->info().width_texels; }
    [[nodiscard]] int height() const override { return field_->info().height_texels; }
    [[nodiscard]] bool has_heights() const override { return true; }
    [[nodiscard]] bool has_color() const override { return false; }
    [[nodiscard]] const scree::SampleInfo& info() const { return field_->info(); }
    [[nodiscard]] const scree::Rejects& rejects() const override { return rejects_; }

    void rewind(bool /*last_time*/) override { next_row_ = 0; }

    void read(int count, scree::SurfaceRows& rows) override
    {
        const auto row_size = static_cast<size_t>(width());
        row_.resize(row_size);
        rows.height.resize(static_cast<size_t>(count) * row_size);
        double* out = rows.height.data();
        for (int row = 0; row < count; ++row) {
            field_->row(next_row_++, row_.data(), nullptr);
            for (const float h : row_)
                *out++ = static_cast<double>(h);
        }
    }

private:
    std::unique_ptr<scree::SampleField> field_;
    scree::Rejects rejects_;
    std::vector<float> row_;
    int next_row_ = 0;
};

int run(int argc, char** argv)
{
    if (argc < 2) {
        std::fputs("usage: scree_bench_synthetic SIZE [FOLDER] [half|float|auto] [none|zip]\n",
                   stderr);
        return 2;
    }
    FieldSource source(std::atoi(argv[1]));
    scree::BakeOptions options;
    options.output = std::filesystem::path(argc > 2 ? argv[2] : ".") / "synthetic.set";
    options.pixel_type = scree::pixel_type_choice_named(argc > 3 ? argv[3] : "half");
    options.compression = scree::compression_named(argc > 4 ? argv[4] : "zip");
    options.maps = {scree::Map::slope, scree::Map::height};
    options.world_size = {source.info().world_width, source.info().world_height};
    scree::Manifest manifest;
    manifest.name = "synthetic";

    scree::BakeMonitor monitor;
    int shown = -1;
    monitor.progress = [&shown](const char* phase, double done) {
        const int tenth = static_cast<int>(10 * done);
        if (tenth != shown)
            std::fprintf(stderr, "%s %d0 %%\n", phase, tenth);
        shown = tenth;
    };
    const auto begin = std::chrono::steady_clock::now();
    scree::bake(source, options, manifest, monitor);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    std::printf("%dx%d baked in %.1f s\n", source.width(), source.height(), wall.count());
    std::filesystem::remove_all(options.output);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "scree_bench_synthetic: %s\n", e.what());
        return 1;
    }
}
