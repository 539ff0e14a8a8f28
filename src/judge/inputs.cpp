#include "judge/inputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "texset/file_hash.h"

namespace scree {

namespace fs = std::filesystem;

namespace {

/// All files of that name in the given folders, at any depth, and in those beside the set.
std::vector<fs::path> files_named(const std::string& name, const std::vector<fs::path>& folders,
                                  const std::vector<fs::path>& beside)
{
    std::vector<fs::path> found;
    std::error_code refused;
    for (const fs::path& folder : folders) {
        fs::recursive_directory_iterator entry(
            folder, fs::directory_options::skip_permission_denied, refused);
        for (; !refused && entry != fs::end(entry); entry.increment(refused))
            if (entry->path().filename() == name)
                found.push_back(entry->path());
    }
    for (const fs::path& folder : beside)
        found.push_back(folder / name);
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&refused](const fs::path& file) {
                                   return !fs::is_regular_file(file, refused);
                               }),
                found.end());
    return found;
}

fs::path find_input(const InputRecord& input, const std::vector<fs::path>& folders,
                    const std::vector<fs::path>& beside)
{
    const std::vector<fs::path> candidates = files_named(input.file, folders, beside);
    for (const fs::path& file : candidates)
        if (sha256_of_file(file) == input.sha256)
            return file;
    if (!candidates.empty())
        throw Error(fmt::format("{}: is not the file the set was baked from (SHA-256 {}... "
                                "expected); bake the set again, or name the folder of the original "
                                "with --inputs",
                                candidates.front().string(), input.sha256.substr(0, 12)));
    throw Error(fmt::format("{}: the {} input of the set is neither beside it, nor in the current "
                            "folder, nor in a folder of --inputs; name its folder with --inputs",
                            input.file, input.role));
}

} // namespace

InputFiles find_inputs(const Manifest& manifest, const fs::path& set,
                       const std::vector<fs::path>& folders)
{
    for (const fs::path& folder : folders)
        if (!fs::is_directory(folder))
            throw Error(fmt::format("{}: is no folder; --inputs names folders with the files a "
                                    "set was baked from",
                                    folder.string()));
    fs::path folder = fs::absolute(fs::is_directory(set) ? set : set.parent_path());
    folder = folder.lexically_normal();
    if (folder.filename().empty()) // written with a slash at its end
        folder = folder.parent_path();
    const std::vector<fs::path> beside{folder, folder.parent_path(), fs::current_path()};
    InputFiles files;
    for (const InputRecord& input : manifest.inputs) {
        fs::path& place = input.role == "color"      ? files.color
                          : input.role == "colormap" ? files.colormap
                                                     : files.height;
        place = find_input(input, folders, beside);
    }
    if (files.height.empty())
        throw Error(fmt::format("{}: was not baked from files, so there is nothing to compare it "
                                "with",
                                set.string()));
    return files;
}

} // namespace scree
