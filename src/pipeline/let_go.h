#pragma once

#include <vector>

namespace scree {

/// Empties a vector and gives back its memory; `v = {}` would keep it.
template <class T>
void let_go(std::vector<T>& vector)
{
    std::vector<T>().swap(vector);
}

} // namespace scree
