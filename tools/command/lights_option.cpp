// SPDX-License-Identifier: Apache-2.0
#include "command/lights_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "command/arguments.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

reference::LocalLight parseLight(const std::string& text) {
  const auto refuse = [&] {
    return base::Error(
        base::ExitStatus::usage,
        fmt::format("--light: \"{}\" is not a light: X,Y,Z,R,G,B or X,Y,Z,R,G,B,RADIUS, finite numbers, the "
                    "intensity and the radius in metres at least 0",
                    text));
  };
  const auto v = parseNumbers(text);
  if (!v || v->size() < 6 || v->size() > 7) throw refuse();
  for (std::size_t i = 3; i < v->size(); ++i)
    if ((*v)[i] < 0.0) throw refuse();
  const auto& n = *v;
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n.size() == 7 ? n[6] : 0.0};
}

}  // namespace

void LightsOption::addTo(CLI::App& command, const std::string& what) {
  command.add_option("--light", text,
                     "X,Y,Z,R,G,B[,RADIUS]: a dynamic light and its radiant intensity; as many as there are. " + what);
}

std::vector<reference::LocalLight> LightsOption::lights() const {
  std::vector<reference::LocalLight> lights;
  for (const std::string& light : text) lights.push_back(parseLight(light));
  return lights;
}

void warnOfUnseen(std::size_t unseen, std::size_t lights) {
  if (unseen == 0) return;
  fmt::print(stderr,
             "welkin: warning: {} of {} lights are left out: no virtual light is within 64 m of them; [transfer] "
             "local_lights of level.toml names the sectors that have some\n",
             unseen, lights);
}

void warnOfRadii(const std::vector<reference::LocalLight>& lights) {
  const auto spheres = std::count_if(lights.begin(), lights.end(), [](const auto& l) { return l.radius_m > 0.0; });
  if (spheres > 0)
    fmt::print(stderr, "welkin: warning: the RADIUS of {} lights is left out: to probes a light is a point\n", spheres);
}

}  // namespace welkin::command
