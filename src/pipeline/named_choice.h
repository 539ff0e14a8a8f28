#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <utility>

#include "math/error.h"

namespace scree {

/// The words an option takes, each with what it stands for.
template <class T>
using Choices = std::initializer_list<std::pair<const char*, T>>;

/// Throws Error naming the option and its words.
template <class T>
T named(const char* option, const std::string& name, const Choices<T>& choices)
{
    std::string known;
    for (const auto& [word, value] : choices) {
        if (name == word)
            return value;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", word);
    }
    throw Error(fmt::format("{} '{}' is unknown; use one of {}", option, name, known));
}

/// The word for a value; empty where there is none.
template <class T>
std::string name_of(T value, const Choices<T>& choices)
{
    for (const auto& [word, known] : choices)
        if (known == value)
            return word;
    return {};
}

} // namespace scree
