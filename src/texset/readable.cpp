#include "texset/readable.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "math/error.h"

namespace scree {

namespace fs = std::filesystem;

void expect_readable(const fs::path& path, const std::string& expected)
{
    std::error_code failed;
    const auto status = fs::status(path, failed);
    if (status.type() == fs::file_type::not_found)
        throw Error(fmt::format("{}: no such file", path.string()));
    if (failed)
        throw Error(fmt::format("{}: {}", path.string(), failed.message()));
    if (fs::is_directory(status))
        throw Error(fmt::format("{}: is a folder, expected {}", path.string(), expected));
    if (fs::is_regular_file(status) && fs::file_size(path) == 0)
        throw Error(fmt::format("{}: the file is empty", path.string()));
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0)
        throw Error(fmt::format("{}: {}{}", path.string(), std::strerror(errno),
                                errno == EMFILE ? "; allow more of them (ulimit -n)" : ""));
    close(file);
}

} // namespace scree
