#include "texset/table_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include <nlohmann/json.hpp>

#include "math/error.h"
#include "support/files.h"
#include "texset/manifest.h"
#include "texset/staged_folder.h"

namespace scree {
namespace {

using test::TempFolder;

TableManifest some_manifest()
{
    TableManifest manifest;
    manifest.kind = "some";
    manifest.program_version = "1.2.3";
    manifest.description = "Numbers.";
    manifest.axes = {{"x", "1", "across", {0, 0.5, 1}},
                     {"y", "radians", "down", {-1, 1}},
                     {"z", "1", "slices", {0, 1, 2, 3}}};
    manifest.channels = {{"R", "a", "1", "first"}, {"G", "b", "radians", "second"}};
    manifest.options = {{"resolution", "3x2x4"}};
    manifest.figures = {{"rms error", 0.25}, {"another", 3}};
    return manifest;
}

std::vector<float> rising(size_t count)
{
    std::vector<float> values(count);
    for (size_t i = 0; i < count; ++i)
        values[i] = static_cast<float>(i);
    return values;
}

TEST(TableFile, HoldsTheValuesInTheLayoutTheManifestSays)
{
    const TempFolder temp;
    const TableManifest manifest = some_manifest();
    write_table(manifest, rising(48), temp.path());
    const auto image = test::read_levels(temp / "some.exr").at(0);
    ASSERT_EQ(image.width, 3);
    ASSERT_EQ(image.height, 8);
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x)
                for (int c = 0; c < 2; ++c)
                    EXPECT_EQ(image.at(x, 2 * z + y, c),
                              static_cast<float>(((z * 2 + y) * 3 + x) * 2 + c));
}

TEST(TableFile, ItsManifestComesBack)
{
    const TempFolder temp;
    const TableManifest want = some_manifest();
    write_table(want, rising(48), temp.path());
    const TableManifest got = read_table_manifest(temp.path());
    EXPECT_EQ(got.kind, want.kind);
    EXPECT_EQ(got.program_version, want.program_version);
    EXPECT_EQ(got.description, want.description);
    EXPECT_EQ(got.options, want.options);
    ASSERT_EQ(got.figures.size(), want.figures.size());
    for (size_t i = 0; i < want.figures.size(); ++i) {
        EXPECT_EQ(got.figures[i].name, want.figures[i].name);
        EXPECT_EQ(got.figures[i].value, want.figures[i].value);
    }
    ASSERT_EQ(got.axes.size(), want.axes.size());
    for (size_t i = 0; i < want.axes.size(); ++i) {
        EXPECT_EQ(got.axes[i].name, want.axes[i].name);
        EXPECT_EQ(got.axes[i].unit, want.axes[i].unit);
        EXPECT_EQ(got.axes[i].meaning, want.axes[i].meaning);
        EXPECT_EQ(got.axes[i].coordinates, want.axes[i].coordinates);
    }
    ASSERT_EQ(got.channels.size(), want.channels.size());
    for (size_t i = 0; i < want.channels.size(); ++i) {
        EXPECT_EQ(got.channels[i].name, want.channels[i].name);
        EXPECT_EQ(got.channels[i].quantity, want.channels[i].quantity);
        EXPECT_EQ(got.channels[i].unit, want.channels[i].unit);
        EXPECT_EQ(got.channels[i].meaning, want.channels[i].meaning);
    }
}

// For readers that go by the JSON alone.
TEST(TableFile, TheManifestStatesSizesRangesUnitsAndFile)
{
    const TempFolder temp;
    write_table(some_manifest(), rising(48), temp.path());
    const auto json = nlohmann::json::parse(test::read_bytes(temp / "some.scree-table.json"));
    EXPECT_EQ(json.at("format"), "scree table");
    EXPECT_EQ(json.at("version"), TableManifest::kFormatVersion);
    EXPECT_EQ(json.at("kind"), "some");
    EXPECT_EQ(json.at("file"), "some.exr");
    EXPECT_EQ(json.at("width"), 3);
    EXPECT_EQ(json.at("height"), 8);
    ASSERT_EQ(json.at("axes").size(), 3U);
    const auto& y = json.at("axes").at(1);
    EXPECT_EQ(y.at("name"), "y");
    EXPECT_EQ(y.at("unit"), "radians");
    EXPECT_EQ(y.at("size"), 2);
    EXPECT_EQ(y.at("range"), (std::vector<double>{-1, 1}));
    EXPECT_EQ(y.at("coordinates"), (std::vector<double>{-1, 1}));
    ASSERT_EQ(json.at("channels").size(), 2U);
    EXPECT_EQ(json.at("channels").at(1).at("name"), "G");
    EXPECT_EQ(json.at("channels").at(1).at("unit"), "radians");
    EXPECT_EQ(json.at("options").at("resolution"), "3x2x4");
    EXPECT_EQ(json.at("figures").at("rms error"), 0.25);
}

TEST(TableFile, AnotherFormatIsNoTable)
{
    const TempFolder temp;
    write_table(some_manifest(), rising(48), temp.path());
    const auto path = temp / "some.scree-table.json";
    auto json = nlohmann::json::parse(test::read_bytes(path));
    json["format"] = "scree texture set";
    std::ofstream(path) << json;
    EXPECT_THROW(read_table_manifest(temp.path()), Error);
    std::ofstream(path) << "{ \"format\": \"scree ta";
    EXPECT_THROW(read_table_manifest(temp.path()), Error);
}

TEST(TableFile, ADamagedManifestIsNamedAndItsFolderNotReplaced)
{
    const TempFolder temp;
    write_table(some_manifest(), rising(48), temp.path());
    EXPECT_EQ(files_of_table(temp.path()),
              (std::set<std::string>{"some.exr", "some.scree-table.json"}));
    std::ofstream(temp / "some.scree-table.json") << R"({"format": "scree table", "version": 2})";
    try {
        read_table_manifest(temp.path());
        FAIL() << "read a table of a later format";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("some.scree-table.json: is of format version 2"),
                  std::string::npos)
            << e.what();
    }
    EXPECT_TRUE(files_of_table(temp.path()).empty());
    EXPECT_THROW((StagedFolder{temp.path(), FolderKind::table}), Error);
}

TEST(TableFile, AManifestWithoutAxesOrCoordinatesIsDamaged)
{
    const TempFolder temp;
    const std::string head = R"({"format": "scree table", "version": 1, "program": "scree 1",)"
                             R"("kind": "some", "description": "", "channels": [], "axes": )";
    for (const std::string axes :
         {"[]", R"([{"name": "q", "unit": "1", "meaning": "", "coordinates": []}])"}) {
        std::ofstream(temp / "some.scree-table.json") << head << axes << "}";
        EXPECT_THROW(read_table_manifest(temp.path()), Error) << axes;
    }
}

TEST(TableFile, ATableIsReplacedByAnotherButNotWithWhatElseLiesThere)
{
    const TempFolder temp;
    const auto folder = temp / "table";
    for (int round = 0; round < 2; ++round) {
        StagedFolder staged(folder, FolderKind::table);
        write_table(some_manifest(), rising(48), staged.path());
        staged.publish();
    }
    EXPECT_EQ(files_of_table(folder).size(), 2U);
    std::ofstream(folder / "mine.txt") << "mine";
    EXPECT_THROW((StagedFolder{folder, FolderKind::table}), Error);
}

TEST(TableFile, NeitherTablesNorSetsTakeTheOthersPlace)
{
    const TempFolder temp;
    std::filesystem::create_directory(temp / "table");
    write_table(some_manifest(), rising(48), temp / "table");
    std::filesystem::create_directory(temp / "set");
    Manifest set;
    set.name = "a";
    write_manifest(set, temp / "set");
    EXPECT_NO_THROW((StagedFolder{temp / "table", FolderKind::table}));
    EXPECT_NO_THROW((StagedFolder{temp / "set", FolderKind::texture_set}));
    EXPECT_THROW((StagedFolder{temp / "table", FolderKind::texture_set}), Error);
    EXPECT_THROW((StagedFolder{temp / "set", FolderKind::table}), Error);
}

} // namespace
} // namespace scree
