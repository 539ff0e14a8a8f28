#include "judge/preview.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "bake/bake_words.h"
#include "bake/commands.h"
#include "bake/supervisor.h"
#include "bake/terminal.h"
#include "judge/inputs.h"
#include "judge/original.h"
#include "pipeline/thread_limit.h"

namespace scree::tool {

namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;

struct PreviewWords {
    std::filesystem::path set, picture, strip;
    std::vector<std::filesystem::path> inputs;
    std::string ocio_config;
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
    command.add_option("set", words.set, "folder or manifest of a texture set")->required();

    auto* files = command.add_option_group("Files");
    files->add_option("-o,--output", words.picture,
                      "picture of a plane that recedes to the horizon; .png, .jpg, .exr");
    files->add_option("--strip", words.strip,
                      "picture of a strip: a tile for each view angle, a row for each part");
    files->add_option("--inputs", words.inputs,
                      "folders with the files the set was baked from [beside the set, the current "
                      "folder]");
    files->add_option("--ocio-config", words.ocio_config,
                      "OpenColorIO config of the bake, where it named one");

    auto* picture = command.add_option_group("Picture");
    picture
        ->add_option("--parts", words.parts, "of the picture, from the left: plain, set, reference")
        ->delimiter(',')
        ->check(CLI::IsMember({"plain", "set", "reference"}))
        ->capture_default_str();
    picture->add_option("--size", words.size, "of the plane's picture, pixels")
        ->expected(2)
        ->check(CLI::Range(8, 16384))
        ->capture_default_str();
    picture
        ->add_option("--view-angle", words.plane.angle_deg,
                     "in the middle, degrees from the normal")
        ->check(CLI::Range(0.0, 89.0))
        ->capture_default_str();
    picture
        ->add_option("--view-azimuth", words.plane.azimuth_deg,
                     "to the viewer, degrees from +s (right) towards +t (down)")
        ->capture_default_str();
    picture->add_option("--field-of-view", words.plane.field_of_view_deg, "of the height, degrees")
        ->check(CLI::Range(0.1, 120.0))
        ->capture_default_str();
    picture->add_option("--repeats", words.plane.repeats, "of the set, across the middle")
        ->check(CLI::Range(0.01, 10000.0))
        ->capture_default_str();
    picture
        ->add_option("--strip-angles", words.strip_shot.angles_deg,
                     "of the strip's views, degrees from the normal")
        ->delimiter(',')
        ->check(CLI::Range(0.0, 89.0))
        ->capture_default_str();
    picture->add_option("--tile", words.strip_shot.tile, "side of a tile of the strip, pixels")
        ->check(CLI::Range(8, 2048))
        ->capture_default_str();
    picture->add_option("--texels-per-pixel", words.strip_shot.texels_per_pixel, "across a tile")
        ->check(CLI::Range(0.01, 10000.0))
        ->capture_default_str();

    auto* look = command.add_option_group("Look");
    look->add_option("--light", words.light,
                     "degrees from the normal, and from +s (right) towards +t (down)")
        ->expected(2)
        ->option_text("ANGLE AZIMUTH [60 200]");
    look->add_option("--base-alpha", words.scene.material.base_alpha,
                     "Beckmann roughness of a facet")
        ->check(CLI::Range(0.001, 1.0))
        ->capture_default_str();
    look->add_option("--f0", words.scene.material.f0, "share of the light that a facet mirrors")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    look->add_option("--exposure", words.scene.exposure,
                     "times radiance over irradiance [fits the picture]")
        ->check(CLI::PositiveNumber);

    auto* running = command.add_option_group("Running");
    running
        ->add_option("--samples", words.samples,
                     "rays a pixel of the reference, rounded up to a square")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    running->add_option("--seed", words.scene.seed, "of the samples")->capture_default_str();
    running->add_option("--threads", words.threads, "number of threads [all]")
        ->check(CLI::NonNegativeNumber);
    running->add_flag("--quiet", words.quiet, "no progress, no figures");
}

void interpret(PreviewWords& words)
{
    if (words.picture.empty() && words.strip.empty())
        throw UsageError("no picture is asked for; name one with -o or --strip");
    const double angle = words.light[0] * kRadPerDegree, azimuth = words.light[1] * kRadPerDegree;
    if (!(words.light[0] >= 0 && words.light[0] < 90))
        throw UsageError(fmt::format("--light {:g}: the angle of the light from the normal has to "
                                     "be at least 0 and below 90 degrees",
                                     words.light[0]));
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
}

bool needs_surface(const PreviewScene& scene)
{
    return std::find(scene.parts.begin(), scene.parts.end(), PreviewPart::truth) !=
           scene.parts.end();
}

/// What the set was baked from, going on over its edges.
reference::DisplacedSurface read_surface(const PreviewWords& words, const Manifest& manifest)
{
    const InputFiles files = find_inputs(manifest, words.set, words.inputs);
    BakeOptions options = options_of_manifest(manifest, files);
    options.ocio_config = words.ocio_config;
    note_for_supervisor({files.height.string(), files.color.string(), files.colormap.string()}, "");
    Progress progress(words.quiet);
    BakeMonitor monitor;
    monitor.progress = [&progress](const char* phase, double done) { progress.show(phase, done); };
    monitor.cancel = &stop_asked();
    Original original = read_original(options, monitor);
    if (original.relief.heights.empty())
        throw Error(fmt::format("{}: was baked from a normal map, which has no surface to trace; "
                                "leave the reference out with --parts plain,set",
                                words.set.string()));
    original.relief.beyond_s = original.relief.beyond_t = reference::Beyond::repeats;
    return reference::DisplacedSurface(std::move(original.relief));
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
    for (const PreviewError& error : preview.errors)
        fmt::print("  {:4.1f} degrees  {:9}  brightness {:.3f} of the reference, rms error of "
                   "radiance {:.3f}\n",
                   error.angle_deg, preview_part_name(error.part), error.brightness, error.rms);
    if (preview.samples > 0)
        fmt::print("  reference: {} samples, {} rays in {:.1f} s, {:.2f} million samples a second; "
                   "its own noise {:.3f}\n",
                   preview.samples, preview.rays, preview.seconds,
                   static_cast<double>(preview.samples) / preview.seconds / 1e6, preview.noise);
}

void run(PreviewWords& words)
{
    interpret(words);
    const ThreadLimit limit(words.threads);
    TextureFilter filter;
    filter.is_tiled = true;
    const SetLookup set(words.set, filter);
    const Manifest& manifest = set.manifest();
    std::optional<reference::DisplacedSurface> surface;
    if (needs_surface(words.scene))
        surface = read_surface(words, manifest);
    const reference::DisplacedSurface* truth = surface ? &*surface : nullptr;

    Progress progress(words.quiet);
    words.scene.progress = [&progress](double done) {
        if (stop_asked())
            throw Cancelled();
        progress.show("trace", done);
    };
    if (!words.quiet && (manifest.wrap_s != "periodic" || manifest.wrap_t != "periodic"))
        fmt::print("note: {} was baked with wrap {} {}; it is shown repeated, with its seams\n",
                   manifest.name, manifest.wrap_s, manifest.wrap_t);
    if (!words.picture.empty()) {
        const Preview preview = draw_plane(set, truth, words.scene, words.plane);
        write_picture(preview.picture, words.picture);
        if (!words.quiet) {
            fmt::print("{}: from the left {}; exposure {:.3g}\n", words.picture.string(),
                       parts_of(words.scene), preview.exposure);
            print(preview);
        }
    }
    if (!words.strip.empty()) {
        const Preview preview = draw_strip(set, truth, words.scene, words.strip_shot);
        write_picture(preview.picture, words.strip);
        if (!words.quiet) {
            fmt::print("{}: from the top {}; from the left {} degrees; exposure {:.3g}\n",
                       words.strip.string(), parts_of(words.scene),
                       fmt::join(words.strip_shot.angles_deg, ", "), preview.exposure);
            print(preview);
        }
    }
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
