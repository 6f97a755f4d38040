// SPDX-License-Identifier: Apache-2.0
// "What lights this point?": the cells about it, their probes, the light that they give, and the truth.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "format/cut_lookup.h"
#include "probes/reference/reference.h"
#include "view/level.h"

namespace welkin::view {

/// One of the eight cells about a point.
struct CellOfPoint {
  geometry::Box box;    ///< metres
  double weight = 0.0;  ///< trilinear
  double share = 0.0;   ///< of the light, the shares of all cells add up to 1; 0 if it does not light the point
  std::string part;     ///< "lights", or why not
  std::optional<ProbeName> probe;
};

enum class Verdict {
  unlit,      ///< no probe serves the point
  right,      ///< within the tolerance of the truth, or its noise
  leak,       ///< far too bright, or bright where the truth is dark
  too_dark,   ///< too dark
  too_bright  ///< too bright where light does come
};
inline constexpr const char* kVerdicts[] = {"unlit", "right", "leak", "too dark", "too bright"};

struct Answer {
  baked::SurfacePoint point;
  std::optional<baked::PointLight> light;  ///< as `welkin sample` gives it, by the runtime
  std::array<CellOfPoint, 8> cells{};
  std::size_t cell_count = 0;
  reference::ReferenceIrradiance truth;  ///< as `welkin reference` gives it
  f64::Number3 expected{0.0};            ///< the truth with the factors of [scale], as the light has them
  double error = 0.0;                    ///< luminance of light minus expected, over expected or the floor; 0 unlit
  double noise = 0.0;                    ///< standard error of the expected luminance, over the same
  double nearest_probe_m = 0.0;          ///< of those that light the point
  bool contact = false;                  ///< other static geometry is within half a metre above the point
  Verdict verdict = Verdict::unlit;
  std::string words;  ///< the verdict for a person
};

/// The cells about a surface point and their shares, by the look-up of the runtime and the reference. Returns how many
/// there are: 8, or 0 beyond all sectors.
std::size_t cellsAbout(const Level& level, const baked::SurfacePoint& point, std::array<CellOfPoint, 8>& cells);

/// Fills in what follows from light and truth: expected, error, noise, verdict and words. `open_ground` is the
/// luminance of open ground's irradiance, >= 0. Differences below a thousandth of it, the floor, are right.
void judge(Answer& answer, const transfer::RelightScale& scale, double open_ground);

/// Traces `paths` paths. Throws what the progress throws.
Answer answerAt(Level& level, const baked::SurfacePoint& point, double time_h, std::size_t paths,
                const base::Progress& progress = {});

}  // namespace welkin::view
