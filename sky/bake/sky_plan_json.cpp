// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/sky_plan_json.h"

#include <fmt/format.h>

#include "sky/bake/warnings.h"

namespace welkin::bake {
namespace {

using Json = nlohmann::ordered_json;

/// The source of a table's moments, in words.
std::string textOf(const model::Quadrature& quadrature) {
  if (quadrature.circles == nullptr) return fmt::format("coefficients within {:.0e} of c0", quadrature.tolerance);
  return fmt::format("circles in {} panels or more, within {:.1e} of the mean", quadrature.circles->panels,
                     quadrature.circles->error);
}

Json tableJson(const SkyPlan& plan, const std::optional<double>& max_error) {
  Json considered = Json::array();
  for (const table::PlanChoice& c : plan.considered) {
    considered.push_back({{"name", c.name}, {"error_at_keys", c.error}});
    if (c.keys > 0) considered.back()["keys"] = c.keys, considered.back()["bytes"] = c.bytes;
  }
  const auto& modes = plan.table.modes;
  Json json = {{"name", plan.representation.name()},
               {"bands", plan.table.bands},
               {"coefficients", plan.table.bands * plan.table.bands},
               {"reconstruction", nameOf(plan.representation.reconstruction)},
               {"numbers_of_key", plan.table.numbersOfKey()},
               {"channels", plan.table.channels},
               {"encoding", nameOf(plan.encoding)},
               {"keys", plan.table.key_time_h.size()}};
  if (modes) json["modes"] = {{"count", modes->count}, {"columns", modes->columns}, {"rows", modes->rows}};
  if (plan.window_strength > 0.0) json["window_strength"] = plan.window_strength;
  json["quadrature"] = textOf(plan.quadrature);
  json["evaluations"] = plan.table.evaluations;
  json["bytes"] = plan.table_bytes;
  if (max_error) {
    json["max_error"] = *max_error;
    json["predicted_error"] = plan.predicted_error;
    json["considered"] = considered;
  }
  return json;
}

Json leftOutJson(const SkyPlan& plan) {
  Json list = Json::array();
  for (const LeftOut& l : plan.left_out)
    list.push_back({{"what", l.what}, {"why", l.why}, {"bytes", l.bytes}, {"evaluations", l.evaluations}});
  return list;
}

}  // namespace

Json planJson(const SkyPlan& plan, const std::optional<double>& max_error) {
  Json cubemaps = {{"count", plan.cubemap_time_h.size()},
                   {"size", plan.cubemap_size},
                   {"format", format::nameOf(plan.cubemap_format)},
                   {"time_h", plan.cubemap_time_h},
                   {"bytes", plan.cubemap_bytes}};
  if (plan.cubemap_error) cubemaps["predicted_error"] = *plan.cubemap_error;
  return {{"table", tableJson(plan, max_error)},
          {"cubemaps", std::move(cubemaps)},
          {"gradients",
           {{"format", nameOf(plan.gradient_format)}, {"bytes", plan.gradient_bytes}, {"dome_error", plan.dome_error}}},
          {"left_out", leftOutJson(plan)},
          {"warnings", warningsJson(plan.warnings)}};
}

}  // namespace welkin::bake
