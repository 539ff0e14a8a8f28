#pragma once

namespace scree::tool {

/// Raises the number of files this process may hold open to what the system allows: a set of many
/// tiles keeps some for each. Never fails; then it stays as it was.
void allow_many_open_files() noexcept;

} // namespace scree::tool
