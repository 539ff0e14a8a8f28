#include "texset/color_map_file.h"

#include <algorithm>
#include <cctype>

#include "texset/cpt_file.h"
#include "texset/lut_file.h"
#include "texset/readable.h"
#include "texset/strip_file.h"

namespace scree {

ColorMapFile read_color_map(const std::filesystem::path& path)
{
    expect_readable(path, "a color map (.cpt, a 1-D LUT or an image)");
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".cpt")
        return read_cpt(path);
    return is_lut_ending(ending) ? read_lut(path) : read_strip(path);
}

} // namespace scree
