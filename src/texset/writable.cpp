#include "texset/writable.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "math/error.h"

namespace scree {

namespace fs = std::filesystem;

namespace {

/// What the links of `path` lead to; `status` is of that.
fs::path end_of_links(const fs::path& path, const fs::file_status& status)
{
    std::error_code failed;
    if (!fs::is_symlink(path, failed))
        return path;
    // A link whose end is not there yet has no canonical form.
    return fs::exists(status) ? fs::canonical(path)
                              : (path.parent_path() / fs::read_symlink(path)).lexically_normal();
}

} // namespace

fs::path file_to_replace(const fs::path& path)
{
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(fmt::format("{}: cannot be written: is a {}, expected a file or a name for one",
                                path.string(),
                                fs::is_directory(status) ? "folder" : "device or a pipe"));
    fs::path file = end_of_links(path, status);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (!fs::is_directory(folder, failed))
        throw Error(fmt::format("{}: cannot be written: there is no folder {}", path.string(),
                                folder.string()));
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw Error(fmt::format("{}: cannot be written: the folder {} takes no files: {}",
                                path.string(), folder.string(), std::strerror(errno)));
    return file;
}

void expect_writable(const fs::path& path) { file_to_replace(path); }

} // namespace scree
