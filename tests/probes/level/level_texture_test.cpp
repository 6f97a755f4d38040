// SPDX-License-Identifier: Apache-2.0
// Textures of glTF files, seen by rays: positions of texels, repetition, masks, and sources of images.
#include <webp/encode.h>

#include "level_text.h"
#include "sh/deterministic.h"
#include "sky/image/image.h"
#include "tests/dds_bytes.h"

namespace welkin::tests {
namespace {
using nlohmann::json;

constexpr double kTolerance = 1e-5;  // the hit's floats, times the texels' steps

/// 4 x 2 texels, all different, no two channels alike.
constexpr std::uint8_t kTexels[2][4][3] = {{{250, 10, 40}, {200, 20, 80}, {150, 30, 120}, {100, 40, 160}},
                                           {{90, 60, 10}, {70, 120, 30}, {50, 180, 50}, {30, 240, 70}}};

Number3 texel(int column, int row) {
  const auto& t = kTexels[row][column];
  return {det::srgbDecode(t[0] / 255.0), det::srgbDecode(t[1] / 255.0), det::srgbDecode(t[2] / 255.0)};
}

std::string png() {
  return textOf(image::encodePng(4, 2, std::span<const std::uint8_t>(&kTexels[0][0][0], sizeof(kTexels))));
}

/// The same texels with an alpha of 200.
std::string dds() {
  std::string bytes = ddsOf(ddsBgra(4, 2), {});
  for (const auto& row : kTexels)
    for (const auto& t : row)
      for (const int code : {int{t[2]}, int{t[1]}, int{t[0]}, 200}) bytes.push_back(static_cast<char>(code));
  return bytes;
}

/// A textured square; `change` edits its JSON.
GltfText squareWith(const std::function<void(json&)>& change = nullptr) {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(texturedSquareMesh(), gltf.addMaterial({1, 1, 1})));
  gltf.addTexture(0, "a.png");
  if (change) change(gltf.json);
  return gltf;
}

/// Albedo where the square's own coordinates are (u, v).
Number3 albedoAt(const geometry::Tracer& tracer, double u, double v) {
  const auto hit = below(tracer, 2 * u - 1, 2 * v - 1);
  REQUIRE(hit);
  return tracer.albedo(*hit);
}

void checkTexels(const geometry::Surfaces& s) {
  const geometry::Tracer tracer(s);
  for (const int row : {0, 1})
    for (const int column : {0, 1, 2, 3})
      checkNear(albedoAt(tracer, (column + 0.5) / 4, (row + 0.5) / 2), texel(column, row), kTolerance);
}

}  // namespace

TEST_CASE("LevelTexture, EveryTexelLiesWhereGltfPutsIt") {
  const geometry::Surfaces s = surfacesOf({{"a.gltf", squareWith().text()}, {"a.png", png()}});
  checkTexels(s);
  const geometry::Tracer tracer(s);
  checkNear(albedoAt(tracer, 0.25, 0.25), (texel(0, 0) + texel(1, 0)) * 0.5, kTolerance);
  checkNear(albedoAt(tracer, 0.625, 0.5), (texel(2, 0) + texel(2, 1)) * 0.5, kTolerance);
  REQUIRE(s.file.size() == 2);
  CHECK(s.file[1].filename() == "a.png");
}

TEST_CASE("LevelTexture, SamplersRepeatMirrorAndClamp") {
  GltfText gltf = squareWith([](json& j) {
    j["textures"][0]["sampler"] = 0;
    j["samplers"] = {{{"wrapS", 33648}, {"wrapT", 33071}}};
    j["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"offset", {1, 1}}};
  });
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"a.png", png()}});
  const geometry::Tracer tracer(s);
  checkNear(albedoAt(tracer, 0.375, 0.125), texel(2, 1), kTolerance);  // u = 1.375 mirrors to 0.625
  gltf.json["samplers"][0] = {{"wrapT", 33648}};
  const geometry::Surfaces other = surfacesOf({{"a.gltf", gltf.text()}, {"a.png", png()}});
  const geometry::Tracer other_tracer(other);
  checkNear(albedoAt(other_tracer, 0.375, 0.25), texel(1, 1), kTolerance);  // v = 1.25 mirrors to 0.75
  gltf.json["samplers"][0]["wrapS"] = 1;
  checkSurfacesRefused({{"a.gltf", gltf.text()}, {"a.png", png()}}, {"sampler 0", "wrapS = 1"});
}

// The extension's own example: the lower left quarter of the image, turned clockwise.
TEST_CASE("LevelTexture, TheTransformScalesTurnsAndMoves") {
  const GltfText gltf = squareWith([](json& j) {
    j["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"offset", {0, 1}}, {"rotation", f64::kPi / 2}, {"scale", {0.5, 0.25}}};
    j["extensionsRequired"] = {"KHR_texture_transform"};
  });
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"a.png", png()}});
  const geometry::Tracer tracer(s);
  checkNear(albedoAt(tracer, 0.5, 0.5), texel(0, 1), kTolerance);  // (0.125, 0.75)
  checkNear(albedoAt(tracer, 0.5, 1.0 - 1e-7), (texel(0, 1) + texel(1, 1)) * 0.5, kTolerance);
  checkNear(albedoAt(tracer, 0.75, 0.5), texel(0, 1) * 0.75 + texel(0, 0) * 0.25, kTolerance);
}

TEST_CASE("LevelTexture, TheTransformMayNameOtherCoordinates") {
  GltfText gltf = squareWith([](json& j) {
    auto& attributes = j["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_2"] = attributes["TEXCOORD_0"];
    attributes.erase("TEXCOORD_0");
    j["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"texCoord", 2}};
  });
  checkTexels(surfacesOf({{"a.gltf", gltf.text()}, {"a.png", png()}}));
  gltf.json["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_2");
  const auto factor = surfacesOf({{"a.gltf", gltf.text()}, {"a.png", png()}});
  REQUIRE(factor.warning.size() == 1);
  CHECK_THAT(factor.warning[0], Catch::Contains("mesh 0") && Catch::Contains("has no TEXCOORD_2"));
}

TEST_CASE("LevelTexture, ImagesComeFromFilesDataBuffersAndBinaryFiles") {
  const std::string image = png();
  const std::vector<unsigned char> bytes(image.begin(), image.end());
  checkTexels(surfacesOf({{"a.gltf", squareWith([&](json& j) {
                                       j["images"][0]["uri"] = "data:image/png;base64," + base64(bytes);
                                     }).text()}}));
  checkTexels(surfacesOf(
      {{"a.gltf", squareWith([](json& j) { j["images"][0]["uri"] = "a%20b.png"; }).text()}, {"a b.png", image}}));
  GltfText embedded;
  embedded.addNode(embedded.addMesh(texturedSquareMesh(), embedded.addMaterial({1, 1, 1})));
  embedded.addTexture(0, bytes);
  checkTexels(surfacesOf({{"a.gltf", embedded.text()}}));
  checkTexels(surfacesOf({{"a.glb", embedded.binary()}}));
  embedded.json["bufferViews"].back()["byteLength"] = 100000;
  checkSurfacesRefused({{"a.glb", embedded.binary()}}, {"a.glb", "image 0", "100000 bytes"});
}

TEST_CASE("LevelTexture, WebpIsPreferredAndKeepsItsColoursUnderAlpha") {
  std::vector<std::uint8_t> rgba;
  for (const auto& row : kTexels)
    for (const auto& t : row) rgba.insert(rgba.end(), {t[0], t[1], t[2], 200});
  std::uint8_t* webp = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), 4, 2, 16, &webp);
  const std::string image(reinterpret_cast<const char*>(webp), size);
  WebPFree(webp);
  const GltfText gltf = squareWith([](json& j) {
    j["images"].push_back({{"uri", "a.webp"}});
    j["textures"][0]["extensions"]["EXT_texture_webp"] = {{"source", 1}};
    j["extensionsRequired"] = {"EXT_texture_webp"};
  });
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"a.webp", image}});
  REQUIRE(s.texture.size() == 1);
  CHECK(s.texture[0].rgba == rgba);
  checkTexels(s);
  checkSurfacesRefused({{"a.gltf", gltf.text()}, {"a.webp", image.substr(0, size - 8)}}, {"a.webp", "damaged or cut"});
}

TEST_CASE("LevelTexture, DdsIsPreferredToThePlainSource") {
  GltfText gltf = squareWith([](json& j) {
    j["images"].push_back({{"uri", "a.dds"}});
    j["textures"][0]["extensions"]["MSFT_texture_dds"] = {{"source", 1}};
    j["extensionsRequired"] = {"MSFT_texture_dds"};
  });
  const std::string white = textOf(image::encodePng(1, 1, std::vector<std::uint8_t>{255, 255, 255}));
  const auto read = [&](const std::string& dds_bytes) {
    return surfacesOf({{"a.gltf", gltf.text()}, {"a.png", white}, {"a.dds", dds_bytes}});
  };
  const geometry::Surfaces s = read(dds());
  CHECK(s.warning.empty());
  checkTexels(s);
  REQUIRE(s.texture.size() == 1);
  CHECK(s.texture[0].rgba[3] == 200);
  // Pixels that are not read leave the next image, and without one the factor, with a warning.
  const std::string normals = ddsOf(ddsBlocks(4, 4, "ATI2"), {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(read(normals).texture.at(0).width == 1);
  checkSurfacesRefused({{"a.gltf", gltf.text()}, {"a.png", white}, {"a.dds", dds().substr(0, 150)}},
                       {"a.dds: damaged or cut: its texels take 32 bytes; the file ends 22 bytes on"});
  checkSurfacesRefused({{"a.gltf", gltf.text()}, {"a.png", white}, {"a.dds", "a text"}}, {"a.dds", "not a texture"});
  gltf.json["textures"][0].erase("source");
  checkTexels(read(dds()));
  const geometry::Surfaces factor = read(normals);
  CHECK(factor.texture.empty());
  REQUIRE(factor.warning.size() == 1);
  CHECK_THAT(factor.warning[0], Catch::Contains("texture 0 is in a format that is not read") &&
                                    Catch::Contains("a.dds") && Catch::Contains("the factor"));
  gltf.json["textures"][0] = {{"source", 1}};  // as exporters without the extension name it
  checkTexels(read(dds()));
}

TEST_CASE("LevelTexture, MasksLetRaysThrough") {
  // 2 x 1 texels: the left one is there, the right one is not. Their bilinear mean crosses the cut-off in between.
  const std::string image = targa(2, 1, {255, 255, 255, 255, 255, 255, 255, 0});
  GltfText gltf = squareWith([](json& j) {
    j["images"][0]["uri"] = "leaf.tga";
    j["textures"][0]["sampler"] = 0;
    j["samplers"] = {{{"wrapS", 33071}}};
    j["materials"][0]["alphaMode"] = "MASK";
    j["materials"][0]["alphaCutoff"] = 0.75;
  });
  gltf.addNode(gltf.addMesh(squareMesh()), {{"translation", {0, -1, 0}}});
  const auto heightAt = [&](double u) {
    const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"leaf.tga", image}});
    const geometry::Tracer tracer(s);
    return below(tracer, 2 * u - 1, 0.1)->position.y;
  };
  CHECK(heightAt(0.1) == 0.0);
  CHECK(heightAt(0.37) == 0.0);  // alpha 1 - 2 (u - 0.25) = 0.76
  CHECK(heightAt(0.38) == -1.0);
  CHECK(heightAt(0.9) == -1.0);
  gltf.json["materials"][0]["alphaMode"] = "OPAQUE";
  CHECK(heightAt(0.9) == 0.0);
  gltf.json["materials"][0]["alphaMode"] = "BLEND";
  CHECK(heightAt(0.49) == 0.0);
  CHECK(heightAt(0.51) == -1.0);
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"leaf.tga", image}});
  const geometry::Tracer tracer(s);
  for (const double u : {0.3, 0.7}) {  // light passes texel by texel
    const auto hit = tracer.closest({2 * u - 1, 10.0, 0.1}, {0, -1, 0}, 100.0, geometry::Meets::light);
    REQUIRE(hit);
    checkNear(tracer.passing(*hit), Number3(2 * (u - 0.25)), 1e-6);
  }
}

TEST_CASE("LevelTexture, EmissionFollowsTheTexelsOfItsTexture") {
  GltfText gltf = squareWith([](json& j) {
    j["materials"][0]["emissiveFactor"] = {1, 0.5, 0};
    j["materials"][0]["emissiveTexture"] = {{"index", 0}};
    j["materials"][0]["emissiveTexture"]["extensions"]["KHR_texture_transform"] = {{"offset", {0.25, 0}}};
  });
  const auto emissionAt = [&](double u, double v) {
    const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"a.png", png()}});
    CHECK(s.warning.empty());
    const geometry::Tracer tracer(s);
    return tracer.emission(*below(tracer, 2 * u - 1, 2 * v - 1));
  };
  const auto expected = [](const Number3& t) { return t * Number3(1, 0.5, 0); };
  checkNear(emissionAt(0.375, 0.25), expected(texel(2, 0)), kTolerance);  // u = 0.375 + 0.25
  checkNear(emissionAt(0.125, 0.75), expected(texel(1, 1)), kTolerance);
  gltf.json["materials"][0]["pbrMetallicRoughness"].erase("baseColorTexture");  // the coordinates are its own
  checkNear(emissionAt(0.125, 0.75), expected(texel(1, 1)), kTolerance);
}

TEST_CASE("LevelTexture, EmissionWithCoordinatesOfItsOwnTakesTheMean") {
  const GltfText gltf = squareWith([](json& j) {
    j["materials"][0]["emissiveFactor"] = {1, 0.5, 0};
    j["materials"][0]["emissiveTexture"] = {{"index", 0}, {"texCoord", 1}};
  });
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"a.png", png()}});
  Number3 mean(0.0);
  for (const int row : {0, 1})
    for (const int column : {0, 1, 2, 3}) mean += texel(column, row) * 0.125;
  checkNear(s.material[0].emission, {mean.x, mean.y * 0.5, 0.0}, 1e-12);
  REQUIRE(s.warning.size() == 1);
  CHECK_THAT(s.warning[0], Catch::Contains("a.gltf") && Catch::Contains("TEXCOORD_1"));
}

TEST_CASE("LevelTexture, TransmissionTakesTheMeanOfItsTexturesRed") {
  const std::string image = targa(2, 1, {51, 255, 255, 255, 153, 0, 0, 255});
  GltfText gltf;
  gltf.addNode(gltf.addMesh(texturedSquareMesh(), gltf.addMaterial({1, 1, 1})));
  gltf.json["images"] = {{{"uri", "glass.tga"}}};
  gltf.json["textures"] = {{{"source", 0}}};
  gltf.json["materials"][0]["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.5},
                                                                           {"transmissionTexture", {{"index", 0}}}};
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}, {"glass.tga", image}});
  CHECK(s.material[0].transmission == Approx(0.5 * 0.4));
  REQUIRE(s.warning.size() == 1);
  CHECK_THAT(s.warning[0], Catch::Contains("transmissionTexture"));
  gltf.json["materials"][0]["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 1.5;
  checkSurfacesRefused({{"a.gltf", gltf.text()}, {"glass.tga", image}}, {"materials[0]", "transmissionFactor = 1.5"});
}

TEST_CASE("LevelTexture, RoughnessAndMetalAreFactorsTimesTheirMeans") {
  const auto materialOf = [](const std::function<void(json&)>& change) {
    const Folder folder;
    folder.write("a.png", png());
    level::LevelFile level;
    level.geometry.push_back({folder.write("a.gltf", squareWith(change).text()), {}, geometry::Role::fixed, {}});
    level::Scene scene = loader::readScene(level);
    CHECK(scene.warnings.empty());
    loader::useMeanColours(scene);
    return scene.materials[scene.draws[0].material];
  };
  const auto metalOf = [](json& j) -> json& { return j["materials"][0]["pbrMetallicRoughness"]; };
  const level::SceneMaterial plain = materialOf(nullptr);  // glTF's defaults
  CHECK(plain.metallic == 1.0);
  CHECK(plain.roughness == 1.0);
  const level::SceneMaterial factors = materialOf([&](json& j) {
    metalOf(j)["metallicFactor"] = 0.25;
    metalOf(j)["roughnessFactor"] = 0.5;
  });
  CHECK(factors.metallic == 0.25);
  CHECK(factors.roughness == 0.5);
  double green = 0.0, blue = 0.0;
  for (const auto& row : kTexels)
    for (const auto& t : row) {
      green += t[1] / (8 * 255.0);
      blue += t[2] / (8 * 255.0);
    }
  const auto textured = [&](json& j) {
    metalOf(j)["metallicRoughnessTexture"] = {{"index", 0}};
    metalOf(j)["metallicFactor"] = 0.8;
    metalOf(j)["roughnessFactor"] = 0.5;
  };
  const level::SceneMaterial mean = materialOf(textured);
  CHECK(mean.roughness == Approx(0.5 * green).epsilon(1e-12));
  CHECK(mean.metallic == Approx(0.8 * blue).epsilon(1e-12));
  // A texture that is not read leaves no metal: its factors alone would speak of one.
  const level::SceneMaterial unread = materialOf([&](json& j) {
    textured(j);
    j["textures"].push_back({{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
    metalOf(j)["metallicRoughnessTexture"]["index"] = 1;
  });
  CHECK(unread.metallic == 0.0);
  CHECK(unread.roughness == 0.5);
}

TEST_CASE("LevelTexture, MessagesNameTheFileAndThePart") {
  const auto refuse = [](const std::function<void(json&)>& change, const std::vector<std::string>& says,
                         base::ExitStatus status = base::ExitStatus::content, const std::string& image = png()) {
    checkSurfacesRefused({{"a.gltf", squareWith(change).text()}, {"a.png", image}}, says, status);
  };
  refuse([](json& j) { j["images"][0]["uri"] = "none.png"; }, {"a.gltf", "material 0", "none.png", "missing"},
         base::ExitStatus::file);
  refuse([](json& j) { j["textures"][0]["source"] = 4; }, {"a.gltf", "texture 0", "source 4"});
  refuse([](json& j) { j["textures"][0]["sampler"] = 2; }, {"a.gltf", "sampler 2"});
  refuse([](json& j) { j["materials"][0]["alphaMode"] = "GLASS"; }, {"material 0", "GLASS"});
  refuse(
      [](json& j) {
        j["materials"][0]["alphaCutoff"] = -1;
        j["materials"][0]["alphaMode"] = "MASK";
      },
      {"material 0", "alphaCutoff"});
  refuse([](json& j) { j["materials"][0]["emissiveFactor"] = {2, 0, 0}; }, {"material 0", "emissiveFactor"});
  const auto transform = [](const json& value) {
    return [value](json& j) {
      j["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = value;
    };
  };
  refuse(transform({{"scale", {1}}}), {"materials[0]", "scale = [1]: must be an array of 2 numbers"});
  refuse(transform({{"rotation", "left"}}), {"materials[0]", "rotation = \"left\""});
  refuse(transform({{"texCoord", 0.5}}), {"materials[0]", "texCoord = 0.5"});
  refuse([](json&) {}, {"a.png", "not a texture"}, base::ExitStatus::content, "P6 1 1 255 abc");
  for (const std::size_t size : {20U, 40U, 60U})
    refuse([](json&) {}, {"a.png", "damaged or cut"}, base::ExitStatus::content, png().substr(0, size));
}

}  // namespace welkin::tests
