#include "bake/recipe.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <toml++/toml.h>
#include <vector>

#include "bake/terminal.h"

namespace scree::tool {

namespace {

constexpr const char* kValidateTable = "validate";

/// Position of a value in the file, for messages.
std::string where(const std::filesystem::path& file, const toml::node& node)
{
    return fmt::format("{}:{}", file.string(), node.source().begin.line);
}

/// A TOML value as the words a command line would hold.
std::vector<std::string> words_of(const toml::node& node, const std::string& key,
                                  const std::filesystem::path& file)
{
    if (const auto* array = node.as_array()) {
        std::vector<std::string> words;
        for (const auto& element : *array)
            for (auto& word : words_of(element, key, file))
                words.push_back(std::move(word));
        return words;
    }
    if (const auto text = node.value_exact<std::string>())
        return {*text};
    if (const auto number = node.value_exact<int64_t>())
        return {fmt::format("{}", *number)};
    if (const auto number = node.value_exact<double>())
        return {fmt::format("{}", *number)};
    if (const auto flag = node.value_exact<bool>())
        return {*flag ? "true" : "false"};
    throw UsageError(fmt::format("{}: '{}' is neither text, number, true/false nor a list of them",
                                 where(file, node), key));
}

bool is_listed(const std::string& keys, const std::string& key)
{
    return ("," + keys + ",").find("," + key + ",") != std::string::npos;
}

toml::table read_recipe(const std::filesystem::path& file)
{
    if (!std::filesystem::exists(file))
        throw UsageError(fmt::format("{}: no such file; expected a recipe", file.string()));
    if (std::filesystem::is_directory(file))
        throw UsageError(fmt::format("{}: is a folder, expected a recipe", file.string()));
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error& e) {
        throw UsageError(
            fmt::format("{}:{}: {}", file.string(), e.source().begin.line, e.description()));
    }
}

/// The options of `command` among the keys of a table.
void apply_table(CLI::App& command, const toml::table& table, const std::filesystem::path& file,
                 const std::string& path_keys)
{
    for (const auto& [toml_key, node] : table) {
        const std::string key(toml_key.str());
        if (key == kValidateTable && node.is_table())
            continue; // what another command is to do with the set
        CLI::Option* option = command.get_option_no_throw("--" + key);
        if (option == nullptr || key == "help")
            throw UsageError(fmt::format("{}: there is no option '{}'; see scree {} --help",
                                         where(file, node), key, command.get_name()));
        if (option->count() > 0)
            continue; // the command line wins
        auto words = words_of(node, key, file);
        if (is_listed(path_keys, key))
            for (auto& word : words)
                word = (file.parent_path() / word).string(); // an absolute one stays as it is
        try {
            if (option->get_expected_max() == 0) { // a flag
                if (words != std::vector<std::string>{"true"} &&
                    words != std::vector<std::string>{"false"})
                    throw CLI::ValidationError("expected true or false");
                if (words.front() == "false")
                    continue;
            }
            option->add_result(words);
            option->run_callback();
        } catch (const CLI::ParseError& e) {
            throw UsageError(fmt::format("{}: {}: {}", where(file, node), key, e.what()));
        }
    }
}

} // namespace

void apply_recipe(CLI::App& command, const std::filesystem::path& file,
                  const std::string& path_keys)
{
    apply_table(command, read_recipe(file), file, path_keys);
}

void apply_validate_table(CLI::App& command, const std::filesystem::path& file,
                          const std::string& path_keys)
{
    const toml::table recipe = read_recipe(file);
    const toml::table* table = recipe[kValidateTable].as_table();
    if (table == nullptr)
        throw UsageError(fmt::format("{}: has no table [{}]; expected one with options of scree "
                                     "validate",
                                     file.string(), kValidateTable));
    apply_table(command, *table, file, path_keys);
}

} // namespace scree::tool
