#include "chart/temp_folder.h"

#include <fmt/format.h>
#include <stdlib.h> // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include <cerrno>
#include <string>
#include <system_error>

#include "math/error.h"

namespace scree {

TempFolder::TempFolder()
{
    std::string name = (std::filesystem::temp_directory_path() / "scree-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw Error(fmt::format("{}: no temporary folder can be made there: {}; name another place "
                                "in $TMPDIR",
                                std::filesystem::path(name).parent_path().string(),
                                std::generic_category().message(errno)));
    path_ = name;
}

TempFolder::~TempFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace scree
