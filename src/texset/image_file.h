#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "texset/attributes.h"

namespace scree {

/// Writes a plain scan-line float OpenEXR image, row by row.
///
/// The file appears under its name when it is complete; without close() nothing is left behind.
/// Throws Error, naming the file, when it cannot be written.
class ImageFile {
public:
    ImageFile(std::filesystem::path path, int width, int height,
              const std::vector<std::string>& channels, const Attributes& attributes = {});
    ~ImageFile();
    ImageFile(const ImageFile&) = delete;
    ImageFile& operator=(const ImageFile&) = delete;

    /// The next row: width x channels floats, interleaved.
    void write_row(const float* pixels);
    void close();

private:
    struct Output;
    std::filesystem::path path_, partial_;
    std::unique_ptr<Output> output_;
    int next_row_ = 0;
};

} // namespace scree
