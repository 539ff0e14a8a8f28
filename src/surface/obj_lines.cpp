#include "surface/obj_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "math/error.h"

namespace scree {

namespace {

constexpr std::string_view kBlank = " \t";
/// The library counts corners in a byte.
constexpr int kMostCorners = 255;
/// The library reads no more of one kind in a tag.
constexpr int kMostTagValues = 8192;

/// The first word of `line`, which loses it; empty at the end.
std::string_view next_word(std::string_view& line)
{
    const size_t start = std::min(line.find_first_not_of(kBlank), line.size());
    const size_t end = std::min(line.find_first_of(kBlank, start), line.size());
    const std::string_view word = line.substr(start, end - start);
    line.remove_prefix(end);
    return word;
}

bool is_finite_number(std::string_view word)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

class Checker {
public:
    explicit Checker(const std::string& file) : file_(file) {}

    void check(std::string_view line)
    {
        ++line_;
        if (line.find('\0') != std::string_view::npos)
            fail("is not text; expected OBJ as ASCII or UTF-8");
        const std::string_view keyword = next_word(line);
        if (keyword == "v")
            expect_numbers(line, 3, "a vertex");
        else if (keyword == "vt")
            expect_numbers(line, 2, "a texture coordinate");
        else if (keyword == "f")
            expect_corners(line);
        else if (keyword == "t")
            expect_tag(line);
    }

    int tags = 0;

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error(fmt::format("{}: line {}: {}", file_, line_, what));
    }

    void expect_numbers(std::string_view line, int count, const char* what) const
    {
        for (int i = 0; i < count; ++i) {
            const std::string_view word = next_word(line);
            if (word.empty())
                fail(fmt::format("{} of {} numbers, expected {}; is the file cut short?", what, i,
                                 count));
            if (!is_finite_number(word))
                fail(fmt::format("{} with \"{}\", expected {} finite numbers; repair it or export "
                                 "the mesh again",
                                 what, word, count));
        }
    }

    void expect_corners(std::string_view line) const
    {
        int corners = 0;
        while (!next_word(line).empty())
            ++corners;
        if (corners < 3)
            fail(fmt::format("a face of {} corners, expected 3 or more; remove it, or is the file "
                             "cut short?",
                             corners));
        if (corners > kMostCorners)
            fail(fmt::format("a face of {} corners, expected at most {}; split it", corners,
                             kMostCorners));
    }

    void expect_tag(std::string_view line)
    {
        ++tags;
        const std::string name(next_word(line));
        std::string_view counts = next_word(line);
        int values = 0;
        for (int kind = 0; kind < 3; ++kind) {
            const size_t end = std::min(counts.find('/'), counts.size());
            int count = -1;
            std::from_chars(counts.data(), counts.data() + end, count);
            if (count < 0 || count > kMostTagValues)
                fail(fmt::format("tag {}: expected its counts as integers/reals/strings, each 0 to "
                                 "{}",
                                 name, kMostTagValues));
            values += count;
            counts.remove_prefix(std::min(end + 1, counts.size()));
        }
        int words = 0;
        while (!next_word(line).empty())
            ++words;
        if (words != values)
            fail(fmt::format("tag {}: {} values, expected {}; is the file cut short?", name, words,
                             values));
    }

    const std::string& file_;
    int line_ = 0;
};

} // namespace

int check_obj_lines(std::string_view text, const std::string& file)
{
    Checker checker(file);
    while (!text.empty()) {
        const size_t end = std::min(text.find_first_of("\r\n"), text.size());
        checker.check(text.substr(0, end));
        const bool two = text.substr(end, 2) == "\r\n";
        text.remove_prefix(std::min(text.size(), end + (two ? 2 : 1)));
    }
    return checker.tags;
}

} // namespace scree
