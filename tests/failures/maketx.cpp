#include "failures/maketx.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "math/error.h"

namespace scree::test {
namespace {

std::string first_line_of(const std::string& command)
{
    const std::unique_ptr<FILE, int (*)(FILE*)> out(popen(command.c_str(), "r"), pclose);
    std::array<char, 256> line{};
    if (!out || std::fgets(line.data(), line.size(), out.get()) == nullptr)
        return {};
    const std::string text = line.data();
    return text.substr(0, text.find_last_not_of(" \n") + 1);
}

} // namespace

std::string maketx_version()
{
    static const std::string version = first_line_of("maketx --version 2>/dev/null");
    return version;
}

std::optional<std::vector<Image>> maketx_levels(const Image& image, const std::string& options,
                                                const std::string& type, const std::string& ending)
{
    if (maketx_version().empty())
        return {};
    const TempFolder temp;
    const std::string in = (temp / ("in." + ending)).string(),
                      out = (temp / ("out." + ending)).string();
    const std::string log = (temp / "log.txt").string();
    write_image(in, image, type);
    const std::string command =
        "maketx --bumpslopes " + options + " -o '" + out + "' '" + in + "' > '" + log + "' 2>&1";
    if (std::system(command.c_str()) != 0)
        throw Error(command + ": failed: " + read_bytes(log));
    return read_levels(out);
}

std::optional<double> of_top(const std::optional<std::vector<Image>>& levels, int channel)
{
    return of_levels(levels,
                     [=](const std::vector<Image>& all) { return all.back().at(0, 0, channel); });
}

double variance_s(const Image& level, int x, int y)
{
    const auto mean = static_cast<double>(level.at(x, y, kMeanS));
    return static_cast<double>(level.at(x, y, kMeanSs)) - mean * mean;
}

double variance_of_top(const std::vector<Image>& levels) { return variance_s(levels.back(), 0, 0); }

double mean_over(const Image& level, int channel)
{
    double sum = 0;
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x)
            sum += static_cast<double>(level.at(x, y, channel));
    return sum / (level.width * level.height);
}

} // namespace scree::test
