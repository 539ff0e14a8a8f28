#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "pipeline/profile_pyramid.h"
#include "stats/moment_layout.h"
#include "stats/pyramid.h"

namespace scree {

/// Looks at the texels of every level as they are made.
class TexelVisitor {
public:
    virtual ~TexelVisitor() = default;

    /// Rows [begin, end) of a level come next. One thread.
    virtual void rows_begin(int /*level*/, int /*begin*/, int /*end*/) {}

    /// `count` texels of one row, from column x0 on. Columns come in fixed blocks of
    /// kBlockColumns; different blocks on different threads, the rows of a block in order.
    virtual void texels(int level, int y, int x0, int count, MomentRow row) = 0;

    /// All rows below `end` of the level are made. One thread.
    virtual void rows_end(int /*level*/, int /*end*/) {}
};

constexpr int kBlockColumns = 256;

/// Level-0 rows in, rows of all levels out, in one pass.
///
/// Each level keeps the few rows the next one still needs, so memory grows with the width of the
/// map. The arithmetic of a texel does not depend on the number of threads.
class MomentPyramid {
public:
    MomentPyramid(const MomentLayout& layout, int width, int height,
                  std::vector<TexelVisitor*> visitors);

    /// Fills `count` texels of a level-0 row from column x0 on. Called on several threads.
    using Fill = std::function<void(int y, int x0, int count, MomentRow row)>;

    /// The next `rows` rows of level 0, and all rows of coarser levels they complete.
    void push(int rows, const Fill& fill);

private:
    struct Level {
        int width, height;
        int done = 0;             ///< rows made so far
        int capacity;             ///< rows kept, the last ones made
        std::vector<double> data; ///< row y is slot y % capacity
        std::vector<float> seen;  ///< likewise, of level 0
    };
    [[nodiscard]] MomentRow row(Level& level, int y) const;
    void push_batch(int rows, const Fill& fill);
    void make(int level, int rows, const Fill& fill);
    void make_run(int level, int y, int block, const Fill& fill);

    MomentLayout layout_;
    std::vector<TexelVisitor*> visitors_;
    std::vector<Level> levels_;
    std::vector<Reduction> reductions_;      ///< [l] makes level l + 1
    std::optional<ProfilePyramid> profiles_; ///< where the layout has ranks
};

} // namespace scree
