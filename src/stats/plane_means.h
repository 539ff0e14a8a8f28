#pragma once

#include "stats/moment_layout.h"
#include "stats/pyramid.h"

namespace scree {

/// Weighted means of planes that nothing else depends on: coarse texels [x0, x1) of one row.
///
///   sum_k share_k w_k x_k / sum_k share_k w_k
///
/// and 0 where no fine texel has a weight. What merge() does with means, but without the
/// differences that central moments need, so many planes are cheap.
///
/// first, count  the planes
/// fine_rows     the `rows.count` rows that `rows` names, whole
/// rows          their shares, from share_of() along t
/// columns       of every coarse texel of the row, from share_of() along s
/// coarse        the whole coarse row
void mean_planes(int first, int count, const MomentRow* fine_rows, const Share& rows,
                 const Share* columns, int x0, int x1, MomentRow coarse);

/// The same of what is seen of texels of level 0, each of one color c: the planes of layout's
/// components become the means of v and c v.
///
/// fine_rows  of level 0, with MomentRow::seen
void mean_seen(const MomentLayout& layout, const MomentRow* fine_rows, const Share& rows,
               const Share* columns, int x0, int x1, MomentRow coarse);

} // namespace scree
