// SPDX-License-Identifier: Apache-2.0
#include "view/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/tone.h"
#include "view/painter.h"

namespace welkin::view {
namespace {

using f64::Number3;

constexpr double kGoodEnough = 0.15;  // error that few would see beside textures
constexpr double kSigmas = 3.0;       // of the truth's noise
constexpr double kLeak = 1.0;         // twice as bright as the truth
constexpr double kFloor = 1e-3;       // of open ground: darker than any display shows beside it
constexpr double kFarProbe_m = 6.0;   // farther than the middle of any cell about the point
constexpr double kContact_m = 0.5;

std::string sideOf(double error) {
  return fmt::format("{:.0f} % too {}", 100.0 * std::abs(error), error > 0.0 ? "bright" : "dark");
}

/// The reason that stands out for an error, for a person.
std::string reasonOf(const Answer& a) {
  std::size_t shut = 0, without = 0;
  for (std::size_t i = 0; i < a.cell_count; ++i) {
    shut += a.cells[i].part == "behind a wall" ? 1 : 0;
    without += a.cells[i].part == "no probe" ? 1 : 0;
  }
  if (a.nearest_probe_m > kFarProbe_m)
    return fmt::format("too few probes: the nearest that lights it is {:.1f} m away; add one", a.nearest_probe_m);
  if (a.contact) return "contact: something is nearer than the probes can tell";
  if (a.verdict == Verdict::leak)
    return fmt::format(
        "light leaks: {} of 8 cells are shut out by walls, the others see light that this point does "
        "not; a room, or a probe nearby, mends it",
        shut);
  if (without > 0) return fmt::format("{} of 8 cells have no probe, so few speak for this point", without);
  return "the probes' two bands and 4 m cells are coarse here; a probe nearby helps";
}

}  // namespace

void judge(Answer& a, const transfer::RelightScale& scale, double open_ground) {
  const bool unscaled = scale.sky == 1.0 && scale.sun_bounce == 1.0;
  const reference::ReferenceIrradiance& t = a.truth;
  const auto scaled = [&](Number3 reference::Estimate::*part) {
    if (unscaled) return t.total.*part;
    return t.sky.*part * scale.sky + t.sun_bounce.*part * scale.sun_bounce + t.local.*part;
  };
  a.expected = scaled(&reference::Estimate::value);
  a.error = a.noise = 0.0;
  if (!a.light) {
    a.verdict = Verdict::unlit;
    a.words = "no probe serves this point: it gets no ambient light";
    return;
  }
  const Number3 got(double{a.light->irradiance[0]}, double{a.light->irradiance[1]}, double{a.light->irradiance[2]});
  const double truth = f64::luminanceOf(a.expected), floor = kFloor * open_ground;
  // Of parts the errors add up at worst: one path feeds all of them.
  const double noise = f64::luminanceOf(scaled(&reference::Estimate::standard_error));
  const double difference = f64::luminanceOf(got) - truth, least = std::max(truth, floor);
  const bool dark = truth <= floor;
  if (least > 0.0) {
    a.error = difference / least;
    a.noise = noise / least;
  }
  if (std::abs(difference) <= std::max({kGoodEnough * truth, kSigmas * noise, floor})) {
    a.verdict = Verdict::right;
    a.words = dark && std::abs(difference) <= floor
                  ? "right: dark, as the truth is"
                  : fmt::format("right: within {:.0f} % of the truth, whose noise is {:.1f} %",
                                100.0 * std::abs(a.error), 100.0 * a.noise);
    return;
  }
  a.verdict = difference < 0.0                     ? Verdict::too_dark
              : dark || difference > kLeak * truth ? Verdict::leak
                                                   : Verdict::too_bright;
  a.words = (dark ? "bright where the truth is dark" : sideOf(a.error)) + ": " + reasonOf(a);
}

Answer answerAt(Level& level, const baked::SurfacePoint& point, double time_h, std::size_t paths,
                const base::Progress& progress) {
  Answer a;
  a.point = point;
  a.light = level.baked().at({point}, time_h)[0];
  a.cell_count = cellsAbout(level, point, a.cells);
  a.nearest_probe_m = 1e30;
  for (std::size_t i = 0; i < a.cell_count; ++i) {
    if (!(a.cells[i].share > 0.0)) continue;
    const Number3 way = level.placeOf(*a.cells[i].probe) - point.position;
    a.nearest_probe_m = std::min(a.nearest_probe_m, std::sqrt(dot(way, way)));
  }
  const build::Subject& subject = level.subject();
  // About the point, as `welkin reference` does, so that the numbers are the same.
  const geometry::Tracer tracer(subject.level->surfaces, point.position);
  const geometry::Hit start = tracer.pointOn(point.position, point.normal);
  a.contact = tracer.occluded(tracer.leaving(start), point.normal, kContact_m, geometry::Meets::fixed);
  const reference::DistantLight distant(subject.sky.sky, time_h);
  const reference::ReferenceSettings settings{paths, subject.level->section.transfer.bounces, 0};
  a.truth = reference::traceReference(tracer, distant, {}, point.position, point.normal, settings,
                                      progress.stage("paths", reference::referenceBatches(settings)));
  judge(a, subject.level->section.scale, render::openGround(sampleOf(level.sky(), time_h, {})));
  return a;
}

}  // namespace welkin::view
