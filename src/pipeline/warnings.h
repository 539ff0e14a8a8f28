#pragma once

#include <string>
#include <vector>

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "texset/manifest.h"

namespace scree {

void warn(Manifest& manifest, std::vector<std::string> warnings);

/// Texels that were left out, counted by reason, with the first of each; a --no-data that none has.
std::vector<std::string> rejects_warnings(const Rejects& rejects, const BakeOptions& options);

/// What the finished statistics say about the scale of the input: an rms slope above 2 or below
/// 1e-4, and the share of the slope variance that 8-bit quantisation alone explains.
///
/// Quantisation to steps q adds white noise of variance q^2/12 a texel, and the bilinear surface
/// of white noise has E[(dh/ds)^2] = (4/3) Var(h) / dx^2 (derived in docs/statistics.md).
///
/// coarsest  level of the set; its deviation of slopes is that of all texels
std::vector<std::string> scale_warnings(const Manifest& manifest, const LevelSummary& coarsest,
                                        const BakeOptions& options);

/// Whether a color map lies where the surface does: a map that all heights miss, or of which they
/// see less than a thousandth; by slope, one a hundred times as wide as the rms slope.
std::vector<std::string> color_map_warnings(const Manifest& manifest, const LevelSummary& coarsest);

} // namespace scree
