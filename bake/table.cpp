#include "bake/table.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>

#include "bake/checks.h"
#include "bake/commands.h"
#include "bake/given_options.h"
#include "bake/supervisor.h"
#include "bake/terminal.h"
#include "pipeline/thread_limit.h"
#include "texset/staged_folder.h"
#include "texset/table_file.h"
#include "version.h"

namespace scree::tool {

namespace {

/// What says how to run and not what to make.
const std::set<std::string> kNotRecorded = {"help", "output", "threads", "quiet", "inputs"};

void print_summary(const TableManifest& manifest, const std::filesystem::path& folder)
{
    std::string sizes, quantities;
    for (const TableAxis& axis : manifest.axes)
        sizes +=
            fmt::format("{}{} {}", sizes.empty() ? "" : " x ", axis.coordinates.size(), axis.name);
    for (const TableChannel& channel : manifest.channels)
        quantities += fmt::format(", {} = {}", channel.name, channel.quantity);
    std::error_code ignored;
    const auto bytes = std::filesystem::file_size(folder / manifest.texture_file(), ignored);
    fmt::print("{}: {}\n  {} {}x{}{} {:.1f} kB\n", folder.string(), sizes, manifest.texture_file(),
               manifest.width(), manifest.height(), quantities, static_cast<double>(bytes) / 1000);
    for (const TableFigure& figure : manifest.figures)
        fmt::print("  {}: {:.3g}\n", figure.name, figure.value);
}

} // namespace

void add_table_options(CLI::App& command, TableWords& words)
{
    command.add_option("-o,--output", words.folder,
                       "folder for the table, made or replaced [named after its kind]");
    command.add_option("--threads", words.threads, "number of threads [all]")
        ->check(whole_number_from(0));
    command.add_flag("--quiet", words.quiet, "no progress, no summary");
}

std::array<int, 3> sizes_named(const std::string& option, const std::string& word, int most,
                               const std::string& usual)
{
    constexpr int kLeast = 2;
    std::array<int, 3> sizes{};
    const char* at = word.data();
    const char* end = at + word.size();
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto [next, failed] = std::from_chars(at, end, sizes[axis]);
        const bool ends = axis == 2 ? next == end : next != end && *next == 'x';
        if (failed != std::errc() || sizes[axis] < kLeast || sizes[axis] > most || !ends)
            throw UsageError(
                fmt::format("{}: expected three numbers from {} to {}, such as {}, got '{}'",
                            option, kLeast, most, usual, word));
        at = axis == 2 ? next : next + 1;
    }
    return sizes;
}

void make_table(const CLI::App& command, const std::string& kind, const TableWords& words,
                const std::function<MadeTable(const std::function<void(double)>& progress)>& make)
{
    const std::filesystem::path output =
        words.folder.empty() ? std::filesystem::path(kind) : words.folder;
    note_for_supervisor({}, output);
    MadeTable made;
    {
        StagedFolder folder(output,
                            FolderKind::table); // first, so that a bad -o fails before the work
        const ThreadLimit limit(words.threads);
        Progress progress(words.quiet);
        made = make([&progress](double done) {
            if (stop_asked())
                throw Cancelled();
            progress.show("table", done);
        });
        made.manifest.program_version = kVersion;
        for (const auto& [name, value] : given_options(command, kNotRecorded))
            made.manifest.options[name] = value;
        write_table(made.manifest, made.values, folder.path());
        folder.publish();
    }
    if (!words.quiet)
        print_summary(made.manifest, output);
}

void add_table(CLI::App& app)
{
    auto* command =
        app.add_subcommand("table", "tables that stand for themselves, as textures for shaders");
    command->require_subcommand(1);
    add_linear_light_table(*command);
    add_brdf_table(*command);
    command->footer("docs/tables.md explains each table and how a shader reads it.");
}

} // namespace scree::tool
