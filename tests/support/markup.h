#pragma once

#include <map>
#include <string>
#include <vector>

namespace scree::test {

/// An element as it stands in XML, with the text that lies in it directly.
struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text; ///< references resolved
    int parent = -1;  ///< index of the element around it
};

/// The elements of an XML text in the order of their start tags. XHTML is read too: a document type
/// declaration, and style sheets taken as text.
///
/// Throws std::runtime_error where the text is not well-formed: tags out of balance, an attribute
/// twice or without quotes, a bare & or <, an unknown reference, more than one root.
std::vector<Element> parse_markup(const std::string& text);

/// Those of a name.
std::vector<Element> elements_named(const std::vector<Element>& elements, const std::string& name);

} // namespace scree::test
