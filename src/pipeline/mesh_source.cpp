#include "pipeline/mesh_source.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "pipeline/let_go.h"
#include "pipeline/survey.h"

namespace scree {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Where a step of part of a texture unit from the middle of a texel leads to.
void note(const TexelMetric& texel, const Vec3& step, MapEdge& edge, size_t index)
{
    if (texel.face < 0)
        return;
    edge.place[index] = texel.position + step;
    edge.reach[index] = step.length();
}

} // namespace

MeshSource::MeshSource(Source& flat, const BakedMesh& mesh, const UdimTile& tile,
                       const std::filesystem::path& folder, const BakeMonitor& monitor)
    : flat_(flat), mesh_(mesh), tile_(tile), spool_(folder), record_(mesh.record())
{
    for (const Side side : kSides) {
        const int texels = side == kLeft || side == kRight ? height() : width();
        edges_[side].place.assign(static_cast<size_t>(texels), Vec3(kNothing));
        edges_[side].reach.assign(static_cast<size_t>(texels), 0);
    }
    find_charts(monitor);
    unit_area_ = largest_area_;
    rest();
}

void MeshSource::find_charts(const BakeMonitor& monitor)
{
    double sum = 0;
    bool kept = true;
    for (int y = 0; y < height(); y += kStripRows) {
        const int count = std::min(kStripRows, height() - y);
        find(y, count);
        note_edges(y, count);
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
}

void MeshSource::find(int first, int count)
{
    const auto size = static_cast<size_t>(count) * static_cast<size_t>(width());
    found_.resize(size);
    texels_.assign(size, Texel());
    const TexelCounts counts =
        mesh_.metrics().rows({width(), height(), tile_.u, tile_.v}, first, count, found_.data());
    if (first == 0) {
        record_.covered = record_.overlapped = record_.mirrored = record_.singular = 0;
        first_overlap_.reset();
    }
    record_.covered += counts.covered;
    record_.overlapped += counts.overlapped;
    record_.mirrored += counts.mirrored;
    record_.singular += counts.singular;
    if (!first_overlap_)
        first_overlap_ = counts.first_overlap;
    for (size_t i = 0; i < size; ++i) {
        if (found_[i].face < 0)
            continue;
        const TextureJacobian j = texture_jacobian(found_[i].tangents);
        texels_[i] = {static_cast<float>(found_[i].area), static_cast<float>(1 / j.xs),
                      static_cast<float>(-j.xt / (j.xs * j.yt)), static_cast<float>(1 / j.yt),
                      found_[i].curvature};
    }
}

void MeshSource::note_edges(int first, int count)
{
    const double half_width = 0.5 / width(), half_height = 0.5 / height();
    const auto columns = static_cast<size_t>(width());
    for (int y = first; y < first + count; ++y) {
        const TexelMetric* line = &found_[static_cast<size_t>(y - first) * columns];
        const auto row = static_cast<size_t>(y);
        const TexelMetric& last = line[columns - 1];
        note(line[0], line[0].tangents.by_s * -half_width, edges_[kLeft], row);
        note(last, last.tangents.by_s * half_width, edges_[kRight], row);
        const bool is_top = y == 0, is_bottom = y == height() - 1;
        for (size_t x = 0; x < columns && is_top; ++x)
            note(line[x], line[x].tangents.by_t * -half_height, edges_[kTop], x);
        for (size_t x = 0; x < columns && is_bottom; ++x)
            note(line[x], line[x].tangents.by_t * half_height, edges_[kBottom], x);
    }
}

void MeshSource::rewind(bool last_time)
{
    flat_.rewind(last_time);
    if (spool_.whole())
        spool_.rewind(last_time);
    next_row_ = 0;
    displacements_.clear();
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
        find(next_row_, count);
    }
    if (rows.weight.empty())
        rows.weight.assign(size, 1.0F);
    rows.slope_map.assign(has_heights() ? size : 0, SlopeMap());
    for (size_t i = 0; i < size; ++i)
        apply(texels_[i], i, next_row_ + static_cast<int>(i / columns),
              static_cast<int>(i % columns), rows);
    next_row_ += count;
}

void MeshSource::rest()
{
    flat_.rest();
    let_go(found_);
    let_go(texels_);
}

void MeshSource::apply(const Texel& texel, size_t index, int y, int x, SurfaceRows& rows)
{
    auto& presence = has_heights() ? rows.height[index] : rows.slope_s[index];
    if (!(texel.area > 0)) {
        presence = kNothing;
        return;
    }
    rows.weight[index] *= static_cast<float>(static_cast<double>(texel.area) / unit_area_);
    if (!has_heights())
        return;
    rows.slope_map[index] = {texel.a, texel.b, texel.c};
    const double displacement = displacement_error(presence, static_cast<double>(texel.curvature));
    displacements_.add(static_cast<float>(displacement), texel.area, x, y);
}

MeshRecord MeshSource::record() const
{
    constexpr double kUsual = 0.99;
    MeshRecord record = record_;
    record.largest_displacement = displacements_.largest();
    record.displaced_most = displacements_.place_of_largest();
    record.usual_displacement = displacements_.quantile(kUsual);
    return record;
}

std::vector<std::string> MeshSource::warnings() const
{
    constexpr double kSmall = 0.1;
    const MeshRecord found = record();
    std::vector<std::string> words;
    if (first_overlap_)
        words.push_back(fmt::format(
            "{}: UV charts overlap in {} texels, first of faces {} and {} at texel {}, {}; the "
            "lower face counts",
            mesh_.name(), found.overlapped, first_overlap_->face + 1, first_overlap_->other + 1,
            first_overlap_->x, first_overlap_->y));
    if (found.singular > 0)
        words.push_back(fmt::format("{}: {} texels lie where the surface has no tangents; they "
                                    "are left out",
                                    mesh_.name(), found.singular));
    if (found.usual_displacement > kSmall || found.largest_displacement > 1)
        words.push_back(fmt::format(
            "height times curvature reaches {:.2g} (texel {}, {}), {:.2g} on all but 1 % of the "
            "area: slopes there are off by about as much, see docs/surfaces.md",
            found.largest_displacement, found.displaced_most[0], found.displaced_most[1],
            found.usual_displacement));
    return words;
}

} // namespace scree
