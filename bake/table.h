#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "texset/table_manifest.h"

namespace CLI {
class App;
}

namespace scree::tool {

/// The options that every kind of `scree table` has.
struct TableWords {
    std::filesystem::path folder; ///< empty: named after the kind
    int threads = 0;              ///< 0: all
    bool quiet = false;
};

/// Adds -o, --threads and --quiet.
void add_table_options(CLI::App& command, TableWords& words);

/// "AxBxC", each 2 to `most`. Throws UsageError naming the option.
///
/// usual  what the error gives as an example
std::array<int, 3> sizes_named(const std::string& option, const std::string& word, int most,
                               const std::string& usual);

/// What stands in the file.
struct MadeTable {
    TableManifest manifest;
    std::vector<float> values; ///< as write_table() takes them
};

/// Makes a table and writes it into its folder, whole or not at all: with progress, stopped by a
/// signal, and with a summary on stdout unless quiet.
///
/// command  whose options as given the manifest records
/// make     told to report the share that is done; its manifest needs no version, and of options
///          only what those not given stand for
void make_table(const CLI::App& command, const std::string& kind, const TableWords& words,
                const std::function<MadeTable(const std::function<void(double)>& progress)>& make);

/// Each adds a kind to `scree table`.
void add_brdf_table(CLI::App& table);
void add_linear_light_table(CLI::App& table);

} // namespace scree::tool
