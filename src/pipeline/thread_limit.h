#pragma once

#include <tbb/global_control.h>

#include <algorithm>
#include <thread>

#include "texset/image_threads.h"

namespace scree {

/// Limits all threads, Scree's and those of the image libraries, while it exists.
class ThreadLimit {
public:
    /// asked  0: all there are
    explicit ThreadLimit(int asked)
        : threads_(asked > 0 ? asked
                             : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))),
          tbb_(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads_))
    {
        set_image_threads(threads_);
    }

private:
    int threads_;
    tbb::global_control tbb_;
};

} // namespace scree
