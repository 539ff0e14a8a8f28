#pragma once

#include <filesystem>
#include <vector>

namespace scree {

/// What a folder is made to hold.
enum class FolderKind { texture_set, table };

/// A folder that appears whole or not at all.
///
/// Files are written into a hidden folder beside the final one; publish() puts it in place in one
/// rename, exchanging it with what may stand there. Without publish() the destructor
/// removes what was written, with the parents made for it, and what stood there before is
/// untouched. A link to a folder stays a link: what it points to is replaced.
class StagedFolder {
public:
    /// Throws Error when the parent cannot be made or written to, or when `folder` exists and is
    /// neither empty nor of that kind (a manifest and the files it names, nothing else): Scree
    /// replaces its own and nothing a user put there, and a table, quickly made, is no reason for
    /// the end of a set.
    explicit StagedFolder(const std::filesystem::path& folder,
                          FolderKind kind = FolderKind::texture_set);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    /// Removes what a process that died was writing for `folder`; never throws.
    static void remove_leftovers(const std::filesystem::path& folder, int process) noexcept;

    /// Where to write.
    [[nodiscard]] const std::filesystem::path& path() const { return staging_; }

    void publish();

private:
    void remove_made();

    std::filesystem::path folder_;
    std::filesystem::path staging_;
    std::vector<std::filesystem::path> made_; ///< parents that were not there before
};

} // namespace scree
