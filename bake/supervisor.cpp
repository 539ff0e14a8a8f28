#include "bake/supervisor.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "texset/staged_folder.h"

namespace scree::tool {

namespace {

/// Shared by both processes; plain bytes, since it is read after a crash.
struct Note {
    char inputs[4096];
    char output[4096];
};

Note* note = nullptr;
volatile pid_t child = 0;

void pass_on(int signal)
{
    if (child > 0)
        kill(child, signal);
}

void copy(const std::string& text, char (&to)[4096])
{
    std::strncpy(to, text.c_str(), sizeof to - 1);
}

int wait_for_child()
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return 1;
    if (WIFEXITED(status))
        return WEXITSTATUS(status);

    const int signal = WTERMSIG(status);
    if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
        return 128 + signal;
    const std::string what = note->inputs[0] != '\0' ? note->inputs : "scree";
    const char* reason = signal == SIGKILL ? "was killed, perhaps for want of memory"
                                           : "crashed; the file is damaged, or else report this";
    fmt::print(stderr, "scree: error: {}: {} (signal {})\n", what, reason, signal);
    if (note->output[0] != '\0')
        StagedFolder::remove_leftovers(note->output, child);
    return 1;
}

} // namespace

int run_supervised(const std::function<int()>& work)
{
    void* shared =
        mmap(nullptr, sizeof(Note), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED)
        return work();
    note = static_cast<Note*>(shared);

    const pid_t parent = getpid();
    child = fork();
    if (child < 0)
        return work();
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        const bool orphan = getppid() != parent; // it died before we asked
        const int status = orphan ? 1 : work();
        std::fflush(nullptr);
        // Not exit(): a library that OpenImageIO brings (log4cplus) starts threads when it is
        // loaded, which a fork does not copy, and waits for them in its destructor.
        _exit(status);
    }
    // kill reaches only us; Ctrl-C both, and a second signal does no harm.
    std::signal(SIGINT, pass_on);
    std::signal(SIGTERM, pass_on);
    std::signal(SIGHUP, pass_on);
    return wait_for_child();
}

void note_for_supervisor(const std::vector<std::string>& inputs,
                         const std::filesystem::path& output)
{
    if (note == nullptr)
        return;
    std::string names;
    for (const auto& input : inputs)
        if (!input.empty())
            names += (names.empty() ? "" : ", ") + input;
    copy(names, note->inputs);
    copy(output.string(), note->output);
}

} // namespace scree::tool
