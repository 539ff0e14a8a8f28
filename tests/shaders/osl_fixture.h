#pragma once

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "shaders/osl_tools.h"
#include "support/files.h"

namespace scree::test {

/// A test that compiles and runs shaders in a folder of its own, with oslc, testshade and
/// testrender of an install found through $OSL_ROOT or PATH. Skipped, and said so, where there is
/// none.
class Osl : public ::testing::Test {
protected:
    void SetUp() override
    {
        tools_ = find_osl();
        if (!tools_.found())
            GTEST_SKIP()
                << "no oslc, testshade, testrender: set OSL_ROOT to an install of Open Shading "
                   "Language 1.13, or put its bin folder on PATH";
    }

    void compile(const std::string& source)
    {
        const RunResult result =
            run(temp_.path(), {tools_.oslc.string(), "-I" SCREE_SOURCE "/src",
                               "-I" SCREE_SOURCE "/tests/kernel", SCREE_SOURCE "/" + source});
        ASSERT_EQ(result.status, 0) << result.said;
        EXPECT_EQ(result.said.find("warning"), std::string::npos) << result.said;
    }

    /// A line of arguments without quotes or spaces in them.
    static std::vector<std::string> words(const std::string& line)
    {
        std::istringstream in(line);
        return {std::istream_iterator<std::string>(in), {}};
    }

    /// testshade ends with 0 whatever a shader reports, so what it says is looked at too.
    RunResult shade(const std::vector<std::string>& arguments)
    {
        std::vector<std::string> command = {tools_.testshade.string(), "--center", "-d", "float"};
        command.insert(command.end(), arguments.begin(), arguments.end());
        RunResult result = run(temp_.path(), command);
        if (result.said.find("ERROR") != std::string::npos && result.status == 0)
            result.status = 1;
        return result;
    }

    Image output(const std::string& name) { return read_levels(temp_ / (name + ".exr")).at(0); }

    TempFolder temp_;
    OslTools tools_;
};

} // namespace scree::test
