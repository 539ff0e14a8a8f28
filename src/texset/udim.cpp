#include "texset/udim.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "math/error.h"

namespace scree {

namespace fs = std::filesystem;

namespace {

const std::string kMarker = "<UDIM>";
constexpr size_t kDigits = 4;

/// The number between `before` and `after` in a file's name; 0: another file.
int number_in(const std::string& name, const std::string& before, const std::string& after)
{
    if (name.size() != before.size() + kDigits + after.size() || name.rfind(before, 0) != 0 ||
        name.compare(before.size() + kDigits, std::string::npos, after) != 0)
        return 0;
    int number = 0;
    for (const char digit : name.substr(before.size(), kDigits)) {
        if (digit < '0' || digit > '9')
            return 0;
        number = 10 * number + (digit - '0');
    }
    return number >= kFirstUdim ? number : 0;
}

} // namespace

UdimTile udim_tile(int number) { return {(number - kFirstUdim) % 10, (number - kFirstUdim) / 10}; }

bool has_number(const UdimTile& tile)
{
    return tile.u >= 0 && tile.u < 10 && tile.v >= 0 && tile.number() <= kLastUdim;
}

bool is_tiled(const fs::path& file) { return file.string().find(kMarker) != std::string::npos; }

fs::path file_of_tile(const fs::path& file, int number)
{
    std::string name = file.filename().string();
    const size_t place = name.find(kMarker);
    if (place == std::string::npos)
        return file;
    return file.parent_path() / name.replace(place, kMarker.size(), fmt::format("{}", number));
}

std::vector<int> tiles_of(const fs::path& tiled)
{
    const std::string name = tiled.filename().string();
    const size_t place = name.find(kMarker);
    if (place == std::string::npos || is_tiled(tiled.parent_path()) ||
        name.find(kMarker, place + 1) != std::string::npos)
        throw Error(
            fmt::format("{}: expected {} once, in the name of the file", tiled.string(), kMarker));
    const fs::path folder = tiled.has_parent_path() ? tiled.parent_path() : ".";
    std::error_code refused;
    fs::directory_iterator entry(folder, refused);
    if (refused)
        throw Error(
            fmt::format("{}: its folder cannot be read: {}", tiled.string(), refused.message()));
    std::vector<int> numbers;
    for (; entry != fs::directory_iterator(); ++entry)
        if (const int number = number_in(entry->path().filename().string(), name.substr(0, place),
                                         name.substr(place + kMarker.size())))
            numbers.push_back(number);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::string stem_of(const fs::path& file)
{
    std::string stem = file.stem().string();
    const size_t place = stem.find(kMarker);
    if (place == std::string::npos)
        return stem;
    const std::string joints = "._- ";
    std::string before = stem.substr(0, place);
    std::string after = stem.substr(place + kMarker.size());
    while (!before.empty() && joints.find(before.back()) != std::string::npos)
        before.pop_back();
    if (before.empty())
        while (!after.empty() && joints.find(after.front()) != std::string::npos)
            after.erase(0, 1);
    return before + after;
}

std::string tile_list(const std::vector<int>& numbers, size_t most)
{
    const size_t shown = std::min(numbers.size(), most);
    std::string list = fmt::format(
        "{}", fmt::join(numbers.begin(), numbers.begin() + static_cast<ptrdiff_t>(shown), ", "));
    if (shown < numbers.size())
        list += fmt::format(" and {} more", numbers.size() - shown);
    return list;
}

} // namespace scree
