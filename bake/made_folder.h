#pragma once

#include <filesystem>

namespace scree::tool {

/// A folder for results, made if need be; one that was made goes again when nothing came to lie in
/// it.
class MadeFolder {
public:
    /// Throws Error when it cannot be made.
    explicit MadeFolder(std::filesystem::path path);
    ~MadeFolder();
    MadeFolder(const MadeFolder&) = delete;
    MadeFolder& operator=(const MadeFolder&) = delete;

private:
    std::filesystem::path path_;
    bool made_ = false;
};

} // namespace scree::tool
