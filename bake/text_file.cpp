#include "bake/text_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "math/error.h"
#include "texset/writable.h"

namespace scree::tool {

void write_text(const std::string& text, const std::filesystem::path& file)
{
    const auto target = file_to_replace(file);
    const auto partial =
        target.parent_path() / fmt::format(".{}.scree-{}", target.filename().string(), getpid());
    std::ofstream out(partial, std::ios::binary);
    out << text;
    out.close();
    std::error_code failed;
    if (out)
        std::filesystem::rename(partial, target, failed);
    if (out && !failed)
        return;
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw Error(fmt::format("{}: cannot be written{}; is there room on the disk?", file.string(),
                            failed ? ": " + failed.message() : ""));
}

} // namespace scree::tool
