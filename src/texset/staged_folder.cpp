#include "texset/staged_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "math/error.h"
#include "texset/manifest.h"

namespace scree {

namespace fs = std::filesystem;

namespace {

/// The folder's name without a trailing slash, so that a sibling can be named after it.
fs::path without_trailing_slash(const fs::path& folder)
{
    return folder.has_filename() ? folder : folder.parent_path();
}

/// Throws unless `folder` is absent, empty, or holds just one texture set.
void expect_replaceable(const fs::path& folder)
{
    std::error_code failed;
    if (!fs::exists(fs::symlink_status(folder, failed)))
        return;
    if (!fs::is_directory(folder))
        throw Error(
            fmt::format("{}: exists and is not a folder; choose another -o", folder.string()));
    if (fs::is_empty(folder))
        return;
    const auto owned = files_of_set(folder);
    if (owned.empty())
        throw Error(fmt::format("{}: not empty, and no texture set; choose a new folder for -o",
                                folder.string()));
    for (const auto& entry : fs::directory_iterator(folder))
        if (owned.count(entry.path().filename().string()) == 0)
            throw Error(fmt::format("{}: holds '{}', which is not part of its texture set; move "
                                    "it away or choose another -o",
                                    folder.string(), entry.path().filename().string()));
}

} // namespace

StagedFolder::StagedFolder(const fs::path& folder) : folder_(without_trailing_slash(folder))
{
    if (folder_.empty())
        throw Error("-o: no folder given");
    try {
        expect_replaceable(folder_);
        if (folder_.has_parent_path())
            fs::create_directories(folder_.parent_path());
        staging_ = folder_.parent_path() /
                   fmt::format(".{}.scree-{}", folder_.filename().string(), getpid());
        fs::remove_all(staging_); // of a killed run with the same process id
        fs::create_directory(staging_);
    } catch (const fs::filesystem_error& e) {
        throw Error(
            fmt::format("{}: cannot write beside it: {}", folder_.string(), e.code().message()));
    }
}

StagedFolder::~StagedFolder()
{
    std::error_code ignored; // nothing left to do about it
    fs::remove_all(staging_, ignored);
}

void StagedFolder::publish()
{
    if (!fs::exists(folder_)) {
        if (std::rename(staging_.c_str(), folder_.c_str()) != 0)
            throw Error(fmt::format("{}: cannot rename the finished set: {}", folder_.string(),
                                    std::strerror(errno)));
        return;
    }
    // One system call: there is no moment without a set. The old one is then in staging_, and
    // goes with it.
    if (renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, folder_.c_str(), RENAME_EXCHANGE) == 0)
        return;
    // Some network file systems cannot exchange; step aside, then in.
    const fs::path aside = staging_.string() + ".old";
    if (std::rename(folder_.c_str(), aside.c_str()) != 0)
        throw Error(fmt::format("{}: cannot replace the old set: {}", folder_.string(),
                                std::strerror(errno)));
    if (std::rename(staging_.c_str(), folder_.c_str()) != 0) {
        const int reason = errno;
        std::rename(aside.c_str(), folder_.c_str());
        throw Error(fmt::format("{}: cannot rename the finished set: {}", folder_.string(),
                                std::strerror(reason)));
    }
    fs::remove_all(aside);
}

} // namespace scree
