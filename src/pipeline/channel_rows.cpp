#include "pipeline/channel_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "pipeline/let_go.h"
#include "texset/file_hash.h"

namespace scree {

void reject(Rejects::Count& count, const std::string& file, const std::string& channel, int x,
            int y)
{
    if (count.texels++ == 0)
        count.first = fmt::format("{}, channel {}, texel ({}, {})", file, channel, x, y);
}

ChannelRows::ChannelRows(std::filesystem::path file) : file_(std::move(file)), image_(file_) {}

void ChannelRows::spool_in(const std::filesystem::path& folder)
{
    spool_ = std::make_unique<Spool>(folder);
}

void ChannelRows::rewind(bool last_time)
{
    next_row_ = 0;
    if (spool_ && spool_->whole()) {
        spool_->rewind(last_time);
        return;
    }
    image_ = ImageRows(file_);
    if (spool_)
        spool_->clear();
}

void ChannelRows::rest()
{
    image_.release();
    let_go(pixels_);
}

std::string ChannelRows::name(int place) const
{
    return info().channels[static_cast<size_t>(channels_[static_cast<size_t>(place)])];
}

void ChannelRows::choose(std::vector<int> channels, bool with_alpha)
{
    channels_ = std::move(channels);
    const int alpha = info().alpha_channel;
    const bool taken = std::find(channels_.begin(), channels_.end(), alpha) != channels_.end();
    if (with_alpha && alpha >= 0 && !taken) {
        alpha_place_ = static_cast<int>(channels_.size());
        channels_.push_back(alpha);
    }
}

const float* ChannelRows::next(int count)
{
    pixels_.resize(static_cast<size_t>(count) * static_cast<size_t>(info().width) *
                   channels_.size());
    next_row_ += count;
    if (spool_ && spool_->whole()) {
        spool_->read(pixels_.data(), pixels_.size());
        return pixels_.data();
    }
    image_.next(count, channels_, pixels_.data());
    if (spool_ && !spool_->append(pixels_.data(), pixels_.size()))
        spool_.reset();
    if (spool_ && next_row_ == info().height)
        spool_->finish();
    if (spool_ && spool_->whole())
        image_.release();
    return pixels_.data();
}

void ChannelRows::alpha_of(const float* pixels, std::vector<float>& alpha) const
{
    alpha.clear();
    if (!has_alpha())
        return;
    const size_t texels = pixels_.size() / channels_.size();
    alpha.resize(texels);
    for (size_t i = 0; i < texels; ++i)
        alpha[i] = pixels[i * channels_.size() + static_cast<size_t>(alpha_place_)];
}

InputRecord ChannelRows::record(const std::string& role, int used) const
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

} // namespace scree
