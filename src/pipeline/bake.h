#pragma once

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "texset/manifest.h"

namespace scree {

/// Bakes a texture set from files into options.output.
///
/// Goes over the inputs twice: a cheap survey (h0, h1, holes, the rows a periodic map needs), and
/// the pass that makes every level and writes its tiles as they become ready. What must be known
/// before that is measured in a pass in between: what half storage would cost (`--pixel-type
/// auto`), what models of color leave (`--maps auto`), a fitted exponent. They are decoded once and
/// kept, as floats, in an unnamed file beside the output. Reading, computing, compression and
/// writing overlap; memory grows with the map's width. The bytes written depend on inputs and
/// options alone, not on options.threads.
///
/// Returns the manifest that was written. Throws Error (or Cancelled); then nothing is left behind
/// and a set that stood in options.output is untouched.
Manifest bake(const BakeOptions& options, const BakeMonitor& monitor = {});

/// The same from any source, such as a field made on the fly. `manifest` says what the bake cannot
/// know: name, inputs, working space.
Manifest bake(Source& source, const BakeOptions& options, Manifest manifest,
              const BakeMonitor& monitor = {});

} // namespace scree
