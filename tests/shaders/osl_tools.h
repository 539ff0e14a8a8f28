#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::test {

/// Programs of Open Shading Language, from $OSL_ROOT/bin or from PATH; empty where they are not.
struct OslTools {
    std::filesystem::path oslc, testshade, testrender;
    [[nodiscard]] bool found() const
    {
        return !oslc.empty() && !testshade.empty() && !testrender.empty();
    }
};
OslTools find_osl();

/// What a program said and how it ended.
struct RunResult {
    int status = -1;
    std::string said; ///< stdout and stderr
};

/// Runs a program in `folder`, arguments as they are.
RunResult run(const std::filesystem::path& folder, const std::vector<std::string>& command);

} // namespace scree::test
