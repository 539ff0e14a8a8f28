#pragma once

#include "sample/field.h"

namespace scree {

// One maker a kind; make_sample() checks the size.
std::unique_ptr<SampleField> make_fractal(int width, int height);
std::unique_ptr<SampleField> make_bricks(int width, int height);
std::unique_ptr<SampleField> make_vgroove(int width, int height);
std::unique_ptr<SampleField> make_sine(int width, int height);
std::unique_ptr<SampleField> make_plane(int width, int height);

} // namespace scree
