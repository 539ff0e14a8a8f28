#include "texset/manifest.h"

#include <fmt/format.h>

#include <cmath>

#include "math/error.h"
#include "texset/manifest_file.h"
#include "texset/manifest_json.h"

namespace scree {

namespace fs = std::filesystem;
namespace {

constexpr const char* kSuffix = ".scree.json";

} // namespace

void write_manifest(const Manifest& manifest, const fs::path& folder)
{
    const fs::path path = folder / (manifest.name + kSuffix);
    write_manifest_file(path, to_json(manifest));
}

Manifest read_manifest(const fs::path& set)
{
    const fs::path path = find_manifest(set, kSuffix, "texture set");
    const std::string text = read_manifest_file(path);
    try {
        return manifest_of(text);
    } catch (const Error& e) {
        throw Error(fmt::format("{}: {}", path.string(), e.what()));
    }
}

std::set<std::string> files_of_set(const fs::path& folder)
{
    std::set<std::string> files;
    try {
        const fs::path path = find_manifest(folder, kSuffix, "texture set");
        for (const auto& texture : read_manifest(path).textures)
            files.insert(texture.file);
        files.insert(path.filename().string());
    } catch (const Error&) {
        return {}; // no set, or none we can read: not ours to replace
    }
    return files;
}

} // namespace scree
