// docs/errata.md: every section names tests that show the error, `Suite.Test`, and they are there.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "support/files.h"

namespace scree::test {
namespace {

std::set<std::string> names_of_tests()
{
    std::set<std::string> names;
    const auto& program = *::testing::UnitTest::GetInstance();
    for (int i = 0; i < program.total_test_suite_count(); ++i) {
        const auto& suite = *program.GetTestSuite(i);
        for (int k = 0; k < suite.total_test_count(); ++k)
            names.insert(std::string(suite.name()) + "." + suite.GetTestInfo(k)->name());
    }
    return names;
}

TEST(Errata, EverySectionNamesTestsThatAreThere)
{
    const auto tests = names_of_tests();
    std::istringstream page(read_bytes(SCREE_SOURCE "/docs/errata.md"));
    const std::regex test("`([A-Z]\\w+\\.[A-Z]\\w+)`");
    std::map<std::string, int> named; // by section
    std::string line, section;
    while (std::getline(page, line)) {
        if (line.rfind("## ", 0) == 0) {
            section = line;
            named[section] = 0;
        }
        for (std::sregex_iterator at(line.begin(), line.end(), test), end; at != end; ++at) {
            ++named[section];
            EXPECT_EQ(tests.count((*at)[1].str()), 1U) << (*at)[1].str();
        }
    }
    EXPECT_GE(named.size(), 8U);
    for (const auto& [title, count] : named)
        EXPECT_GT(count, 0) << title;
}

} // namespace
} // namespace scree::test
