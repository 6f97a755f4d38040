// SPDX-License-Identifier: Apache-2.0
// Placed vertices and points of contact factors. tests/cli has the factors themselves.
#include <catch2/catch.hpp>
#include <cmath>

#include "probes/contact/contact_points.h"

using namespace welkin;
using contact::PlacedVertices;
using f64::Number3;

namespace {

/// One triangle in the plane z = 0 of its mesh, its front towards +z, placed as asked, and a vegetation's.
level::Scene sceneOf(const std::vector<geometry::Affine>& placing) {
  level::Scene scene;
  scene.vertices = {{{0, 0, 0}, {0, 0, 1}, {}, {}}, {{4, 0, 0}, {0, 0, 1}, {}, {}}, {{0, 2, 0}, {0, 0, 1}, {}, {}}};
  scene.indices = {0, 1, 2};
  scene.materials.resize(1);
  scene.objects = {{"wall", geometry::Role::fixed}, {"tree", geometry::Role::vegetation}};
  for (const geometry::Affine& t : placing) {
    level::Draw draw;
    draw.index_count = 3;
    draw.first_instance = static_cast<std::uint32_t>(scene.instances.size());
    draw.instance_count = 1;
    draw.mirrored = t.determinant() < 0.0;
    scene.draws.push_back(draw);
    scene.instances.push_back({});
    scene.placings.push_back({t, 0});
  }
  level::Draw tree = scene.draws.front();
  tree.role = geometry::Role::vegetation;
  tree.first_instance = static_cast<std::uint32_t>(scene.instances.size());
  scene.draws.push_back(tree);
  scene.instances.push_back({});
  scene.placings.push_back({{}, 1});
  return scene;
}

}  // namespace

TEST_CASE("Contact, MirroredPiecesKeepTheirFronts") {
  // Twice as wide along x, and mirrored, so the front looks towards +z still; then turned upside down.
  const geometry::Affine wide{{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {10, 0, 0}};
  const geometry::Affine turned{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};
  const PlacedVertices v = contact::placedVertices(sceneOf({wide, turned}));
  REQUIRE(v.piece.size() == 2);
  REQUIRE(v.piece[1].first == 3);
  REQUIRE(v.position.size() == 6);
  CHECK(v.position[1].x == 2.0);
  CHECK(v.normal[0].z == 1.0);
  CHECK(v.normal[3].y == -1.0);
  const auto points = contact::pointsToFit(v, 1.0);
  CHECK(points.front().normal.z == 1.0);
  CHECK(points.back().normal.y == -1.0);
  double area = 0.0;
  for (const auto& p : points) area += p.area_m2;
  CHECK(area == Approx(8.0 + 4.0));
}

TEST_CASE("Contact, SlantedNormalsFollowTheCofactors") {
  // Stretched along x by 2, the plane x + z = 0 becomes x / 2 + z = 0.
  level::Scene scene = sceneOf({{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}});
  for (level::Vertex& v : scene.vertices) v.normal[0] = v.normal[2] = float(std::sqrt(0.5));
  const PlacedVertices v = contact::placedVertices(scene);
  CHECK(v.normal[0].x == Approx(1.0 / std::sqrt(5.0)));
  CHECK(v.normal[0].z == Approx(2.0 / std::sqrt(5.0)));
}

TEST_CASE("Contact, VerticesOfOnePlaceAndNormalShareAFactor") {
  const geometry::Affine same;
  const geometry::Affine moved{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {4, 0, 0}};
  const geometry::Affine turned{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};
  const PlacedVertices v = contact::placedVertices(sceneOf({same, moved, turned}));
  CHECK(v.shared[1] == v.shared[3]);  // (4, 0, 0) of both
  CHECK(v.shared[0] != v.shared[3]);
  CHECK(v.shared[0] != v.shared[6]);  // one place, two normals
  CHECK(v.places == 8);
}

TEST_CASE("Contact, PointsToCheckAreUniform") {
  const PlacedVertices v = contact::placedVertices(sceneOf({{}, {{3, 0, 0}, {0, 1e-3, 0}, {0, 0, 1}, {100, 0, 0}}}));
  constexpr std::size_t kPoints = 20000;
  const auto points = contact::pointsToCheck(v, kPoints);
  REQUIRE(points.size() == kPoints);
  Number3 mean(0.0);
  double sliver = 0.0, area = 0.0;
  for (const auto& p : points) {
    area += p.area_m2;
    if (p.position.x > 50.0)
      sliver += 1.0;
    else
      mean += p.position;
  }
  CHECK(area == Approx(4.0 + 12.0 * 1e-3 / 2.0 * 2.0).margin(0.01));
  mean = mean / (kPoints - sliver);
  // The spread of a mean of 20,000 points is 0.007 m along x and half of that along y.
  CHECK(mean.x == Approx(4.0 / 3.0).margin(0.03));
  CHECK(mean.y == Approx(2.0 / 3.0).margin(0.015));
  CHECK(sliver > 0.0);
  CHECK(sliver < 0.01 * kPoints);
}
