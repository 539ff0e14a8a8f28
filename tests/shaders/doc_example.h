#pragma once

#include <string>

#include "support/files.h"

namespace scree::test {

/// The first code block of a page of docs/ in that language; empty when there is none.
inline std::string doc_example(const std::string& language,
                               const std::string& page = "filtering.md")
{
    const std::string text = read_bytes(SCREE_SOURCE "/docs/" + page);
    const std::string fence = "```" + language + "\n";
    const size_t start = text.find(fence);
    if (start == std::string::npos)
        return {};
    const size_t first = start + fence.size();
    return text.substr(first, text.find("```", first) - first);
}

} // namespace scree::test
