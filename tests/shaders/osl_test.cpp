// The kernel and the shaders as Open Shading Language runs them.

#include <array>
#include <cmath>
#include <fstream>

#include "pipeline/bake.h"
#include "shaders/agreement.h"
#include "shaders/doc_example.h"
#include "shaders/exponent_levels.h"
#include "shaders/osl_fixture.h"
#include "shaders/sample_set.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

using Imath::V2f;
using Imath::V3f;

TEST_F(Osl, KernelAgreesWithCppOnTheWholeTable)
{
    const auto cases = kernel_cases();
    Image table{kInputs / 4, static_cast<int>(cases.size()), {"R", "G", "B", "A"}, {}};
    for (const KernelCase& row : cases)
        table.pixels.insert(table.pixels.end(), row.in.begin(), row.in.end());
    write_image(temp_ / "cases.exr", table);
    compile("tests/shaders/kernel_cases.osl");

    std::vector<std::string> arguments = {"-g",      "1",    std::to_string(cases.size()),
                                          "--param", "file", "cases.exr"};
    for (int i = 0; i < 14; ++i)
        for (const std::string& word :
             {std::string("-o"), "o" + std::to_string(i), "o" + std::to_string(i) + ".exr"})
            arguments.push_back(word);
    arguments.emplace_back("kernel_cases");
    const RunResult result = shade(arguments);
    ASSERT_EQ(result.status, 0) << result.said;

    std::vector<Outputs<float>> answers(cases.size());
    for (int i = 0; i < kOutputs; ++i) {
        const Image image = output("o" + std::to_string(i / 3));
        ASSERT_EQ(image.height, static_cast<int>(cases.size()));
        for (size_t k = 0; k < cases.size(); ++k)
            answers[k][static_cast<size_t>(i)] = image.at(0, static_cast<int>(k), i % 3);
    }
    expect_agreement(cases, answers, "OSL");
}

/// Bakes h.exr and c.exr, in float.
void bake_files(const TempFolder& temp)
{
    BakeOptions options;
    options.height_file = temp / "h.exr";
    options.color_file = temp / "c.exr";
    options.output = temp / "set";
    options.name = "rough";
    options.height_scale = 0.3;
    options.texel_size = {{1, 1}};
    options.wrap_s = options.wrap_t = Wrap::periodic;
    options.pixel_type = PixelTypeChoice::float32;
    bake(options);
}

/// A set of random heights and colors, 64x64.
void bake_random(const TempFolder& temp)
{
    write_image(temp / "h.exr", random_image(64, 64, {"Y"}, 31));
    write_image(temp / "c.exr", random_image(64, 64, {"R", "G", "B"}, 32));
    bake_files(temp);
}

// 16x16 pixels over 64x64 texels, pixel centres: the lookup is one texel of level 2. OpenImageIO
// finds the centre of a texel to 2^-23 of the image, the values here are at most 1 apart.
TEST_F(Osl, RawShaderGivesWhatTheCppFrontMakesOfTheSameTexels)
{
    bake_random(temp_);
    compile("src/shaders/scree_raw.osl");
    const SampleSet set = read_set(temp_ / "set");
    const V3f view = V3f(0.8F, -0.3F, 0.35F).normalized();
    const RunResult result = shade(words(
        "-g 16 16 --param folder set --param name rough --param light_exponent 0.7 "
        "--param base_alpha 0.1 --param:type=vector view 0.8,-0.3,0.35 "
        "-o visible_color color.exr -o visible_slope slope.exr "
        "-o visible_covariance covariance.exr -o masking masking.exr -o roughness roughness.exr "
        "scree_raw"));
    ASSERT_EQ(result.status, 0) << result.said;
    const Image color = output("color"), slope = output("slope"), covariance = output("covariance"),
                masking = output("masking"), roughness = output("roughness");
    ASSERT_EQ(color.width, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const auto slopes = slopes_of(set, 2, x, y);
            const auto visible = filter::visible_slopes(view, slopes);
            const auto hidden = filter::masking(view, slopes);
            const auto lobe = filter::beckmann_roughness(slopes.covariance, 0.1F);
            const std::array<std::pair<const Image*, V3f>, 5> all = {
                {{&color, visible_color(set, 2, x, y, view, {1, false, 0.7F})},
                 {&slope, {visible.area, visible.mean.x, visible.mean.y}},
                 {&covariance,
                  {visible.covariance.ss, visible.covariance.st, visible.covariance.tt}},
                 {&masking, {hidden.lambda, hidden.g1, slopes.tau}},
                 {&roughness, {lobe.alpha_x, lobe.alpha_y, lobe.angle_rad}}}};
            for (const auto& [image, want] : all)
                for (int i = 0; i < 3; ++i)
                    ASSERT_NEAR(image->at(x, y, i), want[i],
                                2e-5F * std::max(1.0F, std::abs(want[i])))
                        << "texel " << x << ' ' << y << " channel " << i;
        }
}

// Four tiles under one name, each looked up beyond 1 with v up, against the file of the tile alone.
TEST_F(Osl, TilesAreFoundByTheirNumber)
{
    write_image(temp_ / "lut.exr", random_image(5, 1, {"R", "G", "B"}, 33));
    for (int tile = 0; tile < 4; ++tile)
        write_image(temp_ / ("h." + std::to_string(1001 + tile % 2 + 10 * (tile / 2)) + ".exr"),
                    random_image(64, 64, {"Y"}, 40 + static_cast<unsigned>(tile)));
    BakeOptions options;
    options.height_file = temp_ / "h.<UDIM>.exr";
    options.colormap_file = temp_ / "lut.exr";
    options.output = temp_ / "set";
    options.name = "rough";
    options.height_scale = 0.3;
    options.texel_size = {{1, 1}};
    options.wrap_s = options.wrap_t = Wrap::clamp;
    options.pixel_type = PixelTypeChoice::float32;
    bake(options);
    compile("src/shaders/scree_raw.osl");
    const auto drawn = [&](const std::string& name, int u, int v, int color_model) {
        const RunResult result =
            shade(words("-g 16 16 --param folder set --param name " + name + " --offsetst " +
                        std::to_string(u) + " " + std::to_string(v) +
                        " --param flip_t 1 --param:type=vector view 0.8,-0.3,0.35 " +
                        "--param color_model " + std::to_string(color_model) +
                        " -o visible_color color.exr -o masking masking.exr scree_raw"));
        EXPECT_EQ(result.status, 0) << result.said;
        return std::array{output("color"), output("masking")};
    };
    for (int tile = 0; tile < 4; ++tile)
        for (const int color_model : {1, 2, 3}) {
            const int u = tile % 2, v = tile / 2;
            const auto found = drawn("rough.<UDIM>", u, v, color_model);
            const auto alone =
                drawn("rough." + std::to_string(1001 + u + 10 * v), 0, 0, color_model);
            const auto other = drawn("rough.1001", 0, 0, color_model);
            for (size_t image = 0; image < found.size(); ++image)
                for (size_t i = 0; i < found[image].pixels.size(); ++i)
                    ASSERT_NEAR(found[image].pixels[i], alone[image].pixels[i],
                                5e-5F * std::max(1.0F, std::abs(alone[image].pixels[i])))
                        << tile << ' ' << color_model << ' ' << image << ' ' << i;
            EXPECT_EQ(found[0].pixels == other[0].pixels, tile == 0);
        }
}

TEST_F(Osl, ScaleOfTheHeightsScalesSlopesOnceAndCovariancesTwice)
{
    bake_random(temp_);
    compile("src/shaders/scree_raw.osl");
    const SampleSet set = read_set(temp_ / "set");
    const RunResult result =
        shade({"-g", "16", "16", "--param", "folder", "set", "--param", "name", "rough", "--param",
               "height_scale", "0.5", "-o", "visible_covariance", "covariance.exr", "scree_raw"});
    ASSERT_EQ(result.status, 0) << result.said;
    const Image covariance = output("covariance");
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const auto slopes = slopes_of(set, 2, x, y); // seen from straight above: all of them
            EXPECT_NEAR(covariance.at(x, y, 0), 0.25F * slopes.covariance.ss, 1e-5F);
            EXPECT_NEAR(covariance.at(x, y, 2), 0.25F * slopes.covariance.tt, 1e-5F);
        }
}

/// The set on a square under a white sky, seen from 15 degrees above it, 64 texels on 16 pixels;
/// mean radiance.
class Rendered : public Osl {
protected:
    V3f render(const std::string& parameters)
    {
        std::ofstream(temp_ / "scene.xml")
            << "<World>\n"
               "<Camera eye=\"0.5,-9.16,2.59\" look_at=\"0.5,0.5,0\" up=\"0,0,1\" fov=\"1\" />\n"
               "<ShaderGroup>shader sky layer1;</ShaderGroup>\n"
               "<Background resolution=\"32\" />\n"
               "<ShaderGroup>string folder \"set\"; string name \"rough\"; "
            << parameters
            << " shader scree_surface layer1;</ShaderGroup>\n"
               "<Quad corner=\"0,0,0\" edge_x=\"1,0,0\" edge_y=\"0,1,0\" />\n"
               "</World>\n";
        const RunResult result = run(temp_.path(), {tools_.testrender.string(), "-r", "32", "16",
                                                    "-aa", "6", "scene.xml", "picture.exr"});
        EXPECT_EQ(result.status, 0) << result.said;
        EXPECT_EQ(result.said.find("ERROR"), std::string::npos) << result.said;
        const Image picture = read_levels(temp_ / "picture.exr").at(0);
        V3f sum(0);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                for (int i = 0; i < 3; ++i) {
                    EXPECT_TRUE(std::isfinite(picture.at(x, y, i)));
                    sum[i] += picture.at(x, y, i);
                }
        return sum / static_cast<float>(picture.width * picture.height);
    }
};

// Red goes up with height and blue goes down, so at grazing angles red shows more; under a white
// sky a surface without specular has its color.
TEST_F(Rendered, SurfaceShaderShowsHighPartsAtGrazingAngles)
{
    Image height = random_image(64, 64, {"Y"}, 41);
    Image color{64, 64, {"R", "G", "B"}, {}};
    for (float& h : height.pixels) {
        for (const float c : {h, 0.5F, 1 - h})
            color.pixels.push_back(0.3F + 0.4F * (c - 0.5F));
        h *= 5; // slopes of 0.5 deviation
    }
    write_image(temp_ / "h.exr", height);
    write_image(temp_ / "c.exr", color);
    bake_files(temp_);
    compile("src/shaders/scree_surface.osl");
    compile("tests/shaders/sky.osl");

    const V3f mean = render("int color_model 0; float eta 0;");
    const V3f seen = render("int color_model 1; float eta 0;");
    const V3f lit = render("int color_model 1; float eta 0; float light_exponent 5;");
    const V3f coated = render("int color_model 0; float base_alpha 0.1;");
    // 2 %: sampling of 32 x 16 x 36 paths.
    EXPECT_NEAR(mean[1], 0.3F, 0.006F);
    EXPECT_NEAR(seen[1], mean[1], 0.006F) << "green does not go with height";
    EXPECT_GT(seen[0], mean[0] + 0.02F);
    EXPECT_LT(seen[2], mean[2] - 0.02F);
    EXPECT_GT(lit[0], seen[0] + 0.01F) << "what is lit as well lies higher still";
    EXPECT_GT(coated[1], mean[1] + 0.02F) << "the coat reflects the sky";
}

/// Tables of the random set that are the same everywhere: red shows more, blue less, from node
/// straight above to a node at 78 degrees.
VisibleTables tables_of_red_and_blue()
{
    VisibleTables tables = random_visible_tables(64, 64, {0.2F}, 0);
    for (Image& level : tables.levels)
        for (size_t i = 0; i < level.pixels.size(); i += 4) {
            const float abgr[4] = {0.0F, -0.1F, 0.0F, 0.1F};
            std::copy(std::begin(abgr), std::end(abgr),
                      level.pixels.begin() + static_cast<std::ptrdiff_t>(i));
        }
    return tables;
}

// The viewer is 15 degrees above the plane: tan 75 / tan 78.5 of the way to the node.
TEST_F(Rendered, SurfaceShaderShowsWhatVisibilityTablesTellOfViewAndLight)
{
    write_image(temp_ / "h.exr", random_image(64, 64, {"Y"}, 42));
    Image color{64, 64, {"R", "G", "B"}, {}};
    color.pixels.assign(size_t{64} * 64 * 3, 0.3F);
    write_image(temp_ / "c.exr", color);
    bake_files(temp_);
    write_visible_tables(temp_ / "set/rough.visible.exr", tables_of_red_and_blue());
    compile("src/shaders/scree_surface.osl");
    compile("tests/shaders/sky.osl");

    const float shift = 0.1F * std::tan(1.3090F) / std::tan(std::acos(0.2F));
    const V3f seen = render("int color_model 4; float eta 0;");
    const V3f above = render("int color_model 4; float eta 0; vector light 0 0 2;");
    const V3f low = render("int color_model 4; float eta 0; vector light 4 -3 0.5;");
    // The light is beyond the node, so its shift of 0.1 is the larger one; both come from -t, the
    // view over sin 75 of the plane, the light over (4, -3) / |(4, -3, 0.5)|.
    const float overlap = 0.45F + 0.4F * (0.9659F * 3 / 5.0249F);
    const float both = 0.1F + shift - overlap * shift;
    // 2 %: sampling of 32 x 16 x 36 paths.
    for (const V3f& got : {seen, above}) {
        EXPECT_NEAR(got[0], 0.3F + shift, 0.008F);
        EXPECT_NEAR(got[1], 0.3F, 0.006F);
        EXPECT_NEAR(got[2], 0.3F - shift, 0.005F);
    }
    EXPECT_NEAR(low[0], 0.3F + both, 0.008F);
    EXPECT_NEAR(low[2], 0.3F - both, 0.004F);
}

TEST_F(Osl, TheExampleOfTheDocsCompilesAndRuns)
{
    bake_sample_into(temp_ / "set", "fractal", 64, 64, MapBy::height); // every map there is
    write_visible_tables(temp_ / "set/test.visible.exr",
                         random_visible_tables(64, 64, {0.7F, 0.3F}, 1));
    write_exponent_levels(temp_ / "set/test.exponent.exr", exponent_levels(64, 64));
    std::ofstream(temp_ / "my_surface.osl") << doc_example("c");
    const RunResult compiled =
        run(temp_.path(), {tools_.oslc.string(), "-I" SCREE_SOURCE "/src",
                           "-I" SCREE_SOURCE "/src/shaders", "my_surface.osl"});
    ASSERT_EQ(compiled.status, 0) << compiled.said;
    for (const char* color_model : {"0", "1", "2", "3", "4", "5"}) {
        const RunResult result =
            shade({"-g", "2", "2", "--param", "folder", "set", "--param", "name", "test", "--param",
                   "color_model", color_model, "-o", "Ci", "null", "my_surface"});
        EXPECT_EQ(result.status, 0) << result.said;
    }
}

TEST_F(Osl, AMissingSetIsNamed)
{
    compile("src/shaders/scree_surface.osl");
    const RunResult result = shade({"-g", "1", "1", "--param", "folder", "nowhere", "--param",
                                    "name", "rough", "-o", "Ci", "null", "scree_surface"});
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.said.find("nowhere/rough.slope.exr"), std::string::npos) << result.said;
}

} // namespace
} // namespace scree::test
