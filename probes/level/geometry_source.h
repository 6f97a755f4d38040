// SPDX-License-Identifier: Apache-2.0
// A geometry file of any kind. It is read once and placed by any number of entries of level.toml.
#pragma once

#include <filesystem>
#include <memory>

#include "probes/level/level_file.h"
#include "probes/level/scene_builder.h"

namespace welkin::level {

class GeometrySource {
 public:
  GeometrySource() = default;
  GeometrySource(const GeometrySource&) = delete;
  GeometrySource& operator=(const GeometrySource&) = delete;
  virtual ~GeometrySource() = default;

  /// Places everything in the file as the entry says. Throws Error, naming the file and the part of it.
  virtual void place(const GeometryEntry& entry) = 0;
};

}  // namespace welkin::level
