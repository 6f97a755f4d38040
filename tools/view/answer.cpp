// SPDX-License-Identifier: Apache-2.0
#include "view/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace welkin::view {
namespace {

using f64::Number3;

constexpr double kGoodEnough = 0.15;  // error that few would see beside textures
constexpr double kSigmas = 3.0;       // of the truth's noise
constexpr double kLeak = 1.0;         // twice as bright as the truth
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
  if (a.contact) return "contact: something is nearer than the probes can tell; occlusion in screen space darkens that";
  if (a.verdict == Verdict::leak)
    return fmt::format(
        "light leaks: {} of 8 cells are shut out by walls, the others see light that this point does "
        "not; a room, or a probe nearby, mends it",
        shut);
  if (without > 0) return fmt::format("{} of 8 cells have no probe, so few speak for this point", without);
  return "the probes' two bands and 4 m cells are coarse here; a probe nearby helps";
}

void judge(Answer& a) {
  const double truth = f64::luminanceOf(a.truth.total.value);
  if (!a.light) {
    a.verdict = Verdict::unlit;
    a.words = "no probe serves this point: it gets no ambient light";
    return;
  }
  const Number3 got(double{a.light->irradiance[0]}, double{a.light->irradiance[1]}, double{a.light->irradiance[2]});
  if (truth > 0.0) {
    a.error = f64::luminanceOf(got) / truth - 1.0;
    a.noise = f64::luminanceOf(a.truth.total.standard_error) / truth;
  }
  if (std::abs(a.error) <= std::max(kGoodEnough, kSigmas * a.noise)) {
    a.verdict = Verdict::right;
    a.words = fmt::format("right: within {:.0f} % of the truth, whose noise is {:.1f} %", 100.0 * std::abs(a.error),
                          100.0 * a.noise);
    return;
  }
  a.verdict = a.error < 0.0 ? Verdict::too_dark : a.error > kLeak ? Verdict::leak : Verdict::too_bright;
  a.words = sideOf(a.error) + ": " + reasonOf(a);
}

}  // namespace

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
  judge(a);
  return a;
}

}  // namespace welkin::view
