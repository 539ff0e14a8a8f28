#include "pipeline/normal_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "math/error.h"

namespace scree {

NormalReader::NormalReader(const BakeOptions& options)
    : rows(options.height_file), sign_x_(options.invert_x ? 1 : -1),
      sign_y_(options.invert_y ? 1 : -1)
{
    if (rows.info().channels.size() < 3)
        throw Error(fmt::format("{}: {} channels, expected the 3 of a normal map; for a height "
                                "map leave --input normal out",
                                rows.info().path, rows.info().channels.size()));
    rows.choose(choose_color_channels(rows.info()), options.alpha_weight);
    signed_ = options.normal_range == NormalRange::signed_unit ||
              (options.normal_range == NormalRange::automatic && looks_signed());
}

void NormalReader::read(int y, int count, std::vector<double>& slope_s,
                        std::vector<double>& slope_t, Rejects& rejects)
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

double NormalReader::component(float stored) const
{
    return signed_ ? static_cast<double>(stored) : 2 * static_cast<double>(stored) - 1;
}

bool NormalReader::looks_signed()
{
    if (rows.info().integer_bits != 0)
        return false;
    auto length_error = [](double x, double y, double z) {
        const double error = std::abs(std::sqrt(x * x + y * y + z * z) - 1);
        return std::isfinite(error) ? error : 0;
    };
    double as_signed = 0, as_unsigned = 0;
    for (int y = 0; y < rows.info().height; ++y) {
        const float* n = rows.next(1);
        for (int x = 0; x < rows.info().width; ++x, n += rows.stride()) {
            const auto a = static_cast<double>(n[0]), b = static_cast<double>(n[1]),
                       c = static_cast<double>(n[2]);
            as_signed += length_error(a, b, c);
            as_unsigned += length_error(2 * a - 1, 2 * b - 1, 2 * c - 1);
        }
    }
    rows.rewind(false);
    return as_signed < as_unsigned;
}

} // namespace scree
