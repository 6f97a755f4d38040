// SPDX-License-Identifier: Apache-2.0
// OBJ and MTL: polygons, objects, colours and images; missing parts, and errors with their place.
#include <array>
#include <cmath>

#include "level_text.h"
#include "probes/obj/polygon.h"
#include "sh/deterministic.h"
#include "sky/image/image.h"
#include "tests/dds_bytes.h"

namespace welkin::tests {
namespace {

/// A square in the plane y = 0 that faces up, with texture coordinates from the bottom: (0, 0) at x = -1, z = 1.
constexpr const char* kSquare =
    "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl paint\nf 1/1 2/2 3/3 4/4\n";

bool warns(const geometry::Surfaces& s, const std::string& of) {
  return std::any_of(s.warning.begin(), s.warning.end(),
                     [&](const std::string& w) { return w.find(of) != std::string::npos; });
}

double area(const geometry::Surfaces& s) {
  double sum = 0.0;
  for (const geometry::Triangle& t : s.triangle) {
    const auto at = [&](std::size_t c) {
      const auto& p = s.position[t.vertex[c]];
      return Number3(double{p[0]}, double{p[1]}, double{p[2]});
    };
    const Number3 twice = cross(at(1) - at(0), at(2) - at(0));
    CHECK(twice.y > 0.0);
    sum += 0.5 * twice.y;
  }
  return sum;
}

}  // namespace

TEST_CASE("Obj, ObjectsAndMaterialsDivideTheFaces") {
  const std::string text =
      "# a comment\nmtllib a.mtl\no ground\n" + std::string(kSquare) +
      "o palm 1\nusemtl leaf\nf -4//  -3 \\\n -2\nusemtl paint\nf 1 2 4\no ground\nf 2 3 4\ng hull\nf 1 2 3\n";
  const Folder folder;
  level::LevelFile level = levelOf(
      folder, {{"a.obj", text}, {"a.mtl", "newmtl paint\nKd 0.1 0.2 0.3\nKe 4 0 0\nillum 2\nnewmtl leaf\nKd 0.25\n"}});
  level.geometry[0].vegetation_nodes = {"palm*"};
  level.geometry[0].transform = geometry::fromEuler({10, 0, 0}, Number3(0.0), Number3(0.125));
  const geometry::Surfaces s = loader::surfacesOf(loader::readScene(level), 1.0);
  CHECK(s.triangle.size() == 6);
  REQUIRE(s.object.size() == 3);
  CHECK(s.object[0].name == "ground");
  CHECK(s.object[1].name == "palm 1");
  CHECK(s.object[1].role == geometry::Role::vegetation);
  CHECK(s.object[2].role == geometry::Role::fixed);
  level.geometry[0].ignore_nodes = {"hul?", "h*l"};
  const geometry::Surfaces without = loader::surfacesOf(loader::readScene(level), 1.0);
  CHECK(without.object.size() == 2);
  CHECK(without.triangle.size() == s.triangle.size() - 1);
  CHECK(warns(without, "ignore_nodes: \"hul?\" fits no node or object"));
  CHECK(s.file.size() == 2);
  CHECK(s.warning.empty());
  const geometry::Tracer tracer(s);
  const auto hit = below(tracer, 10.1, 0.05);  // the square is 0.25 m wide at x = 10
  REQUIRE(hit);
  CHECK_FALSE(hit->back);
  for (const geometry::Triangle& t : s.triangle) {
    const geometry::Material& m = s.material[t.material];
    const bool leaf = m.emission.x == 0.0;
    checkNear(m.albedo, leaf ? Number3(0.25) : Number3(0.1, 0.2, 0.3), 0);
    if (leaf) CHECK(s.object[t.object].name == "palm 1");
  }
}

TEST_CASE("Obj, PolygonsOfAnyShapeAreCoveredOnce") {
  // A comb with three teeth, counter-clockwise from above. No fan covers it, and its first corner is a notch.
  const geometry::Surfaces s =
      surfacesOf({{"a.obj",
                   "v 1 0 -1\nv 1 0 -3\nv 0 0 -3\nv 0 0 0\nv 5 0 0\nv 5 0 -3\nv 4 0 -3\nv 4 0 -1\n"
                   "v 3 0 -1\nv 3 0 -3\nv 2 0 -3\nv 2 0 -1\nf 1 2 3 4 5 6 7 8 9 10 11 12\n"}});
  CHECK(s.triangle.size() == 10);
  CHECK(area(s) == Approx(11.0));
  const geometry::Tracer tracer(s);
  CHECK(below(tracer, 0.6, -2.1));
  CHECK_FALSE(below(tracer, 1.6, -2.1));
  CHECK(below(tracer, 2.6, -2.1));
  CHECK_FALSE(below(tracer, 3.6, -2.1));
  CHECK(below(tracer, 3.6, -0.6));
  // An arrow-head, where one of the two diagonals lies outside.
  const geometry::Surfaces arrow = surfacesOf({{"a.obj", "v 0 0 0\nv 2 0 2\nv 0 0 -2\nv -2 0 2\nf 1 2 3 4\n"}});
  CHECK(area(arrow) == Approx(4.0));
}

TEST_CASE("Obj, LargePolygonsAreCoveredOnce") {
  // A ribbon between two circles that are open at one place: half of its corners turn inwards.
  constexpr std::size_t kCorners = 8192;
  constexpr std::size_t kHalf = kCorners / 2;
  std::vector<Number3> ring(kCorners, Number3(0.0));
  for (std::size_t i = 0; i < kHalf; ++i) {
    const double angle = 6.0 * static_cast<double>(i) / kHalf;
    ring[i] = {2.0 * std::cos(angle), 0.0, -2.0 * std::sin(angle)};
    ring[kCorners - 1 - i] = {1.5 * std::cos(angle), 0.0, -1.5 * std::sin(angle)};
  }
  const auto triangles = obj::trianglesOf(ring);
  REQUIRE(triangles.size() == kCorners - 2);
  double sum = 0.0;
  for (const auto& t : triangles) {
    const double twice = cross(ring[t[1]] - ring[t[0]], ring[t[2]] - ring[t[0]]).y;
    REQUIRE(twice > 0.0);
    sum += 0.5 * twice;
  }
  const double step = 6.0 / kHalf;
  const double sectors = 0.5 * (4.0 - 2.25) * std::sin(step) * (kHalf - 1);  // of the chords
  CHECK(sum == Approx(sectors).epsilon(1e-12));
}

TEST_CASE("Obj, HolesJoinedToTheOutlineStayOpen") {
  // A square of 3 x 3 with a hole of 1 x 1: an edge that is passed twice joins both.
  const geometry::Surfaces s = surfacesOf(
      {{"a.obj", "v 0 0 0\nv 0 0 3\nv 3 0 3\nv 3 0 0\nv 1 0 1\nv 2 0 1\nv 2 0 2\nv 1 0 2\nf 1 2 3 4 1 5 6 7 8 5\n"}});
  CHECK(area(s) == Approx(8.0));
  CHECK_FALSE(below(geometry::Tracer(s), 1.4, 1.7));
}

TEST_CASE("Obj, FilesAreReadAsExportersWriteThem") {
  const std::string mark = "\xef\xbb\xbf";
  const std::string mtl = "newmtl paint\nKd 0.1 0.2 0.3\n";
  const auto albedo = [](const std::string& obj, const std::string& library, bool warned = false) {
    INFO(obj << library);
    const geometry::Surfaces s = surfacesOf({{"a.obj", obj}, {"a.mtl", library}, {"my lib.mtl", "newmtl other\n"}});
    CHECK(s.warning.empty() != warned);
    checkNear(geometry::Tracer(s).albedo(*below(geometry::Tracer(s), 0.2, 0.3)), {0.1, 0.2, 0.3}, 1e-12);
  };
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  };
  const std::string obj = std::string("mtllib a.mtl\n") + kSquare;
  albedo(mark + obj, mark + mtl);
  albedo(mark + kSquare + mark + "mtllib a.mtl\n", mtl);
  albedo(changed(obj, "\n", "\r\n"), changed(mtl, "\n", "\r"));
  albedo(changed(obj, "\n", "\r"), mtl);
  albedo("# C:\\models\\\n" + obj, mtl);
  std::string capitals = kSquare;
  const std::pair<const char*, const char*> words[] = {
      {"usemtl", "USEMTL"}, {"f ", "F "}, {"vt ", "VT "}, {"v ", "V "}};
  for (const auto& [small, capital] : words) capitals = changed(capitals, small, capital);
  albedo("MtlLib a.mtl\n" + capitals, "NEWMTL paint\nkd 0.1 0.2 0.3\n");
  albedo("mtllib my lib.mtl a.mtl\n" + std::string(kSquare), mtl);
  albedo("mtllib \"a.mtl\"\n" + std::string(kSquare), mtl);
  albedo("mtllib \"my lib.mtl\" \"a.mtl\"\n" + std::string(kSquare), mtl);
  albedo("mtllib a.mtl \"my lib.mtl\"\n" + std::string(kSquare), mtl);
  albedo(changed(obj, "\nf ", "\nfo "), mtl);
  albedo("mtllib a.mtl my lib.mtl a.mtl\n" + std::string(kSquare), mtl);
  albedo("mtllib none.mtl a.mtl\n" + std::string(kSquare), mtl, true);
  albedo(changed(obj, "paint", "paint #1"), "newmtl paint #2\nKd 1 1 1\nnewmtl paint #1\nKd 0.1 0.2 0.3\n");
  albedo(changed(obj, "paint", "paint # of the wall"), mtl);
  albedo(obj, mtl + "newmtl paint\nKd 1 1 1\n", true);
  albedo(obj, mtl + "d 1\nTr 1\n", true);
}

TEST_CASE("Obj, WordsThatAreNotReadAreNamedOnce") {
  const geometry::Surfaces s =
      surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare + "s 1\nsurf 0 1\nSurf 0 1\ncall b.obj\n"},
                  {"a.mtl", "newmtl paint\nKa 1 1 1\nNs 10\nKd 0.5 0.5 0.5\nGlow 1\nglow 1\n"}});
  REQUIRE(s.warning.size() == 2);
  CHECK(warns(s, "a.obj: not read: surf (line 13), call (line 15)"));
  CHECK(warns(s, "a.mtl: not read: glow (line 5)"));
  // A filter of 1 1 1 passes everything, and is written beside opaque surfaces too.
  const geometry::Surfaces filters =
      surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare},
                  {"a.mtl", "newmtl paint\nTf 1.000 1 1.0\nnewmtl glass\nTf 1.0 0.5 1.0\n"}});
  REQUIRE(filters.warning.size() == 1);
  CHECK(warns(filters, "a.mtl: not read: tf (line 4)"));
}

TEST_CASE("Obj, NothingToDrawNamesTheLikeliestReason") {
  CHECK_THROWS_WITH(surfacesOf({{"a.obj", "<html>\nv 0 0 0\n"}}),
                    Catch::Contains("a.obj: the level holds nothing to draw") && Catch::Contains("<html> (line 1)"));
  CHECK_THROWS_WITH(surfacesOf({{"a.obj", "v 0 0 0\nv 1 0 0\nv inf 0 1\nf 1 2 3\n"}}),
                    Catch::Contains("nothing to draw; its 1 triangles are without area, or not finite"));
  CHECK_THROWS_WITH(surfacesOf({{"a.obj", "v 0 0 0\n"}}), Catch::EndsWith("the level holds nothing to draw"));
}

TEST_CASE("Obj, EmissionFollowsTheTexelsOfItsImage") {
  const std::string image = targa(2, 1, {255, 0, 0, 255, 0, 0, 255, 255});
  const auto emissionAt = [&](const std::string& mtl, double x) {
    const geometry::Surfaces s = surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare},
                                             {"a.mtl", "newmtl paint\nKd 0 0 0\n" + mtl},
                                             {"glow.tga", image}});
    CHECK(warns(s, "none.tga") == (mtl.find("none.tga") != std::string::npos));
    const geometry::Tracer tracer(s);
    return tracer.emission(*below(tracer, x, 0.1));
  };
  checkNear(emissionAt("map_Ke glow.tga\n", -0.5), {1, 0, 0}, 1e-6);
  checkNear(emissionAt("Ke 4 4 2\nmap_Ke glow.tga\n", 0.5), {0, 0, 2}, 1e-6);
  checkNear(emissionAt("Ke 4 4 2\nmap_Ke -o 0.5 0 glow.tga\n", -0.5), {0, 0, 2}, 1e-6);
  checkNear(emissionAt("Ke 0 0 0\nmap_Ke glow.tga\n", -0.5), Number3(0.0), 0);
  checkNear(emissionAt("Ke 4 4 2\nmap_Ke none.tga\n", -0.5), Number3(0.0), 0);
}

TEST_CASE("Obj, OtherEncodingsAreRefusedByName") {
  const auto wide = [](const std::string& text, bool mark) {
    std::string bytes = mark ? "\xff\xfe" : "";
    for (const char c : text) bytes += {c, '\0'};
    return bytes;
  };
  checkSurfacesRefused({{"a.obj", wide(kSquare, true)}}, {"a.obj: is UTF-16"});
  checkSurfacesRefused({{"a.obj", wide(kSquare, false)}}, {"a.obj: is UTF-16"});
  checkSurfacesRefused({{"a.obj", std::string("mtllib a.mtl\n") + kSquare}, {"a.mtl", wide("newmtl paint\n", true)}},
                       {"a.mtl: is UTF-16"});
  checkSurfacesRefused({{"a.obj", std::string("\x4c\x01\x06\0\0\0v", 7)}}, {"a.obj: is a binary file"});
}

TEST_CASE("Obj, ABlackKdBesideAnImageIsSaid") {
  const geometry::Surfaces s = surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare},
                                           {"a.mtl", "newmtl paint\nKd 0 0 0\nmap_Kd a.tga\n"},
                                           {"a.tga", targa(1, 1, {200, 100, 50, 255})}});
  CHECK(warns(s, "a.obj: material paint: black, as Kd 0 0 0 multiplies map_Kd"));
  checkNear(geometry::Tracer(s).albedo(*below(geometry::Tracer(s), 0.2, 0.3)), Number3(0.0), 0);
}

TEST_CASE("Obj, ImagesLieWithVFromTheBottom") {
  const std::uint8_t texels[2][2][3] = {{{250, 10, 40}, {200, 20, 80}}, {{90, 60, 10}, {70, 120, 30}}};
  const std::string image =
      textOf(image::encodePng(2, 2, std::span<const std::uint8_t>(&texels[0][0][0], sizeof(texels))));
  const auto linear = [&](int column, int row) {
    const auto& t = texels[row][column];
    return Number3(det::srgbDecode(t[0] / 255.0), det::srgbDecode(t[1] / 255.0), det::srgbDecode(t[2] / 255.0));
  };
  const auto albedoOf = [&](const std::string& mtl, double x, double z) {
    const geometry::Surfaces s = surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare},
                                             {"a.mtl", "newmtl paint\n" + mtl},
                                             {"maps/a b.png", image}});
    const geometry::Tracer tracer(s);
    return tracer.albedo(*below(tracer, x, z));
  };
  const double kFloats = 1e-5;
  for (const int row : {0, 1})
    for (const int column : {0, 1})
      checkNear(albedoOf("map_Kd maps\\a b.png\n", column - 0.5, row - 0.5), linear(column, row), kFloats);
  checkNear(albedoOf("Kd 0.5 1 0.25\nmap_Kd -blendu on maps/a b.png\n", -0.5, 0.5),
            linear(0, 1) * Number3(0.5, 1, 0.25), kFloats);
  // Repeated twice and moved up by a quarter: the square's u = 0.25, v = 0.25 from the bottom becomes (0.5, 0.75).
  checkNear(albedoOf("map_Kd -s 2 2 1 -o 0 0.25 maps/a b.png\n", -0.5, 0.5), (linear(0, 0) + linear(1, 0)) * 0.5,
            kFloats);
}

TEST_CASE("Obj, TransparencyIsAMaskAtOneHalfForPlacesAndPartialForLight") {
  const auto hits = [](const std::string& mtl) {
    const geometry::Surfaces s = surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare},
                                             {"a.mtl", "newmtl paint\nKd 1 1 1\n" + mtl},
                                             {"leaf.tga", targa(2, 1, {9, 9, 9, 255, 9, 9, 9, 0})}});
    const geometry::Tracer tracer(s);
    CHECK(warns(s, "map_d") == (mtl.find("map_d other") != std::string::npos));
    return std::pair(below(tracer, -0.5, 0.1).has_value(), below(tracer, 0.5, 0.1).has_value());
  };
  CHECK(hits("d 0.6\n") == std::pair(true, true));
  CHECK(hits("d 0.4\n") == std::pair(false, false));
  CHECK(hits("Tr 0.6\n") == std::pair(false, false));
  CHECK(hits("map_Kd leaf.tga\n") == std::pair(true, true));
  CHECK(hits("map_Kd leaf.tga\nmap_d leaf.tga\n") == std::pair(true, false));
  CHECK(hits("map_Kd leaf.tga\nmap_d other.tga\n") == std::pair(true, true));
  const geometry::Surfaces s =
      surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare}, {"a.mtl", "newmtl paint\nKd 1 1 1\nd 0.3\n"}});
  const geometry::Tracer tracer(s);
  const auto hit = tracer.closest({0.1, 10.0, 0.1}, {0.0, -1.0, 0.0}, 100.0, geometry::Meets::light);
  REQUIRE(hit);
  checkNear(tracer.passing(*hit), Number3(0.7), 1e-12);
}

// DDS has its top row first, and v counts from the bottom.
TEST_CASE("Obj, DdsTextures") {
  const auto read = [](const std::string& dds) {
    const geometry::Surfaces s = surfacesOf({{"a.obj", std::string("mtllib a.mtl\n") + kSquare},
                                             {"a.mtl", "newmtl paint\nmap_Kd t.DDS\n"},
                                             {"t.DDS", dds}});
    CHECK(s.warning.empty());
    const geometry::Tracer tracer(s);
    return std::array{tracer.albedo(*below(tracer, -0.5, -0.5)), tracer.albedo(*below(tracer, 0.5, 0.5))};
  };
  // 2 x 2 texels of blue, green, red, alpha: the top left one is red, the bottom right one is sRGB 188, about half.
  const auto plain = read(ddsOf(ddsBgra(2, 2), {0, 0, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 188, 188, 188, 255}));
  checkNear(plain[0], {1, 0, 0}, 1e-5);
  checkNear(plain[1], Number3(det::srgbDecode(188.0 / 255.0)), 1e-5);
  // A block of BC1: its first two rows take the first colour, red, the others two thirds of it and one of blue.
  const auto block = read(ddsOf(ddsBlocks(4, 4, "DXT1"), {0x00, 0xf8, 0x1f, 0x00, 0x00, 0x00, 0xaa, 0xaa}));
  checkNear(block[0], {1, 0, 0}, 1e-5);
  checkNear(block[1], {det::srgbDecode(170.0 / 255.0), 0, det::srgbDecode(85.0 / 255.0)}, 1e-5);
  checkSurfacesRefused({{"a.obj", std::string("mtllib a.mtl\n") + kSquare},
                        {"a.mtl", "newmtl paint\nmap_Kd t.dds\n"},
                        {"t.dds", ddsOf(ddsBgra(2, 2), {0, 0, 255})}},
                       {"t.dds: damaged or cut: its texels take 16 bytes; the file ends 3 bytes on"});
}

TEST_CASE("Obj, WhatIsMissingGetsTheLevelsAlbedoAndAWarning") {
  const auto read = [](const Files& files, const std::string& warning) {
    const Folder folder;
    level::LevelFile level = levelOf(folder, files);
    level.geometry[0].albedo = {0.1, 0.2, 0.3};
    const geometry::Surfaces s = loader::surfacesOf(loader::readScene(level), 1.0);
    INFO(warning);
    CHECK(warns(s, warning));
    const geometry::Tracer tracer(s);
    checkNear(tracer.albedo(*below(tracer, 0.2, 0.3)), {0.1, 0.2, 0.3}, 1e-12);
  };
  const std::string obj = std::string("mtllib a.mtl\n") + kSquare;
  read({{"a.obj", obj}}, "a.obj: mtllib a.mtl is not there");
  read({{"a.obj", obj}, {"a.mtl", "newmtl other\nKd 1 1 1\n"}},
       "a.obj: 1 materials are in none of its mtllib, the first paint");
  std::string numbered = obj;
  numbered.replace(numbered.find("paint"), 5, "paint #3");
  read({{"a.obj", numbered}, {"a.mtl", "newmtl paint #2\nKd 1 1 1\n"}}, "the first paint #3");
  read({{"a.obj", obj}, {"a.mtl", "newmtl paint\nmap_Kd x/none.png\n"}},
       "a.obj: 1 images of its materials are not there, the first x/none.png");
  read({{"a.obj", obj}, {"a.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd t.ktx2\n"}, {"t.ktx2", "\xabKTX 20\xbb"}},
       "a.obj: 1 images of its materials are in a format that is not read, the first t.ktx2");
}

TEST_CASE("Obj, VertexColoursAndNumbersThatAreNotFinite") {
  const geometry::Surfaces s =
      surfacesOf({{"a.obj",
                   "v -1 0 1 0.5 0.25 1\nv 1 0 1 0.5 0.25 1\nv 1 0 -1 0.5 0.25 1\nv nan 0 -1\nv 1e999 0 0\n"
                   "f 1 2 3\nf 1 3 4\nf 1 2 5\nf 1 1 2\n"}});
  CHECK(s.triangle.size() == 1);
  CHECK(s.dropped_triangles == 3);
  const geometry::Tracer tracer(s);
  checkNear(tracer.albedo(*below(tracer, 0.5, 0.5)), {0.5, 0.25, 1}, 1e-6);
}

TEST_CASE("Obj, MessagesNameFileAndLine") {
  const auto refuse = [](const std::string& line, const std::string& says) {
    INFO(line);
    checkSurfacesRefused({{"a.obj", "v 0 0 0\r\nv 1 0 0\r\nv 0 0 1\r\nvt 0 0\r\n\r\n" + line + "\nf 1 2 3\n"}},
                         {"a.obj: line 6: ", says});
  };
  refuse("f 1 2 4", "vertex 4 is none of the 3");
  refuse("f 0 1 2", "vertex 0 is none");
  refuse("f -4 1 2", "vertex -4 is none");
  refuse("f 1 2 x", "\"x\" is not the number of a vertex");
  refuse("f 1 2 3.5", "\"3.5\" is not the number");
  refuse("f 1 2 99999999999", "is not the number");
  refuse("f 1/2 2/1 3/1", "texture coordinate 2 is none of the 1");
  refuse("f 1//1 2//1 3//1", "normal 1 is none of the 0");
  refuse("f 1 2", "2 corners");
  refuse("v 1 2", "v needs at least 3 numbers");
  refuse("v 1 2 3x", "\"3x\" is not a number");
  refuse("v 1 2 3 4 5 6", "a vertex colour holds 4");
  checkSurfacesRefused({{"a.obj", "v 0 0 0\n"}}, {"a.obj", "nothing to draw"});
  const auto refuseMtl = [](const std::string& line, const std::string& says) {
    INFO(line);
    checkSurfacesRefused({{"a.obj", std::string("mtllib a.mtl\n") + kSquare}, {"a.mtl", "newmtl paint\n" + line}},
                         {"a.mtl: line 2: ", says});
  };
  refuseMtl("Kd 1 2 0", "Kd holds 2, must be 0 to 1");
  refuseMtl("Kd spectral a.rfl", "Kd must be followed by numbers");
  refuseMtl("Ke -1 0 0", "Ke holds -1");
  refuseMtl("map_Kd -huge 1 a.png", "-huge is not an option");
  refuseMtl("map_Kd", "names no image");
  refuseMtl("newmtl", "names no material");
}

TEST_CASE("Obj, VerticesFarFromTheOriginKeepTheirDigits") {
  const auto squareAt = [](const std::string& x, const std::string& z) {
    return surfacesOf({{"a.obj", "v " + x + ".125 0.3 " + z + ".7\nv " + x + ".875 0.3 " + z + ".7\nv " + x +
                                     ".125 0.3 " + z + ".2\nf 1 2 3\n"}});
  };
  const geometry::Surfaces home = squareAt("0", "0");
  const geometry::Surfaces far = squareAt("900032", "100032");
  REQUIRE(far.position.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(far.position[i][0] - 900032.0 == home.position[i][0]);
    CHECK(far.position[i][1] == home.position[i][1]);
    CHECK(far.position[i][2] - 100032.0 == home.position[i][2]);
  }
}

}  // namespace welkin::tests
