#pragma once

#include <memory>
#include <vector>

#include "pipeline/moment_pyramid.h"
#include "pipeline/options.h"
#include "pipeline/strip.h"
#include "pipeline/texture_rows.h"
#include "texset/mip_file.h"

namespace scree {

/// One texture on its way to its file.
struct TextureOutput {
    Map map;
    std::unique_ptr<MipFile> file;
    std::unique_ptr<TextureRows> rows;
};

/// Runs strips through the pyramid and the finished tiles into their files.
///
/// Four stages, several strips in flight: read (one at a time), moments (one strip at a time,
/// parallel inside), compression (parallel), write (one at a time, in order). Throws Error, also
/// when a number does not fit the half floats that were asked for.
void write_pass(StripReader& strips, MomentPyramid& pyramid, const TexelMoments& texels,
                std::vector<TextureOutput>& outputs, int height, const BakeMonitor& monitor);

/// Runs strips through the pyramid for the visitors' sake alone.
void measure_pass(StripReader& strips, MomentPyramid& pyramid, const TexelMoments& texels,
                  int height, const BakeMonitor& monitor);

} // namespace scree
