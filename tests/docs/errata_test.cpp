// docs/errata.md: every section names tests that show the error, `Suite.Test`, and they are there.

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

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

bool is_capital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// What stands in `backquotes` and is two words, each with a capital, with a dot between.
std::vector<std::string> names_in(const std::string& line)
{
    std::vector<std::string> names;
    for (size_t begin = line.find('`'); begin != std::string::npos;) {
        const size_t end = line.find('`', begin + 1);
        if (end == std::string::npos)
            break;
        const std::string word = line.substr(begin + 1, end - begin - 1);
        const size_t dot = word.find('.');
        const bool is_name = word.find_first_of(" /") == std::string::npos &&
                             dot != std::string::npos && dot + 1 < word.size() &&
                             is_capital(word[0]) && is_capital(word[dot + 1]);
        if (is_name)
            names.push_back(word);
        begin = line.find('`', end + 1);
    }
    return names;
}

TEST(Errata, EverySectionNamesTestsThatAreThere)
{
    const auto tests = names_of_tests();
    std::istringstream page(read_bytes(SCREE_SOURCE "/docs/errata.md"));
    std::map<std::string, int> named; // by section
    std::string line, section;
    while (std::getline(page, line)) {
        if (line.rfind("## ", 0) == 0) {
            section = line;
            named[section] = 0;
        }
        for (const std::string& name : names_in(line)) {
            ++named[section];
            EXPECT_EQ(tests.count(name), 1U) << name;
        }
    }
    EXPECT_GE(named.size(), 8U);
    for (const auto& [title, count] : named)
        EXPECT_GT(count, 0) << title;
}

} // namespace
} // namespace scree::test
