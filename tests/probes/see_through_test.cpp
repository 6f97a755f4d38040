// SPDX-License-Identifier: Apache-2.0
// Light through glass and blended surfaces, by the reference, transfer and local transfer.
#include "probes/geometry/see_through.h"

#include <catch2/catch.hpp>

#include "probes/geometry/random.h"
#include "probes/transfer/local_paths.h"
#include "skies.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/probes/transfer/transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {

const Number3 kGlass(0.9, 0.6, 0.3);
constexpr double kHalf_m = 20000.0;  ///< of panes and ground to each side

/// Black ground, or one of `ground`, under an endless pane that faces up, 3 m above.
geometry::Surfaces underPane(const Number3& colour, double transmission, double alpha = 1.0,
                             const Number3& ground = Number3(0.0)) {
  geometry::Surfaces s = groundOf(ground, kHalf_m);
  const auto glass = addMaterial(s, colour);
  s.material[glass].transmission = transmission;
  s.material[glass].alpha = alpha;
  s.material[glass].blended = alpha < 1.0;
  s.material[glass].alpha_cutoff = alpha < 1.0 ? 0.5 : 0.0;
  addQuad(s, {-kHalf_m, 3, -kHalf_m}, {0, 0, 2 * kHalf_m}, {2 * kHalf_m, 0, 0}, glass);
  return s;
}

void checkNearly(const Number3& is, const Number3& must) {
  for (int c = 0; c < 3; ++c) CHECK(is[c] == Approx(must[c]));
}

/// Irradiance of level ground under a uniform sky of radiance 1, direct and reflected by the pane.
void checkUnder(const geometry::Surfaces& level, const Number3& expected, int bounces) {
  // The pane ends: rays below an elevation of 1e-4 pass by. On an upright surface they make 2e-4.
  constexpr double kEdge = 3e-4;
  const geometry::Tracer tracer(level);
  const model::Sky sky = uniformSky(1.0);
  checkEstimate(reference::traceReference(tracer, reference::DistantLight(sky, 12.0), {}, {0, 1, 0}, {0, 1, 0},
                                          {16384, bounces, 1})
                    .sky,
                expected, kEdge);
  const transfer::TransferTracer transfer(tracer, settingsOf(bounces, 1024));
  for (int c = 0; c < 3; ++c) {
    const auto m = measured(transfer, {0, 1, 0}, kProbes, [&](const transfer::TracedProbe& p) {
      std::array<double, transfer::kDirections> e{};
      for (std::size_t b = 0; b < e.size(); ++b) {
        const double open = det::kPi * (1.0 + transfer::transferBasis()[b].y) / 2.0;
        e[b] = p.transfer.visibility[b] * open + p.transfer.sky[b][0][c] / det::kShConstant;
      }
      return reconstructed({0, 1, 0}, e);
    });
    checkMeasured(m, expected[c], kEdge);
  }
}

}  // namespace

TEST_CASE("SeeThrough, APaneDimsAndColoursTheSky") {
  checkUnder(underPane(Number3(1.0), 1.0), Number3(det::kPi), 0);
  checkUnder(underPane(kGlass, 1.0), kGlass * det::kPi, 0);
  checkUnder(underPane(kGlass, 0.75), kGlass * (0.75 * det::kPi), 0);
  checkUnder(underPane(kGlass, 0.0, 0.25), Number3(0.75 * det::kPi), 0);
  checkUnder(underPane(kGlass, 0.5, 0.25), (Number3(0.75) + kGlass * 0.125) * det::kPi, 0);
  checkUnder(underPane(kGlass, 0.0), Number3(0.0), 0);
}

TEST_CASE("SeeThrough, TwoPanesMultiplyAndTheirOrderIsNone") {
  geometry::Surfaces level = underPane(kGlass, 1.0);
  const auto second = addMaterial(level, {0.5, 1.0, 0.25});
  level.material[second].transmission = 0.5;
  addQuad(level, {-kHalf_m, 4, -kHalf_m}, {2 * kHalf_m, 0, 0}, {0, 0, 2 * kHalf_m}, second);  // faces down
  checkUnder(level, kGlass * Number3(0.25, 0.5, 0.125) * det::kPi, 0);
}

TEST_CASE("SeeThrough, TheSunAndLampsShineThroughGlass") {
  const Number3 ground(0.4, 0.5, 0.6);
  geometry::Surfaces level = underPane(kGlass, 1.0, 1.0, ground);
  geometry::StaticLight lamp;  // above the pane, 5 m over the ground
  lamp.position = {0, 5, 0};
  lamp.intensity = Number3(100.0);
  level.light = {lamp};
  const geometry::Tracer tracer(level);
  const double elevation = 0.6;
  const model::Sky sky = sunOnly(2.0, 1.1, elevation);
  const reference::DistantLight distant(sky, 12.0);
  const Number3 below(0, 1, 0);
  const auto e = reference::traceReference(tracer, distant, {}, below, {0, -1, 0}, {16384, 1, 1});
  checkEstimate(e.sun_bounce, kGlass * ground * (2.0 * std::sin(elevation)), 1e-4);
  // Without the pane the lamp gives this; between light, ground and point there is one pane.
  geometry::Surfaces open = groundOf(ground, kHalf_m);
  open.light = level.light;
  const geometry::Tracer open_tracer(open);
  const auto bare = reference::traceReference(open_tracer, distant, {}, below, {0, -1, 0}, {16384, 1, 1});
  checkEstimate(e.local, kGlass * bare.local.value, 1e-6);
  transfer::TransferSettings settings = settingsOf(1, 1024);
  settings.light_directions = {towards(1.1, elevation)};
  const transfer::TransferTracer transfer(tracer, settings);
  for (int c = 0; c < 3; ++c) {
    checkMeasured(measured(transfer, below, kProbes, [&](const auto& p) { return p.transfer.sun[3][0][c]; }),
                  kGlass[c] * ground[c] * std::sin(elevation), 1e-4);
    checkMeasured(measured(transfer, below, kProbes, [&](const auto& p) { return p.transfer.emitted[3][c]; }),
                  kGlass[c] * bare.local.value[c], 3.0 * bare.local.standard_error[c]);
  }
  // A dynamic light in the lamp's place: local transfer sees it through the pane, too.
  CHECK_FALSE(transfer::seesEachOther(tracer, below, lamp.position));
  checkNearly(transfer::shareBetween(tracer, below, lamp.position), kGlass);
}

TEST_CASE("SeeThrough, AWhiteBlendedPaneKeepsAllLight") {
  // A black room that shines: whether a path passes the pane or turns back, it ends at a wall.
  geometry::Surfaces room;
  const Number3 emission(1.5, 0.5, 2.0);
  addBoxInside(room, {-1, 0, -3}, {2, 2.5, 1}, addMaterial(room, Number3(0.0), false, emission));
  const auto pane = addMaterial(room, Number3(1.0));
  room.material[pane].blended = true;
  room.material[pane].alpha = 0.4;
  addQuad(room, {1, 0, -3}, {0, 2.5, 0}, {0, 0, 4}, pane);
  const geometry::Tracer tracer(room);
  for (const Number3& normal : kNormals)
    checkEstimate(reference::traceReference(tracer, darkness(), {}, {0.3, 1, -0.4}, normal, {256, 1, 1}).local,
                  emission * det::kPi);
}

TEST_CASE("SeeThrough, PlacesTakeGlassForSolidAndBlendedTexelsByTheirCutoff") {
  const geometry::Surfaces glass = underPane(kGlass, 1.0);
  const geometry::Tracer tracer(glass);
  CHECK(tracer.occluded({0, 1, 0}, {0, 1, 0}, 10.0));
  const auto hit = tracer.closest({0, 1, 0}, {0, 1, 0}, 10.0);
  REQUIRE(hit);
  CHECK_FALSE(hit->back);  // though it faces up
  const geometry::Surfaces thin = underPane(kGlass, 0.0, 0.25);
  const geometry::Tracer thin_tracer(thin);
  CHECK_FALSE(thin_tracer.occluded({0, 1, 0}, {0, 1, 0}, 10.0));
  CHECK(thin_tracer.closest({0, 1, 0}, {0, 1, 0}, 10.0, geometry::Meets::light));
}

TEST_CASE("SeeThrough, ManySurfacesEndALight") {
  geometry::Surfaces stack;
  const auto clear = addMaterial(stack, Number3(1.0));
  stack.material[clear].transmission = 1.0;
  const auto pile = [&](int from, int to) {
    for (int i = from; i < to; ++i) addQuad(stack, {-1, 1.0 + i, -1}, {0, 0, 2}, {2, 0, 0}, clear);
    return geometry::arrivingShare(geometry::Tracer(stack), Number3(0.0), {0, 1, 0}, 1e9);
  };
  CHECK(pile(0, geometry::kMostPassed) == Number3(1.0));
  CHECK(pile(geometry::kMostPassed, geometry::kMostPassed + 1) == Number3(0.0));
}

}  // namespace welkin::tests
