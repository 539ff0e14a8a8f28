#include "support/markup.h"

#include <cctype>
#include <stdexcept>

namespace scree::test {

namespace {

class Reader {
public:
    explicit Reader(const std::string& text) : text_(text) {}

    std::vector<Element> read()
    {
        while (at_ < text_.size())
            if (text_[at_] == '<')
                tag();
            else
                character();
        if (open_ >= 0)
            fail("<" + elements_[static_cast<size_t>(open_)].name + "> is not closed");
        if (elements_.empty())
            fail("no element");
        return elements_;
    }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw std::runtime_error("at " + std::to_string(at_) + ": " + what + ": " +
                                 text_.substr(at_, 40));
    }

    [[nodiscard]] bool starts(const std::string& word) const
    {
        return text_.compare(at_, word.size(), word) == 0;
    }

    void expect(const std::string& word)
    {
        if (!starts(word))
            fail("expected " + word);
        at_ += word.size();
    }

    void spaces()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
    }

    std::string name()
    {
        const size_t begin = at_;
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                      text_[at_] == '-' || text_[at_] == ':'))
            ++at_;
        if (at_ == begin)
            fail("expected a name");
        return text_.substr(begin, at_ - begin);
    }

    std::string resolved()
    {
        const std::map<std::string, std::string> known = {
            {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}};
        if (text_[at_] != '&') {
            const auto byte = static_cast<unsigned char>(text_[at_]);
            if (byte < 0x20 && std::isspace(byte) == 0)
                fail("a control character");
            return {text_[at_++]};
        }
        for (const auto& [reference, meaning] : known)
            if (starts(reference)) {
                at_ += reference.size();
                return meaning;
            }
        fail("unknown reference");
    }

    void character()
    {
        const std::string c = resolved();
        if (open_ >= 0)
            elements_[static_cast<size_t>(open_)].text += c;
        else if (std::isspace(static_cast<unsigned char>(c.front())) == 0)
            fail("text outside the root");
    }

    void tag()
    {
        if (elements_.empty() && starts("<!DOCTYPE")) {
            at_ = text_.find('>', at_) + 1;
            return;
        }
        if (starts("</"))
            end_tag();
        else
            start_tag();
    }

    void end_tag()
    {
        expect("</");
        const std::string ended = name();
        if (open_ < 0 || elements_[static_cast<size_t>(open_)].name != ended)
            fail("</" + ended + "> does not close what is open");
        expect(">");
        open_ = elements_[static_cast<size_t>(open_)].parent;
    }

    void start_tag()
    {
        expect("<");
        if (open_ < 0 && !elements_.empty())
            fail("a second root");
        Element element{name(), {}, {}, open_};
        for (spaces(); !starts(">") && !starts("/>"); spaces())
            attribute(element);
        elements_.push_back(element);
        if (starts("/>")) {
            at_ += 2;
            return;
        }
        expect(">");
        open_ = static_cast<int>(elements_.size()) - 1;
    }

    void attribute(Element& element)
    {
        const std::string key = name();
        expect("=\"");
        std::string value;
        while (at_ < text_.size() && text_[at_] != '"') {
            if (text_[at_] == '<')
                fail("< in an attribute");
            value += resolved();
        }
        expect("\"");
        if (!element.attributes.emplace(key, value).second)
            fail("attribute " + key + " twice");
        if (!starts(">") && !starts("/>") &&
            std::isspace(static_cast<unsigned char>(text_[at_])) == 0)
            fail("no space after an attribute");
    }

    const std::string& text_;
    size_t at_ = 0;
    int open_ = -1;
    std::vector<Element> elements_;
};

} // namespace

std::vector<Element> parse_markup(const std::string& text) { return Reader(text).read(); }

std::vector<Element> elements_named(const std::vector<Element>& elements, const std::string& name)
{
    std::vector<Element> found;
    for (const auto& element : elements)
        if (element.name == name)
            found.push_back(element);
    return found;
}

} // namespace scree::test
