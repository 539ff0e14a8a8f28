#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "bake/commands.h"
#include "bake/supervisor.h"
#include "bake/terminal.h"
#include "math/error.h"
#include "version.h"

namespace {

constexpr int kFailed = 1, kUsage = 2, kInterrupted = 130;

int run(int argc, char** argv)
{
    CLI::App app{"Scree bakes height maps and colors into MIP-mapped texture sets that show a "
                 "rough, colored surface right at every distance."};
    app.name("scree");
    app.set_version_flag("--version", fmt::format("scree {}", scree::kVersion));
    app.require_subcommand(1);
    app.get_formatter()->column_width(40);
    scree::tool::add_bake(app);
    scree::tool::add_info(app);
    scree::tool::add_preview(app);
    scree::tool::add_sample(app);
    scree::tool::add_validate(app);
    scree::tool::add_chart(app);
    scree::tool::stop_on_signals();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) // --help and --version come this way too
            return app.exit(e);
        const auto commands = app.get_subcommands();
        const std::string of = commands.empty() ? "" : commands.front()->get_name() + " ";
        throw scree::tool::UsageError(fmt::format("{}; see scree {}--help", e.what(), of));
    }
    return 0;
}

int complain(const char* what, int status)
{
    std::fprintf(stderr, "scree: error: %s\n", what);
    return status;
}

int guarded(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const scree::Cancelled&) {
        std::fputs("scree: stopped; nothing was written\n", stderr);
        return kInterrupted;
    } catch (const scree::tool::UsageError& e) {
        return complain(e.what(), kUsage);
    } catch (const std::bad_alloc&) {
        return complain("out of memory", kFailed);
    } catch (const std::exception& e) {
        return complain(e.what(), kFailed);
    }
}

} // namespace

int main(int argc, char** argv)
{
    return scree::tool::run_supervised([argc, argv] { return guarded(argc, argv); });
}
