#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/source.h"
#include "texset/image_rows.h"
#include "texset/manifest.h"
#include "texset/spool.h"

namespace scree {

/// Marks a texel without data.
constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

/// Counts a texel without data and remembers the first.
void reject(Rejects::Count& count, const std::string& file, const std::string& channel, int x,
            int y);

/// A file's channels for one purpose, read as interleaved floats, alpha behind them if it is asked
/// for and there.
class ChannelRows {
public:
    explicit ChannelRows(std::filesystem::path file);

    [[nodiscard]] const ImageInfo& info() const { return image_.info(); }
    [[nodiscard]] bool has_alpha() const { return alpha_place_ >= 0; }
    /// Floats a texel.
    [[nodiscard]] int stride() const { return static_cast<int>(channels_.size()); }
    /// Name of the channel at a place among the chosen ones.
    [[nodiscard]] std::string name(int place) const;

    /// Which channels to read, by index in the file.
    void choose(std::vector<int> channels, bool with_alpha);

    /// From now on, what is decoded is kept in a spool in this folder, if there is room, and not
    /// decoded again.
    void spool_in(const std::filesystem::path& folder);

    void rewind(bool last_time);
    /// Until then nothing is read: closes the file.
    void rest();

    /// The next rows, valid until the next call.
    const float* next(int count);

    /// Alpha of the rows next() gave; empty without.
    void alpha_of(const float* pixels, std::vector<float>& alpha) const;

    /// What the manifest says of the file; `used` of the chosen channels are named.
    [[nodiscard]] InputRecord record(const std::string& role, int used) const;

private:
    std::filesystem::path file_;
    ImageRows image_;
    std::vector<int> channels_;
    int alpha_place_ = -1;
    int next_row_ = 0;
    std::unique_ptr<Spool> spool_;
    std::vector<float> pixels_;
};

/// R, G and B by name, or the first three; one gray channel stands for all three.
/// Throws Error when the file has neither.
std::vector<int> choose_color_channels(const ImageInfo& info);

} // namespace scree
