#include "texset/writable.h"

#include <fmt/format.h>

#include "math/error.h"

namespace scree {

namespace fs = std::filesystem;

fs::path file_to_replace(const fs::path& path)
{
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(fmt::format("{}: cannot be written: is a {}, expected a file or a name for one",
                                path.string(),
                                fs::is_directory(status) ? "folder" : "device or a pipe"));
    if (!fs::is_symlink(path, failed))
        return path;
    // A link whose end is not there yet has no canonical form.
    return fs::exists(status) ? fs::canonical(path)
                              : (path.parent_path() / fs::read_symlink(path)).lexically_normal();
}

} // namespace scree
