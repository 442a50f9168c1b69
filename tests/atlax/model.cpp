// Models: what is read, what is refused, and how they are drawn.
#include <gtest/gtest.h>

#include <array>
#include <atlax/error.hpp>
#include <atlax/model.hpp>
#include <atlax/offscreen.hpp>
#include <cmath>
#include <fstream>
#include <string>

#include "temporary_folder.hpp"

namespace {

using namespace atlax;

/// A square of side 2 at z = 0 that looks towards the viewer.
const std::string square =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n";

Model fromText(const std::string& text, const std::string& name = "test.obj") {
    return decodeModel(std::as_bytes(std::span(text)), name);
}

std::string refusal(const std::string& text, const std::string& name = "test.obj") {
    try {
        fromText(text, name);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::string refusedFile(const std::filesystem::path& file) {
    try {
        loadModel(file);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Model, objIsReadWithItsNormalsAndBounds) {
    const Model model = fromText(square);
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].indices.size(), 6u);
    EXPECT_EQ(model.parts[0].vertices.size(), 4u);
    EXPECT_EQ(model.parts[0].vertices[0].normal, (std::array<float, 3>{0, 0, 1}));
    EXPECT_EQ(model.min, (std::array<float, 3>{-1, -1, 0}));
    EXPECT_EQ(model.max, (std::array<float, 3>{1, 1, 0}));
}

/// A triangle in a glTF whose numbers are in it, moved up by its node.
const std::string triangleGltf = R"({
 "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0, "translation": [0, 5, 0]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
 "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
})";

TEST(Model, gltfIsReadWithItsTransformsAndColours) {
    const Model model = fromText(triangleGltf, "test.gltf");
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].indices.size(), 3u);
    EXPECT_FLOAT_EQ(model.min[1], 5);
    EXPECT_FLOAT_EQ(model.max[1], 6);
    EXPECT_FLOAT_EQ(model.parts[0].color.g, 0.5f);
}

TEST(Model, materialsAndPicturesComeFromItsFolder) {
    const TemporaryFolder folder;
    Image red({2, 2});
    for (int i = 0; i < 4; ++i) red.setPixel(i % 2, i / 2, {255, 0, 0, 255});
    savePng(red, folder / "red.png");
    write(folder / "m.mtl", "newmtl paint\nKd 0.5 1 1\nmap_Kd red.png\n");
    write(folder / "m.obj", "mtllib m.mtl\nusemtl paint\n" + square);
    const Model model = loadModel(folder / "m.obj");
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].picture.size(), (PixelSize{2, 2}));
    EXPECT_FLOAT_EQ(model.parts[0].color.r, 0.5f);
}

TEST(Model, filesOutsideOfItsFolderAreNotRead) {
    const TemporaryFolder folder;
    savePng(Image({2, 2}), folder / "outside.png");
    std::filesystem::create_directory(folder / "in");
    std::filesystem::create_symlink("../outside.png", folder / "in" / "link.png");
    for (const std::string name : {"../outside.png", "link.png", "missing.png"}) {
        write(folder / "in" / "m.mtl", "newmtl paint\nmap_Kd " + name + "\n");
        write(folder / "in" / "m.obj", "mtllib m.mtl\nusemtl paint\n" + square);
        EXPECT_NE(refusedFile(folder / "in" / "m.obj").find("not in its folder"), std::string::npos)
            << name;
    }
}

TEST(Model, whatIsNoModelIsRefusedWithAReason) {
    EXPECT_NE(refusal(square, "test.fbx").find("allowed are"), std::string::npos);
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
    EXPECT_NE(refusal("v 0 0 0\n").find("test.obj"), std::string::npos);
    EXPECT_NE(refusal("{", "test.gltf").find("cannot be read"), std::string::npos);
    EXPECT_NE(refusal("glTF nonsense", "test.glb").find("cannot be read"), std::string::npos);
    EXPECT_NE(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").find("test.obj"), std::string::npos);
    EXPECT_NE(refusal("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("test.obj"),
              std::string::npos);
    // Sound as STL, which its name hides.
    EXPECT_NE(refusal("solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                      "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n")
                  .find("test.obj"),
              std::string::npos);
    EXPECT_THROW(loadModel("/no/such/model.obj"), Error);
}

TEST(Model, gltfThatWouldHarmTheReaderIsRefusedBeforeIt) {
    std::string wrongLetter = triangleGltf;
    wrongLetter[wrongLetter.find(";base64,") + 12] = '-';
    EXPECT_NE(refusal(wrongLetter, "test.gltf").find("base64"), std::string::npos);
    const std::string deep = R"({"asset":{"version":"2.0"},"extras":)" + std::string(200'000, '[');
    EXPECT_NE(refusal(deep, "test.gltf").find("nested"), std::string::npos);
    const std::string lying("glTF\2\0\0\0\x40\0\0\0\xff\xff\xff\x7fJSON{}", 22);
    EXPECT_NE(refusal(lying, "test.glb").find("cut off"), std::string::npos);
}

TEST(Model, everyCutOffFileIsRefusedOrReadWhole) {
    for (std::size_t n = 0; n < triangleGltf.size(); n += 7) {
        SCOPED_TRACE(n);
        EXPECT_NE(refusal(triangleGltf.substr(0, n), "test.gltf"), "");
    }
}

Image drawnModels(std::span<const Model> models, std::span<const ModelInstance> places,
                  const ModelView& view = {}) {
    OffscreenCanvas offscreen({64, 64});
    Canvas& c = offscreen.begin();
    std::vector<ModelInstance> instances(places.begin(), places.end());
    for (std::size_t i = 0; i < models.size(); ++i) instances[i].model = c.createModel(models[i]);
    c.setCamera({.centre = {0, 0}, .pixelsPerMetre = 10});
    c.models(instances, view);
    offscreen.finish();
    return offscreen.image();
}

const ModelView flat{.light = colors::black, .ambient = colors::white};

TEST(CanvasModels, standWhereTheyShouldAndUpright) {
    const std::array models{fromText(triangleGltf, "test.gltf")};
    // Its corners are (0,5), (1,5) and (0,6), times 2, from 2 down.
    const std::array places{ModelInstance{.position = {0, -10}, .size = 2}};
    const Image image = drawnModels(models, places, flat);
    EXPECT_EQ(image.pixel(35, 29), (std::array<std::uint8_t, 4>{255, 128, 0, 255}));
    EXPECT_EQ(image.pixel(50, 14)[3], 0);
    EXPECT_EQ(image.pixel(35, 35)[3], 0);
    EXPECT_EQ(image.pixel(34, 16)[3], 255);
}

TEST(CanvasModels, whatIsNearerCoversInAnyOrder) {
    const std::array models{fromText(square), fromText(square)};
    for (const float depth : {1.0f, -1.0f}) {
        const std::array places{ModelInstance{.depth = depth, .tint = {1, 0, 0, 1}},
                                ModelInstance{.tint = {0, 0, 1, 1}}};
        const Image image = drawnModels(models, places, flat);
        EXPECT_EQ(image.pixel(32, 32)[depth > 0 ? 0 : 2], 255) << depth;
        EXPECT_EQ(image.pixel(32, 32)[depth > 0 ? 2 : 0], 0) << depth;
    }
}

TEST(CanvasModels, planesThatCrossCoverEachOtherHalf) {
    const std::array models{fromText(square), fromText(square)};
    const std::array places{ModelInstance{.turn = {0, 0.8f, 0}, .tint = {1, 0, 0, 1}},
                            ModelInstance{.turn = {0, -0.8f, 0}, .tint = {0, 0, 1, 1}}};
    for (const float eye : {0.0f, 6.0f}) {
        const Image image = drawnModels(
            models, places, {.light = colors::black, .ambient = colors::white, .eye = eye});
        // Turned about y, the left of the first comes forward.
        EXPECT_EQ(image.pixel(28, 32), (std::array<std::uint8_t, 4>{255, 0, 0, 255})) << eye;
        EXPECT_EQ(image.pixel(36, 32), (std::array<std::uint8_t, 4>{0, 0, 255, 255})) << eye;
    }
}

TEST(CanvasModels, lightFollowsTheCosine) {
    const std::array models{fromText(square)};
    for (const float angle : {0.0f, 0.5f, 1.0f}) {
        const std::array places{ModelInstance{.turn = {0, angle, 0}}};
        const Image image = drawnModels(
            models, places,
            {.towardsLight = {0, 0, 2}, .light = colors::white, .ambient = colors::black});
        EXPECT_NEAR(image.pixel(32, 32)[0], 255 * std::cos(angle), 1.5) << angle;
    }
}

TEST(CanvasModels, perspectiveMakesNearThingsLarger) {
    const std::array models{fromText(square)};
    const auto width = [&](float depth) {
        const std::array places{ModelInstance{.depth = depth}};
        const Image image = drawnModels(models, places, {.ambient = colors::white, .eye = 4});
        int count = 0;
        for (int x = 0; x < 64; ++x) count += image.pixel(x, 32)[3] > 127;
        return count;
    };
    EXPECT_NEAR(width(0), 20, 1);
    EXPECT_NEAR(width(2), 40, 1);
    EXPECT_NEAR(width(-4), 10, 1);
    EXPECT_EQ(width(9), 0) << "behind the viewer";
}

TEST(CanvasModels, flatThingsGoOnAfterwardsAndNonsenseDrawsNothing) {
    OffscreenCanvas offscreen({64, 64});
    Canvas& c = offscreen.begin();
    const ModelMesh mesh = c.createModel(fromText(square));
    const std::array nonsense{ModelInstance{.position = {32, 32}},
                              ModelInstance{.model = mesh, .position = {std::nanf(""), 0}},
                              ModelInstance{.model = mesh, .size = -1}};
    c.models(nonsense);
    c.models({});
    c.pushClip({{0, 0}, {32, 64}});
    const std::array one{ModelInstance{.model = mesh, .position = {32, 32}, .size = 10}};
    c.models(one, flat);
    c.popClip();
    c.circle({50, 50}, 5, colors::white);
    offscreen.finish();
    const Image image = offscreen.image();
    EXPECT_EQ(image.pixel(28, 32)[3], 255);
    EXPECT_EQ(image.pixel(36, 32)[3], 0) << "clipped";
    EXPECT_EQ(image.pixel(50, 50)[3], 255);
    EXPECT_EQ(image.pixel(5, 5)[3], 0);
}

}  // namespace
