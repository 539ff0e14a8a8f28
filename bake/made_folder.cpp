#include "bake/made_folder.h"

#include <fmt/format.h>

#include "math/error.h"

namespace scree::tool {

MadeFolder::MadeFolder(std::filesystem::path path) : path_(std::move(path))
{
    std::error_code failed;
    made_ = std::filesystem::create_directories(path_, failed);
    if (failed)
        throw Error(fmt::format("{}: cannot be made: {}", path_.string(), failed.message()));
}

MadeFolder::~MadeFolder()
{
    std::error_code not_empty;
    if (made_)
        std::filesystem::remove(path_, not_empty);
}

} // namespace scree::tool
