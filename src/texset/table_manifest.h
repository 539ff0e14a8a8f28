#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace scree {

/// What one axis of a table stands for.
struct TableAxis {
    std::string name; ///< "cos theta_v", say
    std::string unit; ///< "radians", or "1" for none
    std::string meaning;
    std::vector<double> coordinates; ///< at the centre of each texel, rising
};

/// What one channel of a table holds.
struct TableChannel {
    std::string name;     ///< in the file; R, G, B and A, so that any reader keeps their order
    std::string quantity; ///< "k", say
    std::string unit;
    std::string meaning;
};

/// A number measured on a table.
struct TableFigure {
    std::string name; ///< with its unit
    double value = 0;
};

/// A table that stands for itself, not for a surface: NAME.scree-table.json.
///
/// The texture has the first axis along its columns; its rows are all others, the second one
/// fastest. A table of three axes is so many slices of first x second, one below the other.
struct TableManifest {
    static constexpr int kFormatVersion = 1;

    std::string kind; ///< "linear-light", say; also what the files are named after
    std::string program_version;
    std::string description; ///< one sentence
    std::vector<TableAxis> axes;
    std::vector<TableChannel> channels;
    std::map<std::string, std::string> options; ///< as given, by long name
    std::vector<TableFigure> figures;           ///< measured on the table

    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    [[nodiscard]] std::string texture_file() const { return kind + ".exr"; }
};

/// Throws Error when the file cannot be written whole.
void write_table_manifest(const TableManifest& manifest, const std::filesystem::path& folder);

/// Reads the manifest of a table: its folder, or the .scree-table.json file itself.
/// Throws Error when there is none or several, or it is damaged or of a later format.
TableManifest read_table_manifest(const std::filesystem::path& table);

/// Names of the files of the table in `folder`, manifest included; empty when there is no table.
std::set<std::string> files_of_table(const std::filesystem::path& folder);

} // namespace scree
