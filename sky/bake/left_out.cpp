// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/left_out.h"

#include <fmt/format.h>

#include "format/cubemap_format.h"

namespace welkin::bake {
namespace {

/// Directions that the quadrature of a key looks at, about; for the saving of a key that is not made.
double evaluationsOfKey(const SkyPlan& plan) {
  return plan.table.key_time_h.empty() || plan.quadrature.circles != nullptr
             ? 0.0
             : static_cast<double>(plan.table.evaluations) / static_cast<double>(plan.table.key_time_h.size());
}

}  // namespace

std::vector<LeftOut> leftOut(const SkyFile& file, const SkyPlan& plan) {
  std::vector<LeftOut> list;
  const auto& table = plan.table;
  const std::size_t keys = table.key_time_h.size();
  const std::size_t number = format::bytesOf(plan.encoding);
  const std::size_t world = static_cast<std::size_t>(table.bands * table.bands);
  const std::size_t polar = model::polarIndex(table.bands, 0);
  if (!table.modes)
    list.push_back({fmt::format("{} of {} coefficients", world - polar, world),
                    "the sky is symmetric about the sun's vertical plane, in whose frame the table is",
                    (world - polar) * keys * number * static_cast<std::size_t>(table.channels), 0.0});
  if (table.channels == 1)
    list.push_back({"two of three channels", "the gradients are grey",
                    2 * static_cast<std::size_t>(table.rows) * keys * number, 0.0});
  if (!table::hasGround(file.sky))
    list.push_back({"horizontal irradiance", "ground_albedo is black",
                    table.modes ? 0 : keys * number * static_cast<std::size_t>(table.channels), 0.0});
  if (keys == 1 && !file.bake.fixed.keys)
    list.push_back({fmt::format("{} keys", kAutoKeys - 1), "within the error the sky's shape does not change",
                    (kAutoKeys - 1) * format::bytesOfKey(plan.encoding, table.numbersOfKey()),
                    (kAutoKeys - 1) * evaluationsOfKey(plan)});
  if (!file.sky.moon) list.push_back({"moon", "there is no [moon]", 0, 0.0});
  if (!file.sky.stars) list.push_back({"stars", "there is no [stars]", 0, 0.0});
  if (plan.cubemap_time_h.empty())
    list.push_back({"cubemaps",
                    file.bake.cubemap_size == 0 ? "none are asked for"
                                                : "no surface of the level is smooth enough to reflect the sky",
                    format::bytesOfCubemaps(format::CubemapFormat::rgba16f, 128, 8),
                    8.0 * 3.0 * static_cast<double>(format::texelsOfCubemap(128))});
  return list;
}

}  // namespace welkin::bake
