#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "judge/set_reader.h"
#include "judge/view_check.h"
#include "reference/displaced_surface.h"

namespace scree {

/// A root of mean squares over footprints, and the reference's own part of it.
struct NodeError {
    double set = 0, noise = 0;
};

/// What tables of visibility are off at one node (`level` < 0: all levels).
///
/// Compared are the means over the table's azimuths, the numbers that files hold: harmonics are
/// judged by the views of a ViewCheck.
struct NodeErrors {
    int level = -1;
    double angle_deg = 0;
    int footprints = 0;
    NodeError area;  ///< of a = E[V W] / cos theta - 1
    NodeError color; ///< of E[c V W] / cos theta - E[c], over the rms of the map's mean color
};

struct NodeCheck {
    std::vector<NodeErrors> all;     ///< per node, all levels together
    std::vector<NodeErrors> levels;  ///< per level and node
    long long samples = 0, rays = 0; ///< taken of the surface, and cast from them
    double seconds = 0;              ///< that they took
};

constexpr int kMostNodeFootprints = 16; ///< a level: every one is seen from all azimuths

/// Whether a set shows its colors by tables of visibility.
bool has_tables(const SetReader& set);

/// Compares the tables of a set with what the reference sees from the nodes, from the azimuths that
/// were swept.
///
/// set       has_tables()
/// surface   that it was baked from
/// plan      its footprints (up to kMostNodeFootprints a level), grid and seed
/// progress  as of reference::gather_all
/// Throws Error where the set cannot be read.
NodeCheck check_nodes(SetReader& set, const reference::DisplacedSurface& surface,
                      const ViewPlan& plan, const std::function<void(double)>& progress);

} // namespace scree
