#include "texset/manifest.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "math/error.h"
#include "texset/manifest_json.h"

namespace scree {

namespace fs = std::filesystem;
namespace {

constexpr const char* kSuffix = ".scree.json";

bool is_manifest(const fs::path& file)
{
    const std::string name = file.filename().string();
    const std::string suffix = kSuffix;
    return name.size() > suffix.size() &&
           name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
}

fs::path manifest_file(const fs::path& set)
{
    std::error_code failed;
    if (!fs::exists(set, failed))
        throw Error(fmt::format("{}: no such folder or manifest", set.string()));
    if (!fs::is_directory(set))
        return set;
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(set, failed))
        if (is_manifest(entry.path()))
            found.push_back(entry.path());
    if (failed)
        throw Error(fmt::format("{}: {}", set.string(), failed.message()));
    if (found.empty())
        throw Error(fmt::format("{}: no texture set here (no *{})", set.string(), kSuffix));
    if (found.size() > 1)
        throw Error(
            fmt::format("{}: {} manifests here; name one of them", set.string(), found.size()));
    return found.front();
}

} // namespace

void write_manifest(const Manifest& manifest, const fs::path& folder)
{
    const fs::path path = folder / (manifest.name + kSuffix);
    std::ofstream file(path, std::ios::binary);
    file << to_json(manifest);
    file.close();
    if (!file)
        throw Error(fmt::format("{}: cannot write the manifest; is there room on the disk?",
                                path.string()));
}

Manifest read_manifest(const fs::path& set)
{
    const fs::path path = manifest_file(set);
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Error(fmt::format("{}: cannot be opened", path.string()));
    std::stringstream text;
    text << file.rdbuf();
    try {
        return manifest_of(text.str());
    } catch (const Error& e) {
        throw Error(fmt::format("{}: {}", path.string(), e.what()));
    }
}

std::set<std::string> files_of_set(const fs::path& folder)
{
    std::set<std::string> files;
    try {
        const fs::path path = manifest_file(folder);
        for (const auto& texture : read_manifest(path).textures)
            files.insert(texture.file);
        files.insert(path.filename().string());
    } catch (const Error&) {
        return {}; // no set, or none we can read: not ours to replace
    }
    return files;
}

} // namespace scree
