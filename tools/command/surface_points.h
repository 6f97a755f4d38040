// SPDX-License-Identifier: Apache-2.0
// The points of a command: one by --position and --normal, or a file of them by --points.
#pragma once

#include <string>
#include <vector>

#include "baked/level_folder.h"

namespace CLI {
class App;
}

namespace welkin::command {

using baked::SurfacePoint;

/// --position, --normal and --points.
struct PointsOption {
  std::string position, normal, file;

  void addTo(CLI::App& command);
  bool isOne() const { return file.empty(); }
  /// The points, at least one. Throws Error(usage) where the options are not one point or one file, Error(file) for a
  /// file that cannot be read, Error(content) with its line where it is not "x,y,z,nx,ny,nz".
  std::vector<SurfacePoint> points() const;
};

}  // namespace welkin::command
