#include "judge/preview.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "bake/checks.h"
#include "bake/commands.h"
#include "bake/set_inputs.h"
#include "bake/terminal.h"
#include "pipeline/thread_limit.h"
#include "report/table.h"

namespace scree::tool {

namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;

struct PreviewWords {
    SetWords set;
    std::filesystem::path picture, strip;
    std::vector<std::string> parts = {"plain", "set", "reference"};
    std::vector<int> size = {960, 360};
    std::vector<double> light = {60, 200};
    PreviewScene scene;
    PlaneShot plane;
    StripShot strip_shot;
    int samples = 64;
    int threads = 0;
    bool quiet = false;
};

void add_options(CLI::App& command, PreviewWords& words)
{
    auto* files = command.add_option_group("Files");
    files->add_option("-o,--output", words.picture,
                      "picture of a plane that recedes to the horizon; .png, .jpg, .exr");
    files->add_option("--strip", words.strip,
                      "picture of a strip: a tile for each view angle, a row for each part");
    add_set_options(command, *files, words.set);

    auto* picture = command.add_option_group("Picture");
    picture
        ->add_option("--parts", words.parts, "of the picture, from the left: plain, set, reference")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"plain", "set", "reference"}))
        ->capture_default_str();
    picture->add_option("--size", words.size, "of the plane's picture, pixels")
        ->expected(2)
        ->check(whole_number_from_to(8, 16384))
        ->capture_default_str();
    picture
        ->add_option("--view-angle", words.plane.angle_deg,
                     "in the middle, degrees from the normal")
        ->check(number_from_to(0, 89))
        ->capture_default_str();
    picture
        ->add_option("--view-azimuth", words.plane.azimuth_deg,
                     "to the viewer, degrees from +s (right) towards +t (down)")
        ->check(finite_number())
        ->capture_default_str();
    picture->add_option("--field-of-view", words.plane.field_of_view_deg, "of the height, degrees")
        ->check(number_from_to(0.1, 120))
        ->capture_default_str();
    picture->add_option("--repeats", words.plane.repeats, "of the set, across the middle")
        ->check(number_from_to(0.01, 10000))
        ->capture_default_str();
    picture
        ->add_option("--strip-angles", words.strip_shot.angles_deg,
                     "of the strip's views, degrees from the normal")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_from_to(0, 89))
        ->capture_default_str();
    picture->add_option("--tile", words.strip_shot.tile, "side of a tile of the strip, pixels")
        ->check(whole_number_from_to(8, 2048))
        ->capture_default_str();
    picture->add_option("--texels-per-pixel", words.strip_shot.texels_per_pixel, "across a tile")
        ->check(number_from_to(0.01, 10000))
        ->capture_default_str();

    auto* look = command.add_option_group("Look");
    look->add_option("--light", words.light,
                     "degrees from the normal, and from +s (right) towards +t (down)")
        ->expected(2)
        ->check(number_from_to(0, 89).application_index(0))
        ->check(finite_number().application_index(1))
        ->option_text("ANGLE AZIMUTH [60 200]");
    look->add_option("--base-alpha", words.scene.material.base_alpha,
                     "Beckmann roughness of a facet")
        ->check(number_from_to(0.001, 1))
        ->capture_default_str();
    look->add_option("--f0", words.scene.material.f0, "share of the light that a facet mirrors")
        ->check(number_from_to(0, 1))
        ->capture_default_str();
    look->add_option("--exposure", words.scene.exposure,
                     "times radiance over irradiance [fits the picture]")
        ->check(number_above_zero());

    auto* running = command.add_option_group("Running");
    running
        ->add_option("--samples", words.samples,
                     "rays a pixel of the reference, rounded up to a square")
        ->check(whole_number_from_to(1, 1 << 20))
        ->capture_default_str();
    running->add_option("--seed", words.scene.seed, "of the samples")->capture_default_str();
    running->add_option("--threads", words.threads, "number of threads [all]")
        ->check(whole_number_from(0));
    running->add_flag("--quiet", words.quiet, "no progress, no figures");
}

void interpret(PreviewWords& words)
{
    if (words.picture.empty() && words.strip.empty())
        throw UsageError("no picture is asked for; name one with -o or --strip");
    for (const auto& file : {words.picture, words.strip})
        if (!file.empty())
            check_picture_name(file);
    const double angle = words.light[0] * kRadPerDegree, azimuth = words.light[1] * kRadPerDegree;
    words.scene.light = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                         std::cos(angle)};
    const std::map<std::string, PreviewPart> parts = {{"plain", PreviewPart::plain},
                                                      {"set", PreviewPart::set},
                                                      {"reference", PreviewPart::truth}};
    words.scene.parts.clear();
    for (const auto& part : words.parts)
        words.scene.parts.push_back(parts.at(part));
    words.scene.grid = static_cast<int>(std::ceil(std::sqrt(words.samples)));
    words.plane.width = words.size[0];
    words.plane.height = words.size[1];
    words.strip_shot.azimuth_deg = words.plane.azimuth_deg;
}

bool needs_surface(const PreviewScene& scene)
{
    return std::find(scene.parts.begin(), scene.parts.end(), PreviewPart::truth) !=
           scene.parts.end();
}

/// What the set was baked from, going on over its edges.
reference::DisplacedSurface read_surface(const PreviewWords& words, const Manifest& manifest)
{
    Progress progress(words.quiet);
    Original original = read_set_inputs(manifest, words.set, monitor_of(progress)).original;
    original.relief.beyond_s = original.relief.beyond_t = reference::Beyond::repeats;
    return surface_for_rays(std::move(original.relief), words.set,
                            "leave the reference out with --parts plain,set");
}

std::string parts_of(const PreviewScene& scene)
{
    std::string list;
    for (const PreviewPart part : scene.parts)
        list += (list.empty() ? "" : ", ") + preview_part_name(part);
    return list;
}

void print(const Preview& preview)
{
    report::Table table{
        "", {"degrees", "plain: brightness", "rms", "set: brightness", "rms", "noise"}, {}};
    for (const PreviewErrors& errors : preview.errors) {
        auto number = [](double value) { return fmt::format("{:.3f}", value); };
        table.rows.push_back({fmt::format("{:g}", errors.angle_deg),
                              number(errors.plain.brightness), number(errors.plain.rms),
                              number(errors.set.brightness), number(errors.set.rms),
                              number(errors.set.noise)});
    }
    if (preview.samples == 0)
        return;
    fmt::print("{}brightness: over that of the reference; rms: error of radiance of a pixel, "
               "relative; noise: the reference's\nown part of it. {} samples, {} rays in {:.1f} s, "
               "{:.2f} million samples a second\n",
               to_text(table), preview.samples, preview.rays, preview.seconds,
               static_cast<double>(preview.samples) / preview.seconds / 1e6);
}

void draw(const PreviewWords& words, const SetLookup& set,
          const reference::DisplacedSurface* surface)
{
    auto finish = [&](const Preview& preview, const std::filesystem::path& file,
                      const std::string& where) {
        write_picture(preview.picture, file);
        if (words.quiet)
            return;
        fmt::print("{}: {}; exposure {:.3g}\n", file.string(), where, preview.exposure);
        print(preview);
    };
    if (!words.picture.empty())
        finish(draw_plane(set, surface, words.scene, words.plane), words.picture,
               "from the left " + parts_of(words.scene));
    if (!words.strip.empty())
        finish(draw_strip(set, surface, words.scene, words.strip_shot), words.strip,
               fmt::format("from the top {}; from the left {} degrees", parts_of(words.scene),
                           fmt::join(words.strip_shot.angles_deg, ", ")));
}

void run(PreviewWords& words)
{
    interpret(words);
    const ThreadLimit limit(words.threads);
    TextureFilter filter;
    filter.is_tiled = true;
    const SetLookup set(words.set.path, filter, words.set.tile);
    const Manifest& manifest = set.manifest();
    std::optional<reference::DisplacedSurface> surface;
    if (needs_surface(words.scene))
        surface = read_surface(words, manifest);
    if (!words.quiet && (manifest.wrap_s != "periodic" || manifest.wrap_t != "periodic"))
        fmt::print("note: {} was baked with wrap {} {}; it is shown repeated, with its seams\n",
                   manifest.name, manifest.wrap_s, manifest.wrap_t);
    Progress progress(words.quiet);
    const BakeMonitor monitor = monitor_of(progress);
    words.scene.progress = [&monitor](double done) { monitor.report("draw", done); };
    draw(words, set, surface ? &*surface : nullptr);
}

} // namespace

void add_preview(CLI::App& app)
{
    auto words = std::make_shared<PreviewWords>();
    auto* command =
        app.add_subcommand("preview", "pictures of a set beside a plain MIP chain and the truth");
    add_options(*command, *words);
    command->footer("Examples:\n"
                    "  scree preview rock.set --inputs textures -o rock.png --strip angles.png\n"
                    "  scree preview rock.set --parts plain,set -o quick.png");
    command->callback([words] { run(*words); });
}

} // namespace scree::tool
