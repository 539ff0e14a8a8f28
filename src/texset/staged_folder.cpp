#include "texset/staged_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <vector>

#include "math/error.h"
#include "texset/manifest.h"
#include "texset/table_manifest.h"

namespace scree {

namespace fs = std::filesystem;

namespace {

/// Where the folder really is, links followed and no dots or slash at its end, so that a sibling
/// can be named after it.
fs::path real_place(const fs::path& folder)
{
    const fs::path place = fs::weakly_canonical(fs::absolute(folder));
    return place.has_filename() ? place : place.parent_path();
}

/// What create_directories() would have to make, outermost first.
std::vector<fs::path> missing_folders(fs::path folder)
{
    std::vector<fs::path> missing;
    for (; !folder.empty() && !fs::exists(folder); folder = folder.parent_path())
        missing.insert(missing.begin(), folder);
    return missing;
}

/// Throws unless `folder` is absent, empty, or holds just one texture set, or table, as asked.
void expect_replaceable(const fs::path& folder, FolderKind kind)
{
    std::error_code failed;
    if (!fs::exists(fs::symlink_status(folder, failed)))
        return;
    if (!fs::is_directory(folder))
        throw Error(
            fmt::format("{}: exists and is not a folder; choose another -o", folder.string()));
    if (fs::is_empty(folder))
        return;
    const bool table = kind == FolderKind::table;
    const char* what = table ? "table" : "texture set";
    const auto owned = table ? files_of_table(folder) : files_of_set(folder);
    if (owned.empty())
        throw Error(fmt::format("{}: not empty, and no {}; choose a new folder for -o",
                                folder.string(), what));
    for (const auto& entry : fs::directory_iterator(folder))
        if (owned.count(entry.path().filename().string()) == 0)
            throw Error(fmt::format("{}: holds '{}', which is not part of its {}; move it away or "
                                    "choose another -o",
                                    folder.string(), entry.path().filename().string(), what));
}

/// The hidden folder in which a process writes what will be `folder`.
fs::path staging_beside(const fs::path& folder, int process)
{
    return folder.parent_path() / fmt::format(".{}.scree-{}", folder.filename().string(), process);
}

} // namespace

StagedFolder::StagedFolder(const fs::path& folder, FolderKind kind)
{
    if (folder.empty())
        throw Error("-o: no folder given");
    try {
        folder_ = real_place(folder);
        expect_replaceable(folder_, kind);
        made_ = missing_folders(folder_.parent_path());
        fs::create_directories(folder_.parent_path());
        staging_ = staging_beside(folder_, getpid());
        fs::remove_all(staging_); // of a killed run with the same process id
        fs::create_directory(staging_);
    } catch (const fs::filesystem_error& e) {
        remove_made();
        throw Error(
            fmt::format("{}: cannot write beside it: {}", folder.string(), e.code().message()));
    }
}

StagedFolder::~StagedFolder()
{
    std::error_code ignored; // nothing left to do about it
    fs::remove_all(staging_, ignored);
    remove_made();
}

void StagedFolder::remove_leftovers(const fs::path& folder, int process) noexcept
{
    try {
        std::error_code ignored;
        fs::remove_all(staging_beside(real_place(folder), process), ignored);
    } catch (const std::exception&) {
        return; // a place that cannot even be named holds nothing of ours
    }
}

void StagedFolder::remove_made()
{
    std::error_code not_empty; // the finished set lies there, or something of someone else's
    for (auto made = made_.rbegin(); made != made_.rend(); ++made)
        fs::remove(*made, not_empty);
}

void StagedFolder::publish()
{
    if (!fs::exists(folder_)) {
        if (std::rename(staging_.c_str(), folder_.c_str()) != 0)
            throw Error(fmt::format("{}: cannot rename the finished folder: {}", folder_.string(),
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
        throw Error(fmt::format("{}: cannot replace the old folder: {}", folder_.string(),
                                std::strerror(errno)));
    if (std::rename(staging_.c_str(), folder_.c_str()) != 0) {
        const int reason = errno;
        std::rename(aside.c_str(), folder_.c_str());
        throw Error(fmt::format("{}: cannot rename the finished folder: {}", folder_.string(),
                                std::strerror(reason)));
    }
    fs::remove_all(aside);
}

} // namespace scree
