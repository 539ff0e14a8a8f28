#pragma once

#include <filesystem>

namespace scree {

/// A folder of its own for work on the side, removed with it.
class TempFolder {
public:
    /// Throws Error when the system's folder for such things cannot be written to.
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace scree
