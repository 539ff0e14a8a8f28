#pragma once

#include "chart/color_vector.h"
#include "chart/methods.h"
#include "kernel/visibility_table.h"
#include "texset/manifest.h"

namespace scree {

/// Where the tables of two sets of one surface have their nodes.
///
/// harmonics, axes  of four nodes each, the second along axes
VisibilityNodes nodes_of(const VisibilityRecord& harmonics, const VisibilityRecord& axes);

/// A table that a footprint holds, ready for lookups.
using TableOf = filter::VisibilityTable<float> (*)(const FootprintData&, const MethodSetting&);

inline filter::VisibilityTable<float> table_2x1(const FootprintData& data,
                                                const MethodSetting& setting)
{
    return {data.visible_2x1.data(), setting.nodes.two.data(), 2, 0};
}
inline filter::VisibilityTable<float> table_4x1(const FootprintData& data,
                                                const MethodSetting& setting)
{
    return {data.visible_4x1.data(), setting.nodes.four.data(), 4, 0};
}
inline filter::VisibilityTable<float> table_4x3(const FootprintData& data,
                                                const MethodSetting& setting)
{
    return {data.visible_4x3.data(), setting.nodes.four.data(), 4, 1};
}
inline filter::VisibilityTable<float> table_4x5(const FootprintData& data,
                                                const MethodSetting& setting)
{
    return {data.set.visible.data(), setting.nodes.four.data(), 4, 2};
}
inline filter::VisibilityTable<float> table_4_axes(const FootprintData& data,
                                                   const MethodSetting& setting)
{
    const VisibilityNodes& nodes = setting.nodes;
    return {data.visible_axes.data(), nodes.along_axes.data(), 4, 0, true,
            nodes.axis_cosine,        nodes.axis_sine};
}

/// Color as views were measured to see it, the rest as LEADR has it: a way of Method.
template <TableOf table_of>
struct Measured {
    static Rgbf color(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo)
    {
        return color_of(
            filter::visible_color(vector_of(data.set.color), table_of(data, setting), wo));
    }
    static Rgbf radiance(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo,
                         const Vec3f& wi)
    {
        const Vec3f mean = vector_of(data.set.color);
        const auto table = table_of(data, setting);
        const Vec3f color =
            filter::color_seen_and_lit(mean, filter::visible_color(mean, table, wo),
                                       filter::visible_color(mean, table, wi), wo, wi);
        return scree::radiance(filter::slopes(data.set.slope), color_of(color), setting.material,
                               wo, wi);
    }
};

} // namespace scree
