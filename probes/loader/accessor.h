// SPDX-License-Identifier: Apache-2.0
// Reads the accessors of a glTF model and checks every count, stride, offset and type, because tinygltf checks none.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "probes/level/mesh_piece.h"

namespace welkin::loader {

/// Reads accessors of one model; `file` is named in every message.
class AccessorReader {
 public:
  AccessorReader(const tinygltf::Model& model, std::string file) : model_(model), file_(std::move(file)) {}

  /// Reads vectors of `least` to `most` components. They are floats or, where `normalised` allows, unsigned bytes and
  /// shorts that stand for [0, 1]. Numbers need not be finite. Throws Error(content).
  level::FloatRows floats(int accessor, const std::string& what, int least, int most, bool normalised) const;

  /// Reads indices, all below `vertex_count`.
  std::vector<uint32_t> indices(int accessor, const std::string& what, std::size_t vertex_count) const;

  /// The bytes of a buffer view.
  std::span<const std::byte> bytes(int buffer_view, const std::string& what) const;

  const std::string& file() const { return file_; }
  [[noreturn]] void refuse(const std::string& what, const std::string& why) const;

 private:
  /// The bytes of an accessor's elements.
  struct Elements {
    const unsigned char* first;
    std::size_t stride;
    std::size_t count;
  };
  const tinygltf::Accessor& at(int accessor, const std::string& what) const;
  Elements elements(const tinygltf::Accessor& accessor, const std::string& what) const;

  const tinygltf::Model& model_;
  std::string file_;
};

}  // namespace welkin::loader
