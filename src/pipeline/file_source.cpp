#include "pipeline/file_source.h"

#include <fmt/format.h>

#include <cmath>

#include "math/error.h"
#include "pipeline/color_reader.h"
#include "pipeline/height_reader.h"
#include "pipeline/normal_reader.h"

namespace scree {

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

void FileSource::spool_in(const std::filesystem::path& folder)
{
    if (height_)
        height_->rows.spool_in(folder);
    if (normal_)
        normal_->rows.spool_in(folder);
    if (color_)
        color_->rows.spool_in(folder);
}

std::string FileSource::name() const
{
    return height_ ? height_->rows.info().path : normal_->rows.info().path;
}

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

void FileSource::rewind(bool last_time)
{
    if (height_)
        height_->rows.rewind(last_time);
    if (normal_)
        normal_->rows.rewind(last_time);
    if (color_)
        color_->rewind(last_time);
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

    // Alpha of the color texture goes before alpha of the height map.
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

void FileSource::rest()
{
    if (height_)
        height_->rows.rest();
    if (normal_)
        normal_->rows.rest();
    if (color_)
        color_->rest();
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
        for (const auto* more : {&color_->rows.info().notes, &color_->conversion.notes()})
            notes.insert(notes.end(), more->begin(), more->end());
    return notes;
}

} // namespace scree
