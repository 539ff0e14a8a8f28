#include "texset/map_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "math/error.h"

namespace scree::test {

std::filesystem::path written(const TempFolder& folder, const std::string& name,
                              const std::string& text)
{
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
}

ColorMapFile map_of(const std::string& name, const std::string& text)
{
    const TempFolder folder;
    return read_color_map(written(folder, name, text));
}

std::string error_of(const std::filesystem::path& file)
{
    try {
        (void)read_color_map(file);
    } catch (const Error& e) {
        EXPECT_EQ(std::string(e.what()).find(file.string()), 0U) << e.what();
        return std::string(e.what()).substr(file.string().size());
    }
    ADD_FAILURE() << file << " was read";
    return {};
}

std::string error_of(const std::string& name, const std::string& text)
{
    const TempFolder folder;
    return error_of(written(folder, name, text));
}

void expect_parts(const std::string& message, std::initializer_list<const char*> parts)
{
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in: " << message;
}

void expect_color(const Rgb& got, const Rgb& want, double tolerance)
{
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(got[c], want[c], tolerance) << "channel " << c;
}

} // namespace scree::test
