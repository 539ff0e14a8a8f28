#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "math/error.h"
#include "pipeline/options.h"

namespace scree::tool {

/// A mistake on the command line or in a recipe: exit status 2.
class UsageError : public Error {
public:
    using Error::Error;
};

/// From now on SIGINT and SIGTERM ask the work to stop instead of killing the program; writing to
/// a closed pipe or past a file size limit becomes an error instead of a signal.
void stop_on_signals();

/// Set once a signal came.
const std::atomic<bool>& stop_asked();

/// Shows how far a task is on stderr once it takes a second: a bar on a terminal, a line every
/// tenth elsewhere.
class Progress {
public:
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// done in [0, 1]; called from one thread at a time.
    void show(const char* phase, double done);

private:
    bool quiet_, terminal_;
    std::string phase_;
    int shown_ = -1;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// For long work: shows how far it is, and stops it once a signal came.
BakeMonitor monitor_of(Progress& progress);

} // namespace scree::tool
