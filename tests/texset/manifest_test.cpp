// The manifest: what is written is read, and what is damaged is refused with its name.

#include "texset/manifest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "math/error.h"
#include "support/files.h"

namespace scree::test {
namespace {

/// A manifest with no field at its default.
Manifest full_manifest()
{
    Manifest m;
    m.name = "brick \"wall\" \xc3\xa4"; // quotes and UTF-8
    m.program_version = "9.8.7";
    m.inputs = {{"height", "h.exr", "ab12", 99, 98, "Y", "half", ""},
                {"color", "c.png", "cd34", 97, 96, "R,G,B", "uint8", "srgb_tx"}};
    m.width = 99;
    m.height = 98;
    m.wrap_s = "clamp";
    m.wrap_t = "mirror";
    m.texel_width = 0.1; // not exact in binary: all digits must survive
    m.texel_height = 1.0 / 3;
    m.height_scale = -2.5;
    m.height_offset = 1e-300;
    m.reconstruction = "sobel";
    m.layout = "scree";
    m.working_space = "lin_rec709";
    m.has_height = true;
    m.h0 = 1234.000000000001;
    m.h1 = 7e-8;
    m.height_min = -3;
    m.height_max = 17.5;
    m.integer_bits = 16;
    m.quantum = 1.0 / 65535;
    m.no_data_texels = 5'000'000'000;
    m.half_tolerance = 0.02;
    m.compression = "piz";
    m.textures = {
        {Map::slope, "a.slope.exr", {"s", "ss", "st", "t", "tt"}, PixelType::half, 0.003, 1e-7},
        {Map::rank, "a.rank.exr", rank_channels(2), PixelType::float32, {}, {}}};
    m.color_map = {"slope", 30, -0.5, 0.75,
                   MapTableRecord{65, 17, -1, 1.25, 1.5, 0.01, 0.003, 0.02, 0.001, 0.004}};
    m.model_choice = {
        80, 0.02, {{"rank 2", 6, 0.01, 2, true}, {"without tail", -1, 0.3, 0, false}}};
    LevelSummary level;
    level.width = 99;
    level.height = 98;
    level.coverage = 0.75;
    level.mean_slope = {0.25, -0.5};
    level.steepest = {3, 4};
    level.rms_slope = 0.1;
    level.slope_sigma = 0.2;
    level.kurtosis = 9.5;
    level.tau = 0.3;
    level.height_sigma = 0.4;
    level.color_fit = {0.01, {{0.1, -0.2, 0.3}}, {{0.4, 0.5, 0.6}}, 0.21, 0.22, 0.23, 0.24, 0.25,
                       0.26};
    level.mean_color = {0.5, 0.6, 0.7};
    level.exponent = {0.8, 1.2, 0.03};
    level.model_errors = {{"mean color", 0.3}, {"visible 4x3", 0.02}};
    LevelSummary bare;
    bare.width = bare.height = 49;
    m.levels = {level, bare};
    m.visibility = {{55, 74.5}, 1, 8, {}};
    m.options = {{"wrap", "clamp mirror"}, {"texel-size", "0.1 0.333"}};
    m.warnings = {"first", "second"};
    return m;
}

void expect_equal(const LevelSummary& a, const LevelSummary& b)
{
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.coverage, b.coverage);
    EXPECT_EQ(a.mean_slope, b.mean_slope);
    EXPECT_EQ(a.steepest, b.steepest);
    EXPECT_EQ(a.rms_slope, b.rms_slope);
    EXPECT_EQ(a.slope_sigma, b.slope_sigma);
    EXPECT_EQ(a.kurtosis, b.kurtosis);
    EXPECT_EQ(a.tau, b.tau);
    EXPECT_EQ(a.height_sigma, b.height_sigma);
    EXPECT_EQ(a.mean_color, b.mean_color);
    ASSERT_EQ(a.exponent.has_value(), b.exponent.has_value());
    if (a.exponent) {
        EXPECT_EQ(a.exponent->gain, b.exponent->gain);
        EXPECT_EQ(a.exponent->power, b.exponent->power);
        EXPECT_EQ(a.exponent->threshold, b.exponent->threshold);
    }
    ASSERT_EQ(a.model_errors.size(), b.model_errors.size());
    for (size_t i = 0; i < a.model_errors.size(); ++i) {
        EXPECT_EQ(a.model_errors[i].model, b.model_errors[i].model);
        EXPECT_EQ(a.model_errors[i].error, b.model_errors[i].error);
    }
    ASSERT_EQ(a.color_fit.has_value(), b.color_fit.has_value());
    if (a.color_fit) {
        EXPECT_EQ(a.color_fit->sigma, b.color_fit->sigma);
        EXPECT_EQ(a.color_fit->height_correlation, b.color_fit->height_correlation);
        EXPECT_EQ(a.color_fit->slope_correlation, b.color_fit->slope_correlation);
        EXPECT_EQ(a.color_fit->height, b.color_fit->height);
        EXPECT_EQ(a.color_fit->slope, b.color_fit->slope);
        EXPECT_EQ(a.color_fit->rank1, b.color_fit->rank1);
        EXPECT_EQ(a.color_fit->rank2, b.color_fit->rank2);
        EXPECT_EQ(a.color_fit->rank4, b.color_fit->rank4);
        EXPECT_EQ(a.color_fit->residual, b.color_fit->residual);
    }
}

std::string message_of_reading(const std::filesystem::path& set)
{
    try {
        read_manifest(set);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

void write_text(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from << " is not in the manifest";
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(ManifestFile, EveryFieldComesBackToTheLastBit)
{
    TempFolder temp;
    const Manifest m = full_manifest();
    write_manifest(m, temp.path());
    for (const auto& set : {temp.path(), temp / (m.name + ".scree.json")}) {
        const Manifest r = read_manifest(set);
        EXPECT_EQ(r.name, m.name);
        EXPECT_EQ(r.program_version, m.program_version);
        ASSERT_EQ(r.inputs.size(), m.inputs.size());
        for (size_t i = 0; i < m.inputs.size(); ++i) {
            EXPECT_EQ(r.inputs[i].role, m.inputs[i].role);
            EXPECT_EQ(r.inputs[i].file, m.inputs[i].file);
            EXPECT_EQ(r.inputs[i].sha256, m.inputs[i].sha256);
            EXPECT_EQ(r.inputs[i].width, m.inputs[i].width);
            EXPECT_EQ(r.inputs[i].height, m.inputs[i].height);
            EXPECT_EQ(r.inputs[i].channels, m.inputs[i].channels);
            EXPECT_EQ(r.inputs[i].type, m.inputs[i].type);
            EXPECT_EQ(r.inputs[i].color_space, m.inputs[i].color_space);
        }
        ASSERT_TRUE(r.color_map && r.color_map->table && r.model_choice);
        EXPECT_EQ(r.color_map->by, m.color_map->by);
        EXPECT_EQ(r.color_map->azimuth_deg, m.color_map->azimuth_deg);
        EXPECT_EQ(r.color_map->first, m.color_map->first);
        EXPECT_EQ(r.color_map->last, m.color_map->last);
        EXPECT_EQ(r.color_map->table->columns, m.color_map->table->columns);
        EXPECT_EQ(r.color_map->table->rows, m.color_map->table->rows);
        EXPECT_EQ(r.color_map->table->low, m.color_map->table->low);
        EXPECT_EQ(r.color_map->table->high, m.color_map->table->high);
        EXPECT_EQ(r.color_map->table->widest, m.color_map->table->widest);
        EXPECT_EQ(r.color_map->table->tolerance, m.color_map->table->tolerance);
        EXPECT_EQ(r.color_map->table->rms_error, m.color_map->table->rms_error);
        EXPECT_EQ(r.color_map->table->largest_error, m.color_map->table->largest_error);
        EXPECT_EQ(r.color_map->table->shortcut_rms, m.color_map->table->shortcut_rms);
        EXPECT_EQ(r.color_map->table->shortcut_largest, m.color_map->table->shortcut_largest);
        ASSERT_TRUE(r.visibility);
        EXPECT_EQ(r.visibility->node_angles_deg, m.visibility->node_angles_deg);
        EXPECT_EQ(r.visibility->harmonics, m.visibility->harmonics);
        EXPECT_EQ(r.visibility->azimuths, m.visibility->azimuths);
        EXPECT_EQ(r.model_choice->max_view_angle_deg, m.model_choice->max_view_angle_deg);
        EXPECT_EQ(r.model_choice->tolerance, m.model_choice->tolerance);
        ASSERT_EQ(r.model_choice->models.size(), m.model_choice->models.size());
        for (size_t i = 0; i < m.model_choice->models.size(); ++i) {
            EXPECT_EQ(r.model_choice->models[i].model, m.model_choice->models[i].model);
            EXPECT_EQ(r.model_choice->models[i].channels, m.model_choice->models[i].channels);
            EXPECT_EQ(r.model_choice->models[i].error, m.model_choice->models[i].error);
            EXPECT_EQ(r.model_choice->models[i].rank_terms, m.model_choice->models[i].rank_terms);
            EXPECT_EQ(r.model_choice->models[i].chosen, m.model_choice->models[i].chosen);
        }
        EXPECT_EQ(r.width, m.width);
        EXPECT_EQ(r.height, m.height);
        EXPECT_EQ(r.wrap_s, m.wrap_s);
        EXPECT_EQ(r.wrap_t, m.wrap_t);
        EXPECT_EQ(r.texel_width, m.texel_width);
        EXPECT_EQ(r.texel_height, m.texel_height);
        EXPECT_EQ(r.height_scale, m.height_scale);
        EXPECT_EQ(r.height_offset, m.height_offset);
        EXPECT_EQ(r.reconstruction, m.reconstruction);
        EXPECT_EQ(r.layout, m.layout);
        EXPECT_EQ(r.working_space, m.working_space);
        EXPECT_EQ(r.has_height, m.has_height);
        EXPECT_EQ(r.h0, m.h0);
        EXPECT_EQ(r.h1, m.h1);
        EXPECT_EQ(r.height_min, m.height_min);
        EXPECT_EQ(r.height_max, m.height_max);
        EXPECT_EQ(r.integer_bits, m.integer_bits);
        EXPECT_EQ(r.quantum, m.quantum);
        EXPECT_EQ(r.no_data_texels, m.no_data_texels);
        EXPECT_EQ(r.half_tolerance, m.half_tolerance);
        EXPECT_EQ(r.compression, m.compression);
        ASSERT_EQ(r.textures.size(), m.textures.size());
        for (size_t i = 0; i < m.textures.size(); ++i) {
            EXPECT_EQ(r.textures[i].map, m.textures[i].map);
            EXPECT_EQ(r.textures[i].file, m.textures[i].file);
            EXPECT_EQ(r.textures[i].channels, m.textures[i].channels);
            EXPECT_EQ(r.textures[i].type, m.textures[i].type);
            EXPECT_EQ(r.textures[i].half_error, m.textures[i].half_error);
            EXPECT_EQ(r.textures[i].float_error, m.textures[i].float_error);
        }
        ASSERT_EQ(r.levels.size(), m.levels.size());
        for (size_t i = 0; i < m.levels.size(); ++i)
            expect_equal(r.levels[i], m.levels[i]);
        EXPECT_EQ(r.options, m.options);
        EXPECT_EQ(r.warnings, m.warnings);
    }
}

TEST(ManifestFile, ReadingAndWritingAgainMakesTheSameText)
{
    TempFolder temp;
    Manifest normals = full_manifest(); // what a set from a normal map leaves out
    normals.has_height = false;
    normals.working_space.clear();
    for (const Manifest& m : {full_manifest(), normals}) {
        write_manifest(m, temp.path());
        const std::string once = read_bytes(temp / (m.name + ".scree.json"));
        EXPECT_EQ(once, to_json(m));
        EXPECT_EQ(to_json(read_manifest(temp.path())), once);
    }
}

TEST(ManifestFile, AManifestCutShortIsCalledDamagedByName)
{
    TempFolder temp;
    const auto path = temp / "a.scree.json";
    const std::string text = to_json(full_manifest());
    for (const size_t size : {size_t{0}, size_t{1}, size_t{30}, text.size() / 2, text.size() - 3}) {
        write_text(path, text.substr(0, size));
        const std::string message = message_of_reading(temp.path());
        EXPECT_NE(message.find(path.string() + ": damaged manifest"), std::string::npos)
            << size << " bytes: " << message;
    }
}

TEST(ManifestFile, FieldsMissingOrOfAnotherKindAreErrorsThatNameThemAndTheFile)
{
    TempFolder temp;
    const auto path = temp / "a.scree.json";
    const std::string text = to_json(full_manifest());
    struct Damage {
        const char *from, *to, *message;
    };
    const Damage damages[] = {
        {"\"width\": 99", "\"width\": \"wide\"", "'width' is text, expected a whole number"},
        {"\"width\": 99", "\"width\": 9.5", "'width' is 9.5, expected a whole number"},
        {"\"width\": 99", "\"width\": 3e9", "'width' is 3e+09, expected a whole number"},
        {"\"width\": 99", "\"breadth\": 99", "'width' is missing"},
        {"\"width\": 99", "\"width\": 1e999", "a number in it is too large"},
        {"\"texel_size\": [", "\"texel_size\": [], \"was\": [",
         "'texel_size' is a list of 0, expected one of 2"},
        {"\"map\": \"slope\"", "\"map\": \"slopes\"", "a map 'slopes'"},
        {"\"h1\"", "\"h7\"", "'h1' is missing"},
        {"\"levels\": [\n", "\"levels\": [3,\n", "'levels[0]' is a number, expected an object"},
        {"\"warnings\": [\n", "\"warnings\": [null,\n", "'warnings[0]' is null, expected text"},
        {"\"format_version\"", "\"version\"", "'format_version' is missing"}};
    for (const Damage& damage : damages) {
        write_text(path, replaced(text, damage.from, damage.to));
        const std::string message = message_of_reading(path);
        EXPECT_EQ(message.find(path.string() + ": damaged manifest: "), 0U) << message;
        EXPECT_NE(message.find(damage.message), std::string::npos)
            << damage.from << " -> " << damage.to << ": " << message;
        EXPECT_NE(message.find("; bake the set again"), std::string::npos) << message;
    }
}

TEST(ManifestFile, WhatIsNoManifestIsNotCalledDamaged)
{
    TempFolder temp;
    const auto path = temp / "a.scree.json";
    const std::string other =
        replaced(to_json(full_manifest()), "scree texture set", "some other file");
    for (const std::string& text :
         {other, std::string("[]"), std::string("3"), std::string("null"), std::string("{}"),
          std::string("{\"format\": 2}"), std::string("some notes\n")}) {
        write_text(path, text);
        EXPECT_EQ(message_of_reading(path),
                  path.string() +
                      ": not a Scree manifest; name the folder of a texture set, or the "
                      "file NAME.scree.json in it")
            << text;
    }
}

TEST(ManifestFile, DamageToTheTextIsFoundByItsLine)
{
    TempFolder temp;
    const auto path = temp / "a.scree.json";
    const std::string text = to_json(full_manifest());
    write_text(path, replaced(text, "\"width\": 99,", "\"width\": 99;"));
    const auto line =
        1 + std::count(text.begin(),
                       text.begin() + static_cast<std::ptrdiff_t>(text.find("\"width\": 99")),
                       '\n');
    EXPECT_NE(message_of_reading(path).find("no JSON from line " + std::to_string(line) + " on"),
              std::string::npos)
        << message_of_reading(path);
}

TEST(ManifestFile, ALaterFormatVersionIsRefusedAndTellsWhatToDo)
{
    TempFolder temp;
    const auto path = temp / "a.scree.json";
    write_text(
        path, replaced(to_json(full_manifest()), "\"format_version\": 3", "\"format_version\": 4"));
    const std::string message = message_of_reading(temp.path());
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    EXPECT_NE(message.find("format version 4"), std::string::npos) << message;
    EXPECT_NE(message.find("newer scree"), std::string::npos) << message;
}

TEST(ManifestFile, NoneAndSeveralAreErrors)
{
    TempFolder temp;
    EXPECT_NE(message_of_reading(temp.path()).find("no texture set"), std::string::npos);
    EXPECT_NE(message_of_reading(temp / "missing").find("no such folder"), std::string::npos);
    Manifest m = full_manifest();
    m.name = "a";
    write_manifest(m, temp.path());
    m.name = "b";
    write_manifest(m, temp.path());
    EXPECT_NE(message_of_reading(temp.path()).find("2 manifests"), std::string::npos);
    EXPECT_EQ(read_manifest(temp / "b.scree.json").name, "b");
}

TEST(ManifestFile, FilesOfASetAreItsTexturesAndItself)
{
    TempFolder temp;
    EXPECT_TRUE(files_of_set(temp.path()).empty());
    Manifest m = full_manifest();
    m.name = "a";
    write_manifest(m, temp.path());
    EXPECT_EQ(files_of_set(temp.path()),
              (std::set<std::string>{"a.scree.json", "a.slope.exr", "a.rank.exr"}));
    write_text(temp / "a.scree.json", "{");
    EXPECT_TRUE(files_of_set(temp.path()).empty()); // damaged: not known to be ours
}

TEST(ManifestFile, AFolderThatCannotBeWrittenToIsNamed)
{
    TempFolder temp;
    try {
        write_manifest(full_manifest(), temp / "missing");
        ADD_FAILURE() << "written";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find((temp / "missing").string()), std::string::npos);
    }
}

// JSON has no NaN; one in a summary must not make a set that cannot be read again.
TEST(ManifestFile, ANumberThatIsNotOneIsReadAsAbsent)
{
    TempFolder temp;
    Manifest m = full_manifest();
    m.levels[0].kurtosis = std::numeric_limits<double>::quiet_NaN();
    write_manifest(m, temp.path());
    EXPECT_FALSE(read_manifest(temp.path()).levels[0].kurtosis.has_value());
}

TEST(Manifest, NamesThatAreNoUtf8AreTold)
{
    Manifest m = full_manifest();
    m.warnings = {"h\xe9ights.exr"}; // Latin-1
    EXPECT_NE(to_json(m).find("h\xef\xbf\xbdights.exr"), std::string::npos);
}

TEST(Manifest, TablesOfVisibilityHaveHarmonicsOrAxes)
{
    TempFolder temp;
    Manifest m = full_manifest();
    m.visibility = {{55, 74.5}, 0, 8, -12.5};
    write_manifest(m, temp.path());
    const Manifest r = read_manifest(temp.path());
    ASSERT_TRUE(r.visibility && r.visibility->axis_deg);
    EXPECT_EQ(*r.visibility->axis_deg, -12.5);
    EXPECT_EQ(r.visibility->node_angles_deg, m.visibility->node_angles_deg);
}

} // namespace
} // namespace scree::test
