#include "pipeline/mesh_source.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "math/error.h"
#include "pipeline/survey.h"
#include "surface/mesh_check.h"
#include "surface/mesh_file.h"
#include "surface/texel_metric.h"
#include "texset/file_hash.h"

namespace scree {

namespace {

std::vector<std::string> words_of(const MeshWarnings& found, const std::string& file)
{
    std::vector<std::string> words;
    const auto say = [&](int count, const char* what) {
        if (count > 0)
            words.push_back(fmt::format("{}: {} {}", file, count, what));
    };
    say(found.nonmanifold_edges, "edges of three faces or of faces turned against each other; the "
                                 "surface is creased there");
    say(found.degenerate_faces, "faces without area");
    say(found.zero_area_uv_faces, "faces without area in the texture, which show nothing of it");
    say(found.unused_vertices, "vertices of no face");
    return words;
}

} // namespace

MeshSource::MeshSource(Source& flat, const BakeOptions& options,
                       const std::filesystem::path& folder, const BakeMonitor& monitor)
    : flat_(flat), file_(options.mesh_file), spool_(folder)
{
    const MeshFile read = read_mesh(file_);
    for (const std::string& tag : read.unknown_tags)
        warnings_.push_back(
            fmt::format("{}: tag '{}' is not known and was left out", file_.string(), tag));
    const MeshWarnings odd = check_mesh(read.mesh);
    for (auto& words : words_of(odd, file_.string()))
        warnings_.push_back(std::move(words));
    record_.faces = static_cast<int>(read.mesh.face_sizes.size());
    surface_ = std::make_unique<LimitSurface>(read.mesh, options.subdivision);
    metrics_ = std::make_unique<TexelMetrics>(*surface_);
    find_charts(monitor);
}

MeshSource::~MeshSource() = default;

void MeshSource::find_charts(const BakeMonitor& monitor)
{
    double sum = 0;
    bool kept = true;
    for (int y = 0; y < height(); y += kStripRows) {
        const int count = std::min(kStripRows, height() - y);
        find(y, count, texels_);
        for (const Texel& texel : texels_) {
            largest_area_ = std::max(largest_area_, static_cast<double>(texel.area));
            sum += static_cast<double>(texel.area);
        }
        constexpr size_t kNumbers = sizeof(Texel) / sizeof(float);
        kept = kept && spool_.append(&texels_.front().area, kNumbers * texels_.size());
        monitor.report("mesh", static_cast<double>(y + count) / height());
    }
    spool_.finish();
    const double texels = static_cast<double>(width()) * static_cast<double>(height());
    record_.area = sum / texels;
    if (!(largest_area_ > 0))
        throw Error(fmt::format("{}: no texel of {}x{} lies in a UV chart; texture coordinates go "
                                "from 0 to 1",
                                file_.string(), width(), height()));
    if (record_.overlapped > 0)
        warnings_.push_back(fmt::format("{}: UV charts overlap in {} texels; the first face counts",
                                        file_.string(), record_.overlapped));
    if (record_.singular > 0)
        warnings_.push_back(fmt::format("{}: {} texels lie where the surface has no tangents; they "
                                        "are left out",
                                        file_.string(), record_.singular));
}

void MeshSource::find(int first, int count, std::vector<Texel>& texels)
{
    const auto size = static_cast<size_t>(count) * static_cast<size_t>(width());
    found_.resize(size);
    texels.assign(size, Texel());
    const TexelCounts counts = metrics_->rows({width(), height()}, first, count, found_.data());
    if (first == 0)
        record_.covered = record_.overlapped = record_.mirrored = record_.singular = 0;
    record_.covered += counts.covered;
    record_.overlapped += counts.overlapped;
    record_.mirrored += counts.mirrored;
    record_.singular += counts.singular;
    for (size_t i = 0; i < size; ++i) {
        if (found_[i].face < 0)
            continue;
        const TextureJacobian j = texture_jacobian(found_[i].tangents);
        texels[i] = {static_cast<float>(found_[i].area), static_cast<float>(1 / j.xs),
                     static_cast<float>(-j.xt / (j.xs * j.yt)), static_cast<float>(1 / j.yt),
                     found_[i].curvature};
    }
}

void MeshSource::rewind(bool last_time)
{
    flat_.rewind(last_time);
    if (spool_.whole())
        spool_.rewind(last_time);
    next_row_ = 0;
    record_.largest_displacement = 0;
}

void MeshSource::read(int count, SurfaceRows& rows)
{
    flat_.read(count, rows);
    const auto columns = static_cast<size_t>(width());
    const size_t size = static_cast<size_t>(count) * columns;
    if (spool_.whole()) {
        texels_.resize(size);
        spool_.read(&texels_.front().area, size * sizeof(Texel) / sizeof(float));
    } else {
        find(next_row_, count, texels_);
    }
    if (rows.weight.empty())
        rows.weight.assign(size, 1.0F);
    rows.slope_map.assign(has_heights() ? size : 0, SlopeMap());
    for (size_t i = 0; i < size; ++i)
        apply(texels_[i], i, next_row_ + static_cast<int>(i / columns),
              static_cast<int>(i % columns), rows);
    next_row_ += count;
}

void MeshSource::apply(const Texel& texel, size_t index, int y, int x, SurfaceRows& rows)
{
    auto& presence = has_heights() ? rows.height[index] : rows.slope_s[index];
    if (!(texel.area > 0)) {
        presence = std::numeric_limits<double>::quiet_NaN();
        return;
    }
    rows.weight[index] *= static_cast<float>(static_cast<double>(texel.area) / largest_area_);
    if (!has_heights())
        return;
    rows.slope_map[index] = {texel.a, texel.b, texel.c};
    const double displacement = displacement_error(presence, static_cast<double>(texel.curvature));
    if (displacement > record_.largest_displacement) { // not where there is no data
        record_.largest_displacement = displacement;
        record_.displaced_most = {x, y};
    }
}

InputRecord MeshSource::input() const
{
    InputRecord record;
    record.role = "mesh";
    record.file = file_.filename().string();
    record.sha256 = sha256_of_file(file_);
    return record;
}

std::vector<std::string> MeshSource::warnings() const
{
    constexpr double kSmall = 0.1;
    auto words = warnings_;
    if (record_.largest_displacement > kSmall)
        words.push_back(fmt::format(
            "height times curvature reaches {:.2g} (texel {}, {}): slopes there are off by about "
            "as much, see docs/surfaces.md",
            record_.largest_displacement, record_.displaced_most[0], record_.displaced_most[1]));
    return words;
}

} // namespace scree
