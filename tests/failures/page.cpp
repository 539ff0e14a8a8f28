#include "failures/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "failures/maketx.h"
#include "math/error.h"

namespace scree::test {
namespace {

/// Four digits; rounding errors are 0, so that the page is the same on every machine.
std::string number(double value, double yardstick)
{
    if (std::isnan(value))
        return "NaN";
    if (std::isinf(value))
        return value > 0 ? "infinite" : "-infinite";
    if (std::abs(value) < 1e-6 * yardstick)
        return "0";
    // No exponents where a few zeros do.
    const double size = std::abs(value);
    const int digits = 3 - static_cast<int>(std::floor(std::log10(size)));
    if (size >= 1e-4 && size < 1e6) {
        std::string text = fmt::format("{:.{}f}", value, std::max(digits, 0));
        if (text.find('.') != std::string::npos)
            text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.')
            text.pop_back();
        return text;
    }
    return fmt::format("{:.4g}", value);
}

std::string percent(double share)
{
    return share < 0.1 ? fmt::format("{:.2g} %", 100 * share)
                       : fmt::format("{:.0f} %", 100 * share);
}

std::string error_words(const Figure& figure)
{
    const double error = figure.error_of(figure.our_value());
    if (std::isinf(error))
        return "not a number";
    if (error < 1e-3)
        return "< 0.1 %";
    const std::string& name = figure.yardstick_name();
    if (error < 2)
        return percent(error) + (name.empty() ? "" : " of " + name);
    return fmt::format("{:.2g} times {}", error, name.empty() ? "the truth" : name);
}

/// The number of others and whose it is.
std::string peer_words(const Figure& figure)
{
    if (figure.peer_way().empty())
        return "";
    if (!figure.peer_value())
        throw Error("the page compares with " + figure.peer_way() +
                    ", which needs maketx on PATH (openimageio-tools 2.4)");
    return number(*figure.peer_value(), figure.yardstick()) + " (" + figure.peer_way() + ")";
}

std::string anchor_of(const std::string& title) // as a link within the page
{
    std::string anchor;
    for (const char c : title)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ' || c == '-')
            anchor += '-';
    return anchor;
}

std::string heading_of(const FailureCase& entry)
{
    return fmt::format("{}. {}", entry.number, entry.title);
}

std::string overview_row(const Result& result)
{
    const Figure& figure = shown_figure(result.measured);
    const std::string heading = heading_of(result.entry);
    return fmt::format("| [{}](#{}) | {} | {} | {} | {} | {} | {} |\n", heading, anchor_of(heading),
                       figure.what(), number(figure.truth(), figure.yardstick()),
                       peer_words(figure), number(figure.our_value(), figure.yardstick()),
                       verdict_name(peer_verdict(result.measured)),
                       verdict_name(our_verdict(result.measured)));
}

std::string figure_row(const Figure& figure)
{
    return fmt::format("| {} | {} | {} | {} | {}{} |\n", figure.what(),
                       number(figure.truth(), figure.yardstick()), peer_words(figure),
                       number(figure.our_value(), figure.yardstick()), error_words(figure),
                       figure.is_aside() ? ", not judged" : "");
}

/// Words at most `width` characters a line.
std::string wrapped(const std::string& text, size_t width = 105)
{
    std::string out;
    size_t column = 0;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find_first_of(" \n", at), text.size());
        const size_t length = end - at;
        if (column > 0 && column + 1 + length > width) {
            out += '\n';
            column = 0;
        } else if (column > 0) {
            out += ' ';
            ++column;
        }
        out += text.substr(at, length);
        column += length;
        at = end + 1;
    }
    return out + "\n";
}

/// What Scree says, a list an asset.
std::string our_words(const Measured& measured)
{
    std::string out, last;
    for (const auto& [asset, words] : measured.our_words) {
        if (words.empty())
            out += "\nScree says nothing of " + asset + ".\n";
        else if (asset != last)
            out += "\nScree says of " + asset + ":\n\n";
        if (!words.empty())
            out += wrapped("- " + words);
        last = asset;
    }
    return out;
}

std::string section(const Result& result)
{
    const FailureCase& entry = result.entry;
    std::string out = fmt::format("\n## {}\n\n", heading_of(entry));
    out += wrapped("**Asset.** " + entry.asset) + "\n" + wrapped(entry.happens) + "\n";
    out +=
        "| figure | truth | others | Scree | error of Scree |\n| --- | --- | --- | --- | --- |\n";
    for (const Figure& figure : result.measured.figures)
        out += figure_row(figure);
    out += our_words(result.measured);
    const Verdict ours = our_verdict(result.measured);
    out += "\n" + wrapped("**" + verdict_name(ours) + ".** " + entry.advice);
    return out;
}

std::string introduction()
{
    const std::string what =
        R"(Twenty-three ways for a filtered surface to go wrong, each on a small asset with a known answer:
what is true, what other ways in use give, what Scree gives. Truth is a closed form, an integral, a
sum over the asset's own texels, or the reference renderer. The others are `maketx --bumpslopes` of
OpenImageIO )" +
        maketx_version() +
        R"(, run as it is; published formulas, the misprint of [errata.md](errata.md) mended; and plain
code, which is a formula as one types it, without a guard. Scree's numbers come from sets baked and
read back, and from the kernel that renderers compile.)";
    const std::string verdicts = fmt::format(
        R"(A verdict is that of the worst figure of a case: **ok** within {:.0f} % of the truth (or of what
the table names, where that is more to the point), **limited** within {:.0f} %, **fails** beyond that
or where there is no number at all. Figures that are not judged come of options that one has to ask
for. Where Scree itself has
something to say of an asset, in `scree bake` or `scree validate`, it is quoted. The overview shows
the figure that Scree is worst at, or the first where all are ok.)",
        100 * kOkWithin, 100 * kLimitedWithin);
    const std::string words =
        R"(Words: s and t are the axes of the texture; a slope is height over length; E[ss] is the mean
square of the slope along s, a deviation the root of a variance. Angles are between the view and the
upright of the surface. G1 is the share of the facets facing the viewer that nothing hides, Lambda = 1 /
G1 - 1. Colors are one number, the red, from 0 to 1.)";
    const std::string making =
        R"(`build/release/tests/failures/scree_failure_cases -o docs/failure-cases.md` writes this page;
`ctest -R failures` checks every number of Scree against the error it is allowed, and this page
against what the program would write.)";
    return "# Where methods fail\n\n" + wrapped(what) + "\n" + wrapped(verdicts) + "\n" +
           wrapped(words) + "\n" + wrapped(making) + "\n";
}

} // namespace

std::string verdict_name(Verdict verdict)
{
    switch (verdict) {
    case Verdict::ok:
        return "ok";
    case Verdict::limited:
        return "limited";
    default:
        return "fails";
    }
}

std::string page_of(const std::vector<Result>& results)
{
    std::string out = introduction();
    out += "| case | figure | truth | others | Scree | verdict on others | verdict on Scree |\n"
           "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Result& result : results)
        out += overview_row(result);
    for (const Result& result : results)
        out += section(result);
    return out;
}

} // namespace scree::test
