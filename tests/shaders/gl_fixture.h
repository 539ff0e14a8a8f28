#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "shaders/gl_context.h"

namespace scree::test {

/// A test that runs in both dialects of GLSL. Without EGL and Mesa it is skipped, but not where a
/// server runs it: there it must not go unnoticed.
class Glsl : public testing::TestWithParam<GlApi> {
protected:
    void SetUp() override
    {
        std::string reason;
        context_ = GlContext::make(GetParam(), reason);
        if (context_)
            return;
        if (std::getenv("CI") != nullptr)
            FAIL() << reason;
        GTEST_SKIP() << reason;
    }

    GlContext& context() { return *context_; }

private:
    std::unique_ptr<GlContext> context_;
};

/// For INSTANTIATE_TEST_SUITE_P.
inline auto both_dialects() { return testing::Values(GlApi::desktop_330, GlApi::es_300); }

inline std::string dialect_name(const testing::TestParamInfo<GlApi>& info)
{
    return info.param == GlApi::desktop_330 ? "Desktop330" : "Es300";
}

} // namespace scree::test
