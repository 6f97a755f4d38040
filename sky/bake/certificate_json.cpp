// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/certificate_json.h"

namespace welkin::bake {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

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

}  // namespace welkin::bake
