#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::test {

/// A folder of its own for a test, removed with it.
class TempFolder {
public:
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// An image in memory: height x width x channels, interleaved.
struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<float> pixels;

    float at(int x, int y, int channel) const
    {
        return pixels[(static_cast<size_t>(y) * static_cast<size_t>(width) +
                       static_cast<size_t>(x)) *
                          channels.size() +
                      static_cast<size_t>(channel)];
    }
};

/// Writes an image through OpenImageIO; the ending decides the format.
/// type  "float", "half", "uint8", "uint16": of the pixels in the file
void write_image(const std::filesystem::path& file, const Image& image,
                 const std::string& type = "float");

/// All MIP levels of a file, as floats, read through OpenImageIO; fails the test when it cannot.
std::vector<Image> read_levels(const std::filesystem::path& file);

std::string read_bytes(const std::filesystem::path& file);

/// Folder of real data beside the project; empty where it is absent (a test then skips).
std::filesystem::path data_folder();

} // namespace scree::test
