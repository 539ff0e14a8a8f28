// Bakes a slope made on the fly and reads its manifest: consumer FOLDER.

#include <kernel/filter.h>
#include <pipeline/bake.h>
#include <string>
#include <texset/manifest.h>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

/// A plane of slope (0.5, -0.25) on a map of 40 x 24 texels of size 1.
class Plane : public scree::Source {
public:
    std::string name() const override { return "plane"; }
    int width() const override { return 40; }
    int height() const override { return 24; }
    bool has_heights() const override { return true; }
    bool has_color() const override { return false; }
    void rewind(bool /*last_time*/) override { next_row_ = 0; }
    void read(int count, scree::SurfaceRows& rows) override
    {
        rows = {};
        for (int row = 0; row < count; ++row, ++next_row_)
            for (int x = 0; x < width(); ++x)
                rows.height.push_back(0.5 * x - 0.25 * next_row_);
    }
    const scree::Rejects& rejects() const override { return rejects_; }

private:
    int next_row_ = 0;
    scree::Rejects rejects_;
};

} // namespace

Imath::V3f shade(const scree::filter::SlopeMoments<float>& slope, float tau,
                 const Imath::V3f& color, float h, float hh, const Imath::V3f& color_height,
                 const Imath::V3f& to_viewer, const Imath::V3f& to_light, float base_alpha);

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    try {
        Plane plane;
        scree::BakeOptions options;
        options.output = argv[1];
        options.texel_size = {{1, 1}};
        options.wrap_s = options.wrap_t = scree::Wrap::clamp;
        scree::Manifest manifest;
        manifest.name = "plane";
        scree::bake(plane, options, manifest);

        const scree::Manifest read = scree::read_manifest(options.output);
        const auto slope = read.levels.back().mean_slope.value();
        std::printf("%s %dx%d, %zu levels, slope %.6f %.6f\n", read.name.c_str(), read.width,
                    read.height, read.levels.size(), slope[0], slope[1]);

        // That plane of color 0.5, seen and lit from straight above, and next to no gloss.
        const Imath::V3f up(0, 0, 1);
        const Imath::V3f seen = shade({0.5F, 0.25F, -0.125F, -0.25F, 0.0625F}, 0, Imath::V3f(0.5F),
                                      0, 0, Imath::V3f(0), up, up, 5.0F);
        std::printf("shaded %.3f\n", static_cast<double>(seen.x));
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
    return 0;
}
