// SPDX-License-Identifier: Apache-2.0
#include "command/certificate_text.h"

#include <fmt/format.h>

namespace welkin::command {

using Json = nlohmann::ordered_json;

Json certificateJson(const table::Certificate& c, const std::optional<cubemap::CubemapError>& cubemaps) {
  const char* channels[] = {"red", "green", "blue"};
  Json json = {{"method", c.method == table::Certificate::Method::full ? "full" : "fast"},
               {"max_error", c.max_error},
               {"time_h", c.time_h},
               {"normal", {c.normal.x, c.normal.y, c.normal.z}},
               {"channel", channels[c.channel]},
               {"mean_error", c.mean_error},
               {"parts",
                {{"quadrature", c.parts.quadrature},
                 {"truncation", c.parts.truncation},
                 {"time", c.parts.time},
                 {"encoding", c.parts.encoding}}},
               {"instants", c.instants},
               {"reference_error", c.reference_error},
               {"dome", {{"max_error", c.dome_error}}}};
  if (cubemaps)
    json["cubemaps"] = {
        {"max_error", cubemaps->error},
        {"time_h", cubemaps->time_h},
        {"channel", channels[cubemaps->channel]},
        {"mean_error", cubemaps->mean},
        {"largest_difference",
         {{"error", cubemaps->largest.error},
          {"time_h", cubemaps->largest.time_h},
          {"direction", {cubemaps->largest.direction.x, cubemaps->largest.direction.y, cubemaps->largest.direction.z}},
          {"channel", channels[cubemaps->largest.channel]}}},
        {"parts",
         {{"resolution", cubemaps->parts.resolution},
          {"time", cubemaps->parts.time},
          {"encoding", cubemaps->parts.encoding}}}};
  return json;
}

std::string certificateText(const Json& c) {
  const auto percent = [](const Json& value) { return fmt::format("{:.3g} %", 100.0 * value.get<double>()); };
  const auto& n = c["normal"];
  std::string text = fmt::format(
      "irradiance within {} (at {:.2f} h, normal {:.3f},{:.3f},{:.3f}, {}), mean {}; quadrature {}, truncation {}, "
      "time {}, encoding {}",
      percent(c["max_error"]), c["time_h"].get<double>(), n[0].get<double>(), n[1].get<double>(), n[2].get<double>(),
      c["channel"].get<std::string>(), percent(c["mean_error"]), percent(c["parts"]["quadrature"]),
      percent(c["parts"]["truncation"]), percent(c["parts"]["time"]), percent(c["parts"]["encoding"]));
  if (c.contains("cubemaps")) text += fmt::format("; cubemaps within {}", percent(c["cubemaps"]["max_error"]));
  return text;
}

}  // namespace welkin::command
