#include "texset/manifest_file.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <vector>

#include "math/error.h"

namespace scree {

namespace fs = std::filesystem;

namespace {

bool ends_in(const fs::path& file, const std::string& suffix)
{
    const std::string name = file.filename().string();
    return name.size() > suffix.size() &&
           name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
}

} // namespace

fs::path find_manifest(const fs::path& place, const std::string& suffix, const std::string& what)
{
    std::error_code failed;
    if (!fs::exists(place, failed))
        throw Error(fmt::format("{}: no such folder or manifest", place.string()));
    if (!fs::is_directory(place))
        return place;
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(place, failed))
        if (ends_in(entry.path(), suffix))
            found.push_back(entry.path());
    if (failed)
        throw Error(fmt::format("{}: {}", place.string(), failed.message()));
    if (found.empty())
        throw Error(fmt::format("{}: no {} here (no *{})", place.string(), what, suffix));
    if (found.size() > 1)
        throw Error(
            fmt::format("{}: {} manifests here; name one of them", place.string(), found.size()));
    return found.front();
}

void write_manifest_file(const fs::path& file, const std::string& text)
{
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        throw Error(fmt::format("{}: cannot write the manifest; is there room on the disk?",
                                file.string()));
}

std::string read_manifest_file(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw Error(fmt::format("{}: cannot be opened", file.string()));
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

} // namespace scree
