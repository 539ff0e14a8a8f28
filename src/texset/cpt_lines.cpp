#include "texset/cpt_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <system_error>

#include "math/error.h"

namespace scree {

namespace {

/// No color table is as long; what is, is something else or hostile.
constexpr size_t kMostPieces = 65536;
constexpr size_t kMostBytes = 64 << 20;

bool is_binary(unsigned char c) { return std::iscntrl(c) != 0 && std::isspace(c) == 0; }

/// Reads line after line into CptLines.
class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    void read(std::string text)
    {
        ++line_;
        if (std::any_of(text.begin(), text.end(), is_binary))
            fail("not text; expected a color table of GMT");
        const size_t begin = text.find_first_not_of(" \t\r");
        if (begin == std::string::npos)
            return;
        if (text[begin] == '#')
            read_comment(text.substr(begin + 1));
        else
            read_colors(text.substr(0, text.find(';')));
    }

    CptLines lines;

    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error(fmt::format("{}: line {}: {}", file_, line_, what));
    }

private:
    /// `# KEYWORD` or `# KEYWORD = value`; any other comment does not count.
    void read_comment(const std::string& text)
    {
        const size_t equals = text.find('=');
        std::string key, more, value;
        std::istringstream(text.substr(0, equals)) >> key >> more;
        if (!more.empty())
            return;
        if (equals != std::string::npos)
            std::istringstream(text.substr(equals + 1)) >> value;
        if (key == "COLOR_MODEL") {
            read_model(value);
        } else if (key == "RANGE") {
            read_range(value);
        } else if (key == "HINGE") { // as older tables say it
            lines.hinge = number(value);
            lines.hard_hinge = true;
        } else if (key == "HARD_HINGE") {
            lines.hard_hinge = true;
        } else if (key == "SOFT_HINGE") {
            lines.soft_hinge = true;
        } else if (key == "CYCLIC") {
            fail("a cyclic table repeats, a color map ends; take the line out to use one turn");
        }
    }

    void read_model(std::string model)
    {
        std::transform(model.begin(), model.end(), model.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        lines.hsv_model = model == "HSV" || model == "+HSV";
        if (!lines.hsv_model && model != "RGB" && model != "+RGB" && model != "GRAY")
            fail(fmt::format("color model '{}'; expected RGB or HSV", model));
    }

    void read_range(const std::string& text)
    {
        const size_t slash = text.find('/');
        if (slash == std::string::npos)
            fail(fmt::format("RANGE '{}'; expected two numbers, low/high", text));
        lines.range = {number(text.substr(0, slash)), number(text.substr(slash + 1))};
        if (!((*lines.range)[0] < (*lines.range)[1]))
            fail(fmt::format("RANGE '{}' does not rise; expected low/high", text));
    }

    void read_colors(const std::string& text)
    {
        if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c > 126; }))
            fail("not plain text; expected a color table of GMT");
        std::vector<std::string> words;
        std::istringstream in(text);
        for (std::string word; words.size() < 10 && in >> word;)
            words.push_back(word);
        if (words.empty())
            return;
        if (words[0] == "B" || words[0] == "F" || words[0] == "N")
            return read_outside(words);
        // Annotation flags mark boundaries for a legend.
        if (words.size() > 2 && (words.back() == "L" || words.back() == "U" || words.back() == "B"))
            words.pop_back();

        CptPiece piece;
        piece.line = line_;
        piece.z0 = piece.z1 = number(words[0]);
        const size_t half = words.size() / 2;
        if (words.size() == 2) {
            piece.color0 = piece.color1 = color({words[1]});
        } else if (words.size() == 4 || words.size() == 8) {
            const auto middle = words.begin() + static_cast<ptrdiff_t>(half);
            piece.color0 = color({words.begin() + 1, middle});
            piece.z1 = number(*middle);
            piece.color1 = color({middle + 1, words.end()});
            if (!(piece.z0 < piece.z1))
                fail(fmt::format("z goes from {} to {}; it must rise", piece.z0, piece.z1));
        } else {
            fail(fmt::format("'{}'; expected z0 color z1 color, or z color", shown(text)));
        }
        const bool category = words.size() == 2;
        if (!lines.pieces.empty() && category != lines.categories)
            fail("categories (z color) among pieces (z0 color z1 color); expected one kind");
        if (lines.pieces.size() == kMostPieces)
            fail(fmt::format("more than {} colors; expected a color table of GMT", kMostPieces));
        lines.categories = category;
        lines.pieces.push_back(piece);
    }

    void read_outside(const std::vector<std::string>& words)
    {
        if (words[0] == "N")
            return;
        const CptColor found = color({words.begin() + 1, words.end()});
        (words[0] == "B" ? lines.below : lines.above) = found;
    }

    [[nodiscard]] double number(const std::string& text) const
    {
        const auto value = decimal_number(text);
        if (!value)
            fail(fmt::format("'{}' is not a number", shown(text)));
        return *value;
    }

    /// One word, or three numbers.
    [[nodiscard]] CptColor color(const std::vector<std::string>& words) const
    {
        std::optional<CptColor> found;
        if (words.size() == 1)
            found = cpt_color(words[0], lines.hsv_model);
        else if (words.size() == 3)
            found = cpt_color(Rgb{number(words[0]), number(words[1]), number(words[2])},
                              lines.hsv_model);
        if (!found)
            fail(fmt::format("'{}' is not a color; expected r/g/b of 0 to 255, h-s-v, a gray, "
                             "#rrggbb or a name",
                             words.empty() ? "" : shown(words[0])));
        return *found;
    }

    /// Text for a message, cut where it is too long for a line.
    static std::string shown(const std::string& text)
    {
        return text.size() > 60 ? text.substr(0, 60) + "..." : text;
    }

    std::string file_;
    int line_ = 0;
};

} // namespace

CptLines read_cpt_lines(const std::filesystem::path& path)
{
    const std::string file = path.string();
    std::error_code failed;
    if (std::filesystem::file_size(path, failed) > kMostBytes && !failed)
        throw Error(fmt::format("{}: more than {} MiB; expected a color table of GMT", file,
                                kMostBytes >> 20));
    std::ifstream in(path, std::ios::binary);
    Reader reader(file);
    for (std::string line; std::getline(in, line);)
        reader.read(line);
    if (in.bad() || !in.eof())
        throw Error(fmt::format("{}: cannot be read", file));
    if (reader.lines.pieces.empty())
        reader.fail("the file ends without a color; expected lines z0 color z1 color");
    return std::move(reader.lines);
}

} // namespace scree
