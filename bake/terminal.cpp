#include "bake/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace scree::tool {

namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

void on_signal(int /*signal*/) { stop = true; }

} // namespace

void stop_on_signals()
{
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    std::signal(SIGHUP, on_signal);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

const std::atomic<bool>& stop_asked() { return stop; }

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress()
{
    if (!quiet_ && terminal_ && shown_ >= 0)
        fmt::print(stderr, "\r\033[K");
}

void Progress::show(const char* phase, double done)
{
    constexpr int kWidth = 40;
    constexpr std::chrono::seconds kWorthShowing(1);
    if (quiet_)
        return;
    const int step = terminal_ ? 200 : 10;
    const int now = static_cast<int>(done * step);
    if (now == shown_ && phase_ == phase)
        return;
    phase_ = phase;
    shown_ = now;
    if (std::chrono::steady_clock::now() - begin_ < kWorthShowing)
        return;
    if (terminal_) {
        const int filled = now * kWidth / step;
        fmt::print(stderr, "\r{:8} [{:#<{}}{:.<{}}] {:3} %", phase, "", filled, "", kWidth - filled,
                   now * 100 / step);
    } else {
        fmt::print(stderr, "scree: {} {} %\n", phase, now * 10);
    }
    std::fflush(stderr);
}

BakeMonitor monitor_of(Progress& progress)
{
    return {[&progress](const char* phase, double done) { progress.show(phase, done); }, &stop};
}

} // namespace scree::tool
