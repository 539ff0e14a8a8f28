#include "judge/inputs.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "math/error.h"
#include "support/files.h"
#include "texset/file_hash.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

fs::path written(const fs::path& file, const std::string& text)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file;
}

Manifest made_of(const fs::path& height)
{
    Manifest manifest;
    InputRecord input;
    input.role = "height";
    input.file = height.filename().string();
    input.sha256 = sha256_of_file(height);
    manifest.inputs.push_back(input);
    return manifest;
}

std::string error_of(const Manifest& manifest, const fs::path& set,
                     const std::vector<fs::path>& folders)
{
    try {
        find_inputs(manifest, set, folders);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(Inputs, AreFoundBesideTheSetAndDeepInTheFoldersGiven)
{
    const TempFolder temp;
    const auto original = written(temp / "art" / "deep" / "rock.exr", "heights");
    const Manifest manifest = made_of(original);
    fs::create_directories(temp / "rock.set");
    EXPECT_EQ(find_inputs(manifest, temp / "rock.set", {temp / "art"}).height, original);

    const auto beside = written(temp / "rock.exr", "heights");
    EXPECT_EQ(fs::canonical(find_inputs(manifest, temp / "rock.set", {}).height),
              fs::canonical(beside));
    EXPECT_EQ(fs::canonical(find_inputs(manifest, (temp / "rock.set").string() + "/", {}).height),
              fs::canonical(beside));
}

TEST(Inputs, AnotherFileOfThatNameIsPassedByOrNamed)
{
    const TempFolder temp;
    const auto original = written(temp / "a" / "rock.exr", "heights");
    const Manifest manifest = made_of(original);
    written(temp / "b" / "rock.exr", "other heights");
    fs::create_directories(temp / "set");
    EXPECT_EQ(find_inputs(manifest, temp / "set", {temp / "b", temp / "a"}).height, original);
    const std::string error = error_of(manifest, temp / "set", {temp / "b"});
    EXPECT_NE(error.find("rock.exr: is not the file the set was baked from"), std::string::npos)
        << error;
}

TEST(Inputs, MissingOnesAreNamedWithTheRemedy)
{
    const TempFolder temp;
    const Manifest manifest = made_of(written(temp / "a" / "rock.exr", "heights"));
    fs::create_directories(temp / "sets" / "rock");
    const std::string error = error_of(manifest, temp / "sets" / "rock", {});
    EXPECT_NE(error.find("rock.exr"), std::string::npos) << error;
    EXPECT_NE(error.find("--inputs"), std::string::npos) << error;
    EXPECT_NE(error_of(manifest, temp / "sets" / "rock", {temp / "no"}).find("is no folder"),
              std::string::npos);
    EXPECT_NE(error_of({}, temp / "sets" / "rock", {}).find("not baked from files"),
              std::string::npos);
}

} // namespace
} // namespace scree::test
