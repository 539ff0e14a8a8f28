#include "pipeline/file_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/error.h"
#include "pipeline/resample.h"
#include "texset/color_space.h"
#include "texset/file_hash.h"
#include "texset/image_rows.h"

namespace scree {

namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

void reject(Rejects::Count& count, const std::string& file, const std::string& channel, int x,
            int y)
{
    if (count.texels++ == 0)
        count.first = fmt::format("{}, channel {}, texel ({}, {})", file, channel, x, y);
}

/// A file's channels for a purpose, read as interleaved floats, with its alpha behind them.
class ChannelRows {
public:
    ChannelRows(std::filesystem::path file, bool with_alpha)
        : file_(std::move(file)), image_(file_), with_alpha_(with_alpha)
    {}

    [[nodiscard]] const ImageInfo& info() const { return image_.info(); }
    [[nodiscard]] const std::vector<int>& channels() const { return channels_; }
    [[nodiscard]] bool has_alpha() const { return alpha_place_ >= 0; }
    [[nodiscard]] int stride() const { return static_cast<int>(channels_.size()); }
    [[nodiscard]] std::string name(int place) const
    {
        return info().channels[static_cast<size_t>(channels_[static_cast<size_t>(place)])];
    }

    void choose(std::vector<int> channels)
    {
        channels_ = std::move(channels);
        const int alpha = info().alpha_channel;
        const bool taken = std::find(channels_.begin(), channels_.end(), alpha) != channels_.end();
        if (with_alpha_ && alpha >= 0 && !taken) {
            alpha_place_ = static_cast<int>(channels_.size());
            channels_.push_back(alpha);
        }
    }

    void rewind() { image_ = ImageRows(file_); }

    const float* next(int count)
    {
        pixels_.resize(static_cast<size_t>(count) * static_cast<size_t>(info().width) *
                       channels_.size());
        image_.next(count, channels_, pixels_.data());
        return pixels_.data();
    }

    void alpha_of(const float* pixels, std::vector<float>& alpha) const
    {
        alpha.clear();
        if (!has_alpha())
            return;
        const size_t texels = pixels_.size() / channels_.size();
        alpha.resize(texels);
        for (size_t i = 0; i < texels; ++i)
            alpha[i] = pixels[i * channels_.size() + static_cast<size_t>(alpha_place_)];
    }

    [[nodiscard]] InputRecord record(const std::string& role, int used) const
    {
        std::string names;
        for (int i = 0; i < used; ++i)
            names += (i == 0 ? "" : ",") + name(i);
        return {role,
                file_.filename().string(),
                sha256_of_file(file_),
                info().width,
                info().height,
                names,
                info().type,
                ""};
    }

private:
    std::filesystem::path file_;
    ImageRows image_;
    bool with_alpha_;
    std::vector<int> channels_;
    int alpha_place_ = -1;
    std::vector<float> pixels_;
};

int choose_height_channel(const ImageInfo& info, const BakeOptions& options)
{
    if (!options.height_channel.empty())
        return channel_index(info, options.height_channel, "--height-channel");
    const bool only_alpha_beside = info.channels.size() == 2 && info.alpha_channel == 1;
    if (info.channels.size() == 1 || only_alpha_beside)
        return 0;
    throw Error(fmt::format("{}: {} channels, expected 1 height channel; name one with "
                            "--height-channel {} (or give --input normal)",
                            info.path, info.channels.size(), info.channels.front()));
}

/// R, G and B by name, or the first three; one gray channel stands for all three.
std::vector<int> choose_color_channels(const ImageInfo& info)
{
    std::vector<int> rgb;
    for (const char* name : {"R", "G", "B"}) {
        const auto found = std::find(info.channels.begin(), info.channels.end(), name);
        if (found != info.channels.end())
            rgb.push_back(static_cast<int>(found - info.channels.begin()));
    }
    if (rgb.size() == 3)
        return rgb;
    const bool gray =
        info.channels.size() == 1 || (info.channels.size() == 2 && info.alpha_channel == 1);
    if (gray)
        return {0, 0, 0};
    if (info.channels.size() < 3)
        throw Error(fmt::format("{}: {} channels, expected R, G and B, or one gray channel",
                                info.path, info.channels.size()));
    return {0, 1, 2};
}

} // namespace

class FileSource::HeightReader {
public:
    explicit HeightReader(const BakeOptions& options)
        : rows(options.height_file, options.alpha_weight), scale_(options.height_scale),
          offset_(options.height_offset), no_data_(options.no_data_height)
    {
        rows.choose({choose_height_channel(rows.info(), options)});
    }

    void read(int y, int count, std::vector<double>& height, Rejects& rejects)
    {
        const float* pixels = rows.next(count);
        const int width = rows.info().width;
        height.resize(static_cast<size_t>(count) * static_cast<size_t>(width));
        for (size_t i = 0; i < height.size(); ++i) {
            const float value = pixels[i * static_cast<size_t>(rows.stride())];
            const auto texel = static_cast<int>(i);
            height[i] = offset_ + scale_ * static_cast<double>(value);
            if (no_data_ && static_cast<double>(value) == *no_data_) {
                height[i] = kNoData;
                reject(rejects.marked, rows.info().path, rows.name(0), texel % width,
                       y + texel / width);
            } else if (!std::isfinite(value)) {
                height[i] = kNoData;
                reject(rejects.not_finite, rows.info().path, rows.name(0), texel % width,
                       y + texel / width);
            }
        }
        rows.alpha_of(pixels, alpha);
    }

    /// One step of an integer file, world units; signed formats have half as many steps a unit.
    [[nodiscard]] double quantum() const
    {
        const int bits = rows.info().integer_bits;
        if (bits == 0)
            return 0;
        const bool is_signed = rows.info().type.rfind("int", 0) == 0;
        return std::abs(scale_) / (std::ldexp(1.0, is_signed ? bits - 1 : bits) - 1);
    }

    ChannelRows rows;
    std::vector<float> alpha;

private:
    double scale_, offset_;
    std::optional<double> no_data_;
};

class FileSource::NormalReader {
public:
    explicit NormalReader(const BakeOptions& options)
        : rows(options.height_file, options.alpha_weight), sign_x_(options.invert_x ? 1 : -1),
          sign_y_(options.invert_y ? 1 : -1)
    {
        if (rows.info().channels.size() < 3)
            throw Error(fmt::format("{}: {} channels, expected the 3 of a normal map; for a height "
                                    "map leave --input normal out",
                                    rows.info().path, rows.info().channels.size()));
        rows.choose(choose_color_channels(rows.info()));
        signed_ = options.normal_range == NormalRange::signed_unit ||
                  (options.normal_range == NormalRange::automatic && has_negative());
    }

    void read(int y, int count, std::vector<double>& slope_s, std::vector<double>& slope_t,
              Rejects& rejects)
    {
        const float* pixels = rows.next(count);
        const int width = rows.info().width;
        const size_t texels = static_cast<size_t>(count) * static_cast<size_t>(width);
        slope_s.resize(texels);
        slope_t.resize(texels);
        for (size_t i = 0; i < texels; ++i) {
            const float* n = pixels + i * static_cast<size_t>(rows.stride());
            const double x = component(n[0]), ny = component(n[1]), z = component(n[2]);
            const auto texel = static_cast<int>(i);
            const int column = texel % width, row = y + texel / width;
            slope_s[i] = sign_x_ * x / z;
            slope_t[i] = sign_y_ * ny / z;
            if (!std::isfinite(x) || !std::isfinite(ny) || !std::isfinite(z))
                reject(rejects.not_finite, rows.info().path, rows.name(0), column, row);
            else if (z <= 0)
                reject(rejects.turned_away, rows.info().path, rows.name(2), column, row);
            else
                continue;
            slope_s[i] = slope_t[i] = kNoData;
        }
        rows.alpha_of(pixels, alpha);
    }

    ChannelRows rows;
    std::vector<float> alpha;

private:
    [[nodiscard]] double component(float stored) const
    {
        return signed_ ? static_cast<double>(stored) : 2 * static_cast<double>(stored) - 1;
    }

    /// A floating-point file with a negative number holds [-1, 1]; all others [0, 1].
    bool has_negative()
    {
        if (rows.info().integer_bits != 0)
            return false;
        bool negative = false;
        for (int y = 0; y < rows.info().height && !negative; ++y) {
            const float* pixels = rows.next(1);
            for (int i = 0; i < rows.info().width * rows.stride(); ++i)
                negative = negative || pixels[i] < 0;
        }
        rows.rewind();
        return negative;
    }

    double sign_x_, sign_y_;
    bool signed_ = false;
};

class FileSource::ColorReader {
public:
    ColorReader(const BakeOptions& options, int width, int height)
        : rows(options.color_file, options.alpha_weight),
          conversion(options.ocio_config, options.color_space, rows.info().color_space,
                     rows.info().path),
          resampler_(rows.info().width, rows.info().height, width, height, options.wrap_s,
                     options.wrap_t),
          width_(width)
    {
        rows.choose(choose_color_channels(rows.info()));
        source_alpha_ = rows.has_alpha();
    }

    void rewind()
    {
        rows.rewind();
        resampler_.rewind();
    }

    /// The next `count` rows at the height map's size, linear, with alpha divided out of it where
    /// the file has it multiplied in and alpha is the weight.
    void read(int y, int count, std::vector<float>& color, Rejects& rejects)
    {
        const auto texels = static_cast<size_t>(count) * static_cast<size_t>(width_);
        const size_t channels = source_alpha_ ? 4 : 3;
        interleaved_.resize(texels * channels);
        resampler_.read(
            count, channels, [this](int row_count, float* out) { read_linear(row_count, out); },
            interleaved_.data());
        color.resize(texels * 3);
        alpha.resize(source_alpha_ ? texels : 0);
        for (size_t i = 0; i < texels; ++i) {
            const float* from = &interleaved_[i * channels];
            std::copy_n(from, 3, &color[i * 3]);
            if (source_alpha_)
                alpha[i] = from[3];
            for (int c = 0; c < 3; ++c)
                if (!std::isfinite(from[c])) {
                    reject(rejects.not_finite, rows.info().path, rows.name(c),
                           static_cast<int>(i) % width_, y + static_cast<int>(i) / width_);
                    break;
                }
        }
    }

    ChannelRows rows;
    ColorConversion conversion;
    std::vector<float> alpha;

private:
    void read_linear(int count, float* out)
    {
        const float* pixels = rows.next(count);
        const auto texels = static_cast<size_t>(count) * static_cast<size_t>(rows.info().width);
        const auto stride = static_cast<size_t>(rows.stride());
        linear_.resize(texels * 3);
        for (size_t i = 0; i < texels; ++i) {
            const float* from = pixels + i * stride;
            const bool divide = source_alpha_ && rows.info().premultiplied && from[3] > 0;
            for (size_t c = 0; c < 3; ++c)
                linear_[i * 3 + c] = divide ? from[c] / from[3] : from[c];
        }
        conversion.apply(linear_.data(), static_cast<long>(texels));
        for (size_t i = 0; i < texels; ++i) {
            out = std::copy_n(&linear_[i * 3], 3, out);
            if (source_alpha_)
                *out++ = pixels[i * stride + 3];
        }
    }

    RowResampler resampler_;
    int width_;
    bool source_alpha_ = false;
    std::vector<float> linear_, interleaved_;
};

FileSource::FileSource(const BakeOptions& options)
{
    if (options.normal_input)
        normal_ = std::make_unique<NormalReader>(options);
    else
        height_ = std::make_unique<HeightReader>(options);
    if (!options.color_file.empty())
        color_ = std::make_unique<ColorReader>(options, width(), height());

    const ImageInfo& shape = options.normal_input ? normal_->rows.info() : height_->rows.info();
    if (color_ && !options.resample &&
        (color_->rows.info().width != width() || color_->rows.info().height != height()))
        throw Error(fmt::format("{} is {}x{}, {} is {}x{}; give maps of one size, or --resample to "
                                "fit the color to the {}",
                                shape.path, width(), height(), options.color_file.string(),
                                color_->rows.info().width, color_->rows.info().height,
                                options.normal_input ? "normals" : "heights"));
    const bool alpha = (color_ && color_->rows.has_alpha()) ||
                       (height_ ? height_->rows.has_alpha() : normal_->rows.has_alpha());
    if (options.alpha_weight && !alpha)
        throw Error(fmt::format("--alpha-weight: no alpha channel in {}{}", shape.path,
                                color_ ? " or " + color_->rows.info().path : ""));
}

FileSource::~FileSource() = default;

int FileSource::width() const
{
    return height_ ? height_->rows.info().width : normal_->rows.info().width;
}

int FileSource::height() const
{
    return height_ ? height_->rows.info().height : normal_->rows.info().height;
}

bool FileSource::has_heights() const { return height_ != nullptr; }

bool FileSource::has_color() const { return color_ != nullptr; }

void FileSource::rewind()
{
    if (height_)
        height_->rows.rewind();
    if (normal_)
        normal_->rows.rewind();
    if (color_)
        color_->rewind();
    next_row_ = 0;
    rejects_ = {};
}

void FileSource::read(int count, SurfaceRows& rows)
{
    if (height_)
        height_->read(next_row_, count, rows.height, rejects_);
    else
        normal_->read(next_row_, count, rows.slope_s, rows.slope_t, rejects_);
    if (color_)
        color_->read(next_row_, count, rows.color, rejects_);
    next_row_ += count;

    // Alpha of the color map goes before alpha of the height map.
    const std::vector<float>& own = height_ ? height_->alpha : normal_->alpha;
    rows.weight = color_ && !color_->alpha.empty() ? color_->alpha : own;

    std::vector<double>& presence = height_ ? rows.height : rows.slope_s;
    for (size_t i = 0; i < presence.size(); ++i) {
        const bool bad_color = !rows.color.empty() && !(std::isfinite(rows.color[3 * i]) &&
                                                        std::isfinite(rows.color[3 * i + 1]) &&
                                                        std::isfinite(rows.color[3 * i + 2]));
        const bool no_weight =
            !rows.weight.empty() && !(rows.weight[i] > 0 && std::isfinite(rows.weight[i]));
        if (bad_color || no_weight)
            presence[i] = kNoData;
    }
}

const Rejects& FileSource::rejects() const { return rejects_; }

double FileSource::quantum() const { return height_ ? height_->quantum() : 0; }

int FileSource::integer_bits() const { return height_ ? height_->rows.info().integer_bits : 0; }

std::string FileSource::working_space() const
{
    return color_ ? color_->conversion.working_space() : "";
}

std::vector<InputRecord> FileSource::records() const
{
    std::vector<InputRecord> records;
    if (height_)
        records.push_back(height_->rows.record("height", 1));
    else
        records.push_back(normal_->rows.record("normal", 3));
    if (color_) {
        records.push_back(color_->rows.record("color", 3));
        records.back().color_space = color_->conversion.input_space();
    }
    return records;
}

std::vector<std::string> FileSource::notes() const
{
    std::vector<std::string> notes =
        height_ ? height_->rows.info().notes : normal_->rows.info().notes;
    if (color_)
        for (const auto& note : color_->rows.info().notes)
            notes.push_back(note);
    return notes;
}

} // namespace scree
