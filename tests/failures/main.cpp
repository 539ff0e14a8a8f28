// Where methods fail: measures the 23 cases, checks that every figure of ours is inside its bound,
// and writes the page of results, or checks that it is up to date.
//
//   scree_failure_cases [NUMBER ...]
//   scree_failure_cases -o PAGE.md
//   scree_failure_cases --check PAGE.md

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "failures/cases.h"
#include "failures/page.h"
#include "failures/page_check.h"
#include "math/error.h"
#include "support/files.h"

namespace scree::test {
namespace {

struct Words {
    std::vector<int> numbers; ///< empty: all cases
    std::string page, checked_page;
};

constexpr const char* kUsage =
    "usage: scree_failure_cases [NUMBER ...] | -o PAGE.md | --check PAGE.md";
constexpr int kSkipped = 77; // to ctest

Words words_of(int argc, char** argv)
{
    Words words;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "-o" && i + 1 < argc)
            words.page = argv[++i];
        else if (word == "--check" && i + 1 < argc)
            words.checked_page = argv[++i];
        else if (const int number = std::atoi(word.c_str()); number > 0)
            words.numbers.push_back(number);
        else
            throw Error(kUsage);
    }
    if (!(words.page + words.checked_page).empty() && !words.numbers.empty())
        throw Error(std::string("a page has all cases; ") + kUsage);
    return words;
}

/// One line a case, and one a figure that is out of its bound. Returns whether all are inside.
bool print(const FailureCase& entry, const Measured& measured)
{
    std::printf("%2d %-36s %s\n", entry.number, entry.title.c_str(),
                verdict_name(our_verdict(measured)).c_str());
    bool holds = !measured.figures.empty();
    for (const Figure& figure : measured.figures)
        if (!figure.holds()) {
            holds = false;
            std::printf("   OUT OF BOUND: %s: %.9g, expected %.9g within %.3g of %.3g\n",
                        figure.what().c_str(), figure.our_value(), figure.truth(), figure.allowed(),
                        figure.yardstick());
        }
    return holds;
}

/// Measures and prints those asked for. Returns whether all are inside their bounds.
bool measure(const std::vector<int>& numbers, std::vector<Result>& results)
{
    bool holds = true;
    for (const FailureCase& entry : all_cases())
        if (numbers.empty() ||
            std::find(numbers.begin(), numbers.end(), entry.number) != numbers.end()) {
            results.push_back({entry, entry.measure()});
            holds = print(entry, results.back().measured) && holds;
        }
    if (results.empty())
        throw Error("no such case");
    return holds;
}

void write(const std::string& text, const std::string& file)
{
    std::ofstream out(file);
    out << text;
    out.close();
    if (!out)
        throw Error(file + ": cannot be written");
}

int run(const Words& words)
{
    std::string page;
    if (!words.checked_page.empty()) {
        page = read_bytes(words.checked_page);
        if (page.empty())
            throw Error(words.checked_page + ": cannot be read; write it with -o");
        if (!is_of_this_maketx(page)) {
            std::printf("skipped: %s was written with another maketx\n",
                        words.checked_page.c_str());
            return kSkipped;
        }
    }
    std::vector<Result> results;
    bool holds = measure(words.numbers, results);
    if (!words.page.empty())
        write(page_of(results), words.page);
    if (!words.checked_page.empty()) {
        const std::string change = difference(page, page_of(results));
        holds = holds && change.empty();
        if (!change.empty())
            std::printf("%s: out of date: %s; write it anew with -o\n", words.checked_page.c_str(),
                        change.c_str());
    }
    return holds ? 0 : 1;
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv)
{
    testing::GTEST_FLAG(throw_on_failure) = true; // of what tests/support asserts
    testing::InitGoogleTest(&argc, argv);
    scree::test::Words words;
    try {
        words = scree::test::words_of(argc, argv);
    } catch (const scree::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    try {
        return scree::test::run(words);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "scree_failure_cases: error: %s\n", error.what());
        return 1;
    }
}
