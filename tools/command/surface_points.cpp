// SPDX-License-Identifier: Apache-2.0
#include "command/surface_points.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "command/arguments.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

using base::Error;
using base::ExitStatus;
using f64::Number3;

/// Largest file: some ten million points.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

SurfacePoint pointOf(std::string_view line, const std::string& file, std::size_t number) {
  const auto v = parseNumbers(line);
  const auto refuse = [&](const char* why) {
    return Error(ExitStatus::content, fmt::format("{}:{}: \"{}\" {}; allowed: x,y,z,nx,ny,nz, finite numbers, the "
                                                  "position in metres and a normal that is not 0",
                                                  file, number, base::oneLine(std::string(line.substr(0, 80))), why));
  };
  if (!v || v->size() != 6) throw refuse("is not a point");
  const Number3 normal((*v)[3], (*v)[4], (*v)[5]);
  const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  if (largest == 0.0) throw refuse("has no normal");
  const Number3 scaled = normal * (1.0 / largest);
  return {{(*v)[0], (*v)[1], (*v)[2]}, scaled * (1.0 / std::sqrt(dot(scaled, scaled)))};
}

}  // namespace

void PointsOption::addTo(CLI::App& command) {
  command.add_option("--position", position, "X,Y,Z in metres; it may lie on a surface");
  command.add_option("--normal", normal, "X,Y,Z of the surface");
  command.add_option("--points", file,
                     "A CSV file of points instead: x,y,z,nx,ny,nz a line; --json then gives them in its order");
}

std::vector<SurfacePoint> PointsOption::points() const {
  if (isOne()) {
    if (position.empty() || normal.empty())
      throw Error(ExitStatus::usage, fmt::format("{} is missing; give --position and --normal, or --points",
                                                 position.empty() ? "--position" : "--normal"));
    return {{parsePosition("--position", position), parseDirection("--normal", normal)}};
  }
  if (!position.empty() || !normal.empty())
    throw Error(ExitStatus::usage, "--points stands for --position and --normal: give one or the other");
  const std::vector<std::byte> bytes = base::readFile(file, kMostBytes);
  std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::vector<SurfacePoint> points;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) continue;
    points.push_back(pointOf(line, file, number));
  }
  if (points.empty()) throw Error(ExitStatus::content, fmt::format("{}: no points; allowed: at least one", file));
  return points;
}

}  // namespace welkin::command
