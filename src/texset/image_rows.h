#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace scree {

/// What an image file says of itself.
struct ImageInfo {
    std::string path;
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::string type;               ///< pixel type as OpenImageIO names it: uint8, half, float, ...
    int integer_bits = 0;           ///< 8, 16, 32 for integers, 0 for floating point
    int alpha_channel = -1;         ///< index, -1 without
    bool premultiplied = false;     ///< color is multiplied by alpha in the file
    std::string color_space;        ///< as the header states it (stated_color()), or empty
    std::string color_fallback;     ///< to go by where an OCIO config does not know color_space
    std::vector<std::string> notes; ///< what a user should know: windows that differ, other parts
};

/// Rows of an image, from top to bottom, as floats.
///
/// Reads whatever OpenImageIO reads. Integers are normalised: unsigned to [0, 1] (a 16-bit 65535
/// is 1), signed to [-1, 1] (32767 is 1). Color is left as the file stores it, in its own encoding
/// and not multiplied by alpha where the file does not do so. Of several parts the first is read,
/// of MIP levels the finest. Memory: one strip of rows.
///
/// Throws Error, naming the file, when it is missing, unreadable, truncated, of no size, deep, a
/// volume, or when its header claims more than its bytes could hold.
class ImageRows {
public:
    explicit ImageRows(const std::filesystem::path& path);
    ~ImageRows();
    ImageRows(ImageRows&&) noexcept;
    ImageRows& operator=(ImageRows&&) noexcept;

    [[nodiscard]] const ImageInfo& info() const { return info_; }

    /// The next `count` rows of some channels, interleaved; count x width x channels floats. The
    /// channels are the same in every call.
    void next(int count, const std::vector<int>& channels, float* pixels);

    /// Closes the file and lets go of its memory; info() stays, next() has come to its end.
    void release();

private:
    struct Input;
    void fill_strip(int first_channel, int end_channel);
    bool read_one_by_one(int y0, int y1, int first_channel, int end_channel);

    ImageInfo info_;
    std::unique_ptr<Input> input_;
    int next_row_ = 0;
    int strip_begin_ = 0, strip_end_ = 0; ///< rows in strip_
    std::vector<float> strip_;
};

/// Index of a channel given by name or by number from 0.
/// Throws Error naming the file's channels when there is none such.
int channel_index(const ImageInfo& info, const std::string& name_or_number,
                  const std::string& option);

/// The image's size and channels for messages: "1024x512, channels R,G,B".
std::string describe(const ImageInfo& info);

} // namespace scree
