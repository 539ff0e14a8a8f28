#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "bake/commands.h"
#include "bake/supervisor.h"
#include "bake/terminal.h"
#include "math/error.h"
#include "version.h"

namespace {

constexpr int kFailed = 1, kUsage = 2, kInterrupted = 130;

/// What is wrong with the command line; `e` alone does not name a command that is none.
std::string usage_error(const CLI::App& app, const CLI::ParseError& e)
{
    const CLI::App* asked = &app; // the innermost command that was named
    std::string name = "scree";
    while (!asked->get_subcommands().empty()) {
        asked = asked->get_subcommands().front();
        name += " " + asked->get_name();
    }
    const auto unknown = asked->remaining();
    const bool wants_command = asked->get_require_subcommand_min() > 0;
    if (!wants_command || unknown.empty())
        return fmt::format("{}; see {} --help", e.what(), name);
    const std::string& word = unknown.front();
    return fmt::format("there is no {} '{}'; see {} --help",
                       word.rfind('-', 0) == 0 ? "option" : "command", word, name);
}

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
    scree::tool::add_table(app);
    scree::tool::add_validate(app);
    scree::tool::add_chart(app);
    scree::tool::stop_on_signals();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) // --help and --version come this way too
            return app.exit(e);
        throw scree::tool::UsageError(usage_error(app, e));
    }
    return 0;
}

/// Throws std::system_error, as fmt::print does earlier, when what was printed did not arrive.
void expect_printed()
{
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw std::system_error(errno, std::generic_category());
}

int complain(const char* what, int status)
{
    std::fprintf(stderr, "scree: error: %s\n", what);
    return status;
}

int guarded(int argc, char** argv)
{
    try {
        const int status = run(argc, argv);
        expect_printed();
        return status;
    } catch (const scree::Cancelled&) {
        std::fputs("scree: stopped; nothing was written\n", stderr);
        return kInterrupted;
    } catch (const scree::tool::UsageError& e) {
        return complain(e.what(), kUsage);
    } catch (const std::bad_alloc&) {
        return complain("out of memory", kFailed);
    } catch (const std::system_error& e) {
        if (std::ferror(stdout) == 0)
            return complain(e.what(), kFailed);
        return complain(fmt::format("standard output: cannot be written: {}; send it elsewhere",
                                    e.code().message())
                            .c_str(),
                        kFailed);
    } catch (const std::exception& e) {
        return complain(e.what(), kFailed);
    }
}

} // namespace

int main(int argc, char** argv)
{
    return scree::tool::run_supervised([argc, argv] { return guarded(argc, argv); });
}
