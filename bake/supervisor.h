#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace scree::tool {

/// Runs the program's work in a child process, so that a crash has an end a user can read.
///
/// Image libraries abort or fault on some damaged files, and the system may kill a process that
/// runs out of memory. The parent, which does nothing but wait, then names the inputs, removes the
/// staging folder and returns 1. Signals to stop are passed on. Costs one fork, before any thread.
///
/// work  returns the exit status
int run_supervised(const std::function<int()>& work);

/// What the parent should say and clean up if this process dies: the files being read, and the
/// folder being written (empty: none). Called in the child.
void note_for_supervisor(const std::vector<std::string>& inputs,
                         const std::filesystem::path& output);

} // namespace scree::tool
