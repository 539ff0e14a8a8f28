// A folder appears whole or not at all.

#include "texset/staged_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "math/error.h"
#include "support/files.h"
#include "texset/manifest.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}

/// A texture set of one file that holds `text`.
void write_set(const fs::path& folder, const std::string& text)
{
    fs::create_directories(folder);
    Manifest manifest;
    manifest.name = "a";
    manifest.textures = {{Map::slope, "a.slope.exr", {}, PixelType::half, {}, {}}};
    write_manifest(manifest, folder);
    write_text(folder / "a.slope.exr", text);
}

std::set<std::string> entries(const fs::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

std::string refusal(const fs::path& folder)
{
    try {
        const StagedFolder staged(folder);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

const std::set<std::string> kSet = {"a.scree.json", "a.slope.exr"};

TEST(StagedFolder, PublishPutsEveryFileInPlaceAndLeavesNothingElse)
{
    TempFolder temp;
    {
        StagedFolder staged(temp / "set");
        write_set(staged.path(), "new");
        EXPECT_FALSE(fs::exists(temp / "set"));
        EXPECT_EQ(staged.path().parent_path(), temp.path()); // one file system: rename works
        staged.publish();
        EXPECT_EQ(entries(temp / "set"), kSet);
    }
    EXPECT_EQ(entries(temp / "set"), kSet);
    EXPECT_EQ(entries(temp.path()), std::set<std::string>{"set"});
}

TEST(StagedFolder, WithoutPublishNothingIsLeftBehind)
{
    TempFolder temp;
    {
        const StagedFolder staged(temp / "set");
        write_set(staged.path(), "half done");
        fs::create_directory(staged.path() / "deeper");
    }
    EXPECT_TRUE(entries(temp.path()).empty());
}

TEST(StagedFolder, AnOldSetIsReplacedWholeAndSurvivesAFailure)
{
    TempFolder temp;
    write_set(temp / "set", "old");
    {
        const StagedFolder staged(temp / "set");
        write_set(staged.path(), "failed");
    }
    EXPECT_EQ(read_bytes(temp / "set" / "a.slope.exr"), "old");
    {
        StagedFolder staged(temp / "set");
        write_text(staged.path() / "b.scree.json", "new"); // other names: the old ones must go
        EXPECT_EQ(read_bytes(temp / "set" / "a.slope.exr"), "old");
        staged.publish();
    }
    EXPECT_EQ(entries(temp / "set"), std::set<std::string>{"b.scree.json"});
    EXPECT_EQ(entries(temp.path()), std::set<std::string>{"set"});
}

TEST(StagedFolder, AnEmptyFolderIsFilledAndMissingParentsAreMade)
{
    TempFolder temp;
    fs::create_directory(temp / "empty");
    for (const auto& folder : {temp / "empty", temp / "x" / "y" / "set"}) {
        StagedFolder staged(folder);
        write_set(staged.path(), "new");
        staged.publish();
        EXPECT_EQ(entries(folder), kSet) << folder;
    }
}

TEST(StagedFolder, ATrailingSlashMakesNoDifference)
{
    TempFolder temp;
    const fs::path slashed = (temp / "set").string() + "/";
    for (int again = 0; again < 2; ++again) {
        StagedFolder staged(slashed);
        write_set(staged.path(), "new");
        staged.publish();
    }
    EXPECT_EQ(entries(temp / "set"), kSet);
    EXPECT_EQ(entries(temp.path()), std::set<std::string>{"set"});
}

TEST(StagedFolder, WhatAUserPutThereIsRefusedByNameAndUntouched)
{
    TempFolder temp;
    fs::create_directory(temp / "photos");
    write_text(temp / "photos" / "cat.jpg", "cat");
    EXPECT_NE(refusal(temp / "photos").find((temp / "photos").string() + ": not empty"),
              std::string::npos);
    EXPECT_EQ(read_bytes(temp / "photos" / "cat.jpg"), "cat");

    write_set(temp / "set", "old");
    write_text(temp / "set" / "notes.txt", "mine");
    EXPECT_NE(refusal(temp / "set").find("'notes.txt'"), std::string::npos);
    EXPECT_EQ(read_bytes(temp / "set" / "notes.txt"), "mine");
    EXPECT_EQ(read_bytes(temp / "set" / "a.slope.exr"), "old");

    write_text(temp / "file", "a file");
    EXPECT_NE(refusal(temp / "file").find("not a folder"), std::string::npos);
    EXPECT_EQ(read_bytes(temp / "file"), "a file");

    EXPECT_NE(refusal(temp / "file" / "set").find((temp / "file" / "set").string()),
              std::string::npos);
    EXPECT_NE(refusal("").find("no folder"), std::string::npos);
    EXPECT_EQ(entries(temp.path()), (std::set<std::string>{"photos", "set", "file"}));
}

TEST(StagedFolder, ASetWithADamagedManifestIsNotReplaced)
{
    TempFolder temp;
    write_set(temp / "set", "old");
    write_text(temp / "set" / "a.scree.json", "{");
    EXPECT_NE(refusal(temp / "set").find("not empty"), std::string::npos);
    EXPECT_EQ(entries(temp / "set"), kSet);
}

TEST(StagedFolder, AParentThatCannotBeWrittenToIsAnError)
{
    if (geteuid() == 0)
        GTEST_SKIP() << "root may write everywhere";
    TempFolder temp;
    fs::create_directory(temp / "locked");
    fs::permissions(temp / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(refusal(temp / "locked" / "set").find("cannot write beside it"), std::string::npos);
    fs::permissions(temp / "locked", fs::perms::owner_all);
}

TEST(StagedFolder, WhatAKilledRunLeftIsClearedAway)
{
    TempFolder temp;
    fs::path left;
    {
        const StagedFolder staged(temp / "set");
        left = staged.path();
    }
    write_set(left, "of a killed run");
    StagedFolder staged(temp / "set");
    EXPECT_TRUE(fs::is_empty(staged.path()));
}

} // namespace
} // namespace scree::test
