#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "bake/commands.h"
#include "bake/terminal.h"
#include "math/error.h"
#include "version.h"

int main(int argc, char** argv)
{
    constexpr int kFailed = 1, kUsage = 2, kInterrupted = 130;

    CLI::App app{"Scree bakes height maps and colors into MIP-mapped texture sets that show a "
                 "rough, colored surface right at every distance."};
    app.name("scree");
    app.set_version_flag("--version", fmt::format("scree {}", scree::kVersion));
    app.require_subcommand(1);
    app.get_formatter()->column_width(40);
    scree::tool::add_bake(app);
    scree::tool::add_info(app);
    scree::tool::add_sample(app);

    try {
        scree::tool::stop_on_signals();
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : kUsage;
    } catch (const scree::Cancelled&) {
        fmt::print(stderr, "scree: stopped; nothing was written\n");
        return kInterrupted;
    } catch (const scree::tool::UsageError& e) {
        fmt::print(stderr, "scree: error: {}\n", e.what());
        return kUsage;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "scree: error: out of memory\n");
        return kFailed;
    } catch (const std::exception& e) {
        fmt::print(stderr, "scree: error: {}\n", e.what());
        return kFailed;
    }
    return 0;
}
