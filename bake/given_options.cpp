#include "bake/given_options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scree::tool {

std::map<std::string, std::string> given_options(const CLI::App& command,
                                                 const std::set<std::string>& unrecorded)
{
    std::vector<const CLI::Option*> options = command.get_options();
    for (const CLI::App* group : command.get_subcommands([](const CLI::App*) { return true; }))
        for (const CLI::Option* option : group->get_options())
            options.push_back(option);
    std::map<std::string, std::string> given;
    for (const CLI::Option* option : options) {
        const std::string name =
            option->get_lnames().empty() ? option->get_name() : option->get_lnames().front();
        if (option->count() > 0 && unrecorded.count(name) == 0)
            given[name] = fmt::format("{}", fmt::join(option->results(), " "));
    }
    return given;
}

} // namespace scree::tool
