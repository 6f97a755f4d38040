// SPDX-License-Identifier: Apache-2.0
#include "closed_form_list.h"

#include <fmt/format.h>

#include <cmath>

#include "closed_forms.h"
#include "tests/probes/skies.h"
#include "tests/probes/sky_polygon.h"

namespace welkin::tests {
namespace {

using reference::LocalLight;
using transfer::SkyBounce;
using transfer::SunTransfer;

const Number3 kPlane(0.2, 0.5, 0.9);
const AskedNormal kUp{"up", {0, 1, 0}};
const AskedNormal kEast{"east", {1, 0, 0}};
const AskedNormal kAslant{"aslant", geometry::unit({0.3, -0.5, -0.7})};

/// Cosine-weighted share of a normal's view above the horizon, and below it.
double above(const Number3& n) {
  return 0.5 * (1.0 + n.y);
}
double below(const Number3& n) {
  return 0.5 * (1.0 - n.y);
}

model::Sky withGround(model::Sky sky, const Number3& albedo) {
  sky.ground_albedo = albedo;
  return sky;
}

const char* nameOf(SunTransfer sun) {
  return sun == SunTransfer::sh ? "sh" : "directional";
}

constexpr double kWide_m = 1000.0;
constexpr double kNarrow_m = 0.5;

const char* endOf(double half_m) {
  return half_m < kWide_m ? ", level of 1 m" : "";
}

/// A plane that ends after half_m; the ground beyond continues it.
ClosedForm plane(const Number3& albedo, double half_m) {
  ClosedForm form;
  form.name = fmt::format("plane of albedo {:g}, uniform sky", albedo.x) + endOf(half_m);
  form.surfaces = groundOf(albedo, half_m);
  form.sky = withGround(uniformSky(1.0), albedo);
  form.position = {0, 1, 0};
  form.exact = [albedo](const Number3& n) { return Number3(above(n)) + albedo * below(n); };
  form.asked = {kUp, kEast, kAslant};
  return form;
}

/// A plane under a sun of normal irradiance pi.
ClosedForm planeUnderSun(double elevation_deg, SunTransfer sun, double half_m) {
  const double elevation = elevation_deg * det::kPi / 180.0;
  ClosedForm form;
  form.name = fmt::format("plane of albedo 0.2, sun at {:g} deg, `{}`", elevation_deg, nameOf(sun)) + endOf(half_m);
  form.surfaces = groundOf(kPlane, half_m);
  form.sky = withGround(sunOnly(det::kPi, 2.1, elevation), kPlane);
  form.position = {0, 1, 0};
  form.sun = sun;
  form.exact = [=](const Number3& n) { return kPlane * (std::sin(elevation) * below(n)); };
  if (sun == SunTransfer::sh)
    form.held = [=](const Number3& n) { return kPlane * ((0.25 + 0.5 * std::sin(elevation)) * below(n)); };
  form.asked = {kEast, kAslant};
  return form;
}

constexpr double kEye_m = 1e-3;  ///< height of the points below above the ground

/// Black walls under a sky of radiance 1, seen through `sky`. `of_level` is the form for level ground.
ClosedForm blackWalls(std::string name, geometry::Surfaces surfaces, const SkyPolygon& sky, double of_level,
                      std::vector<std::size_t> shown) {
  ClosedForm form;
  form.name = std::move(name);
  form.surfaces = std::move(surfaces);
  form.sky = uniformSky(1.0);
  form.position = {0, kEye_m, 0};
  form.bounces = 1;
  form.exact = [=](const Number3& n) { return Number3(n == Number3(0, 1, 0) ? of_level : irradianceOverPi(sky, n)); };
  form.level_bound = 2e-6;  // walls end, and round wells have sides
  form.asked = {kUp};
  form.shown = std::move(shown);
  return form;
}

void addBlackWalls(std::vector<ClosedForm>& forms) {
  const Number3 black(0.0);
  const double angle = det::kPi / 4.0;
  const double seen_from_ground = std::atan(std::tan(angle) + kEye_m / 10.0);
  forms.push_back(blackWalls("wall to 45 deg", wallTo(seen_from_ground, black, black), skyOverWall(angle),
                             skyViewOfWall(angle), {0, 1, 2}));
  for (const double height : {4.0, 8.0})
    forms.push_back(blackWalls(fmt::format("canyon, H/W = {:g}", height / 8.0),
                               canyonOf(8, height + kEye_m, black, black), skyOfCanyon(8, height),
                               skyViewOfCanyon(8, height), {0, 1}));
  constexpr int kRound = 2048;
  forms.push_back(blackWalls("round well, H/R = 1", wellOf(3, 3 + kEye_m, kRound, black, black),
                             skyOfWell(3, 3, kRound), skyViewOfRoundWell(3, 3), {0}));
  for (const double ratio : {0.5, 1.0, 2.0})
    forms.push_back(blackWalls(fmt::format("square courtyard, H/W = {:g}", ratio),
                               wellOf(2, 4 * ratio + kEye_m, 4, black, black), skyOfWell(2, 4 * ratio, 4),
                               skyViewOfWell(2, 4 * ratio, 4), {0, 1}));
}

/// A plane under radiance (1 + 2 sin el) / 3.
ClosedForm overcast(SkyBounce way) {
  ClosedForm form;
  form.name = std::string("plane of albedo 0.2, `cie-overcast`") + (way == SkyBounce::fitted ? ", fitted" : "");
  form.surfaces = groundOf(kPlane);
  form.sky = withGround(uniformSky(1.0), kPlane);
  form.sky.luminance = *model::findLuminance("cie-overcast");
  form.position = {0, 1, 0};
  form.sky_bounce = way;
  const double ground = 7.0 / 9.0;
  form.exact = [=](const Number3& n) {
    const double angle = std::acos(n.y);
    const double direct = (above(n) + 4.0 / (3.0 * det::kPi) * (std::sin(angle) + (det::kPi - angle) * n.y)) / 3.0;
    return Number3(direct) + kPlane * (ground * below(n));
  };
  const double held_ground = way == SkyBounce::fitted ? ground : 13.0 / 18.0;
  form.held = [=](const Number3& n) {
    const double direct = n.y > 0.0 ? 1.0 / 3.0 + 7.0 / 18.0 * n.y : 0.0;
    return Number3(direct) + kPlane * (held_ground * below(n));
  };
  form.level_bound = 1e-6;  // error of the sky's projection
  form.asked = {kUp, kEast};
  return form;
}

ClosedForm shiningBox(int bounced) {
  const Number3 albedo(0.6, 0.3, 0.9);
  ClosedForm form;
  form.name = "box of albedo 0.6 that emits 1";
  addBoxInside(form.surfaces, {-1, 0, -3}, {2, 2.5, 1}, addMaterial(form.surfaces, albedo, false, Number3(1.0)));
  form.sky = uniformSky(1.0);
  form.position = {0.3, 1, -0.4};
  form.bounces = bounced;
  form.exact = [=](const Number3&) { return bounces(albedo, 0, bounced); };
  form.asked = {kUp, kAslant};
  form.shown = {0};
  return form;
}

/// A lamp of intensity pi R^2 in a sphere.
ClosedForm lampInSphere(int bounced) {
  constexpr double kRadius_m = 3.0;
  const Number3 albedo(0.6, 0.3, 0.9);
  ClosedForm form;
  form.name = "sphere of albedo 0.6, light in its middle";
  form.surfaces = sphereInside(kRadius_m, 5, albedo);
  form.sky = uniformSky(0.0);
  form.lamp = {{{0, 0, 0}, Number3(det::kPi * kRadius_m * kRadius_m)}};
  form.position = {0.7, 1.2, -0.9};
  form.bounces = bounced;
  form.exact = [=](const Number3&) { return bounces(albedo, 1, bounced); };
  form.level_bound = 3.0 * roughnessOf(form.surfaces, kRadius_m);
  form.asked = {kUp, kAslant};
  form.shown = {0};
  return form;
}

/// A place without light: a bright sky with a sun above, and a lamp behind a wall.
ClosedForm dark(std::string name, geometry::Surfaces surfaces, const Number3& position, SunTransfer sun) {
  ClosedForm form;
  form.name = std::move(name) + ", `" + nameOf(sun) + "`";
  form.surfaces = std::move(surfaces);
  form.sky = withGround(clearSky(1.0, 1.2), Number3(1.0));
  form.position = position;
  form.bounces = 4;
  form.sun = sun;
  form.exact = [](const Number3&) { return Number3(0.0); };
  form.asked = {kUp, kEast, kAslant};
  form.shown = {0, 3};
  return form;
}

void addDark(std::vector<ClosedForm>& forms) {
  const Number3 albedo(0.8);
  constexpr double kTurned_rad = 0.37;
  const Number3 moved(211.3, 17.1, -93.7);
  for (const SunTransfer sun : {SunTransfer::directional, SunTransfer::sh}) {
    geometry::Surfaces box;
    addBoxInside(box, {-1, 0, -3}, {2, 2.5, 1}, addMaterial(box, albedo, true));
    forms.push_back(dark("closed box", box, {0.3, 1, -0.4}, sun));
    const LocalLight lamp{{-2, 1, 0.3}, Number3(10.0)};
    for (const bool open : {true, false}) {
      forms.push_back(dark(open ? "room behind an open one" : "second of two sealed rooms", twoRooms(albedo, open),
                           {2, 1.5, 0}, sun));
      forms.back().lamp = {lamp};
    }
    forms.push_back(dark("2 cm behind a thin wall", twoRooms(albedo, true), {0.02, 1.5, 0}, sun));
    forms.back().lamp = {lamp};
    forms.push_back(dark("1 mm from three walls of a corner", twoRooms(albedo, true), {0.001, 0.001, -1.999}, sun));
    forms.back().lamp = {lamp};
    forms.push_back(dark("the same, turned and far away", turned(twoRooms(albedo, true), kTurned_rad, moved),
                         turned({0.001, 0.001, -1.999}, kTurned_rad) + moved, sun));
    forms.back().lamp = {{turned(lamp.position, kTurned_rad) + moved, lamp.intensity}};
  }
}

}  // namespace

std::vector<ClosedForm> closedForms() {
  std::vector<ClosedForm> forms;
  for (const int n : {0, 1, 2, 9}) forms.push_back(shiningBox(n));
  forms.push_back(plane(Number3(1.0), kWide_m));
  for (const double half_m : {kWide_m, kNarrow_m}) forms.push_back(plane(kPlane, half_m));
  for (const double elevation_deg : {1.0, 30.0, 60.0, 90.0})
    for (const SunTransfer sun : {SunTransfer::directional, SunTransfer::sh})
      forms.push_back(planeUnderSun(elevation_deg, sun, kWide_m));
  for (const SunTransfer sun : {SunTransfer::directional, SunTransfer::sh})
    forms.push_back(planeUnderSun(60.0, sun, kNarrow_m));
  addBlackWalls(forms);
  for (const SkyBounce way : {SkyBounce::projected, SkyBounce::fitted}) forms.push_back(overcast(way));
  for (const int n : {1, 2, 5}) forms.push_back(lampInSphere(n));
  addDark(forms);
  return forms;
}

}  // namespace welkin::tests
