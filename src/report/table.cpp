#include "report/table.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "report/markup.h"

namespace scree::report {

namespace {

enum class Word { number, blank, text };

/// Digits may be grouped by spaces, and a percent sign may follow; "-" stands for no value.
Word kind_of(std::string word)
{
    word.erase(std::remove(word.begin(), word.end(), ' '), word.end());
    if (!word.empty() && word.back() == '%')
        word.pop_back();
    if (word.empty() || word == "-")
        return Word::blank;
    const char* begin = word.data() + (word.front() == '+' ? 1 : 0);
    const char* end = word.data() + word.size();
    double value = 0;
    const auto parsed = std::from_chars(begin, end, value);
    const bool out_of_range = parsed.ec == std::errc::result_out_of_range;
    return parsed.ptr == end && (parsed.ec == std::errc() || out_of_range) ? Word::number
                                                                           : Word::text;
}

/// Whether each column holds numbers, and nothing else.
std::vector<bool> number_columns(const Table& table)
{
    std::vector<bool> numbers(table.headings.size());
    for (size_t c = 0; c < numbers.size(); ++c) {
        bool any = false, all = true;
        for (const auto& row : table.rows) {
            const Word kind = kind_of(row[c]);
            any = any || kind == Word::number;
            all = all && kind != Word::text;
        }
        numbers[c] = any && all;
    }
    return numbers;
}

std::string trimmed(std::string line)
{
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

std::string text_line(const std::vector<std::string>& words, const std::vector<size_t>& widths,
                      const std::vector<bool>& numbers)
{
    std::string line;
    for (size_t c = 0; c < words.size(); ++c) {
        const std::string padding(widths[c] - printed_width(words[c]), ' ');
        line += (c == 0 ? "" : "  ") + (numbers[c] ? padding + words[c] : words[c] + padding);
    }
    return trimmed(std::move(line)) + "\n";
}

std::string csv_word(const std::string& word)
{
    if (word.find_first_of(",\"\r\n") == std::string::npos)
        return word;
    std::string quoted = "\"";
    for (const char c : word)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csv_line(const std::vector<std::string>& words)
{
    std::string line;
    for (size_t c = 0; c < words.size(); ++c)
        line += (c == 0 ? "" : ",") + csv_word(words[c]);
    return line + "\r\n";
}

std::string html_row(const std::vector<std::string>& words, const std::vector<bool>& numbers,
                     const char* element)
{
    std::string row = "<tr>";
    for (size_t c = 0; c < words.size(); ++c)
        row += std::string("<") + element + (numbers[c] ? " class=\"number\">" : ">") +
               escaped(words[c]) + "</" + element + ">";
    return row + "</tr>\n";
}

} // namespace

std::string to_text(const Table& table)
{
    const auto numbers = number_columns(table);
    std::vector<size_t> widths;
    for (const auto& heading : table.headings)
        widths.push_back(printed_width(heading));
    for (const auto& row : table.rows)
        for (size_t c = 0; c < row.size(); ++c)
            widths[c] = std::max(widths[c], printed_width(row[c]));
    std::string text = table.title.empty() ? "" : table.title + "\n";
    text += text_line(table.headings, widths, numbers);
    for (const auto& row : table.rows)
        text += text_line(row, widths, numbers);
    return text;
}

std::string to_html(const Table& table)
{
    const auto numbers = number_columns(table);
    std::string html = "<table>\n";
    if (!table.title.empty())
        html += "<caption>" + escaped(table.title) + "</caption>\n";
    html += "<thead>" + html_row(table.headings, numbers, "th") + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows)
        html += html_row(row, numbers, "td");
    return html + "</tbody>\n</table>\n";
}

std::string to_csv(const Table& table)
{
    std::string csv = csv_line(table.headings);
    for (const auto& row : table.rows)
        csv += csv_line(row);
    return csv;
}

} // namespace scree::report
