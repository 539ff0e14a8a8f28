#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace scree {

/// Reads a texture of a set, level by level; the table of a color map has one.
class MipReader {
public:
    /// Throws Error when the file is missing, is no OpenEXR image, or is damaged.
    explicit MipReader(const std::filesystem::path& file);
    ~MipReader();
    MipReader(MipReader&&) noexcept;

    [[nodiscard]] int levels() const;
    [[nodiscard]] int width(int level) const;
    [[nodiscard]] int height(int level) const;
    /// Names, in the order in which pixels hold them (texset/channels.h).
    [[nodiscard]] const std::vector<std::string>& channels() const;

    /// Rows [first, first + count) of a level: count x width x channels, interleaved.
    /// Throws Error when they cannot be read.
    [[nodiscard]] std::vector<float> rows(int level, int first, int count);

private:
    struct Input;
    std::unique_ptr<Input> input_;
};

} // namespace scree
