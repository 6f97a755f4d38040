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

namespace welkin::gltf {

/// Integers that an accessor of floats may hold. glTF 2.0, 3.6.2.2 and 3.7.2.1; KHR_mesh_quantization.
enum class Integers {
  none,           ///< floats alone
  fractions,      ///< unsigned bytes and shorts that stand for [0, 1]
  any_fractions,  ///< also signed ones that stand for [-1, 1]
  quantized       ///< none, or with KHR_mesh_quantization bytes and shorts of either kind, fractions or not
};

/// Reads accessors of one model; `file` is named in every message.
class AccessorReader {
 public:
  AccessorReader(const tinygltf::Model& model, std::string file);

  /// Reads vectors of `least` to `most` components. Sparse values are put in, and an accessor without bytes holds
  /// zeros. Numbers need not be finite. Throws Error(content).
  level::FloatRows floats(int accessor, const std::string& what, int least, int most, Integers integers) const;

  /// Whether the file uses KHR_mesh_quantization.
  bool quantized() const { return quantized_; }

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
    std::vector<unsigned char> own;  ///< of an accessor that is sparse or has no bytes
  };
  const tinygltf::Accessor& at(int accessor, const std::string& what) const;
  Elements elements(const tinygltf::Accessor& accessor, const std::string& what) const;
  Elements stored(const tinygltf::Accessor& accessor, const std::string& what) const;
  Elements zeros(const tinygltf::Accessor& accessor, const std::string& what) const;
  void putSparse(const tinygltf::Accessor& accessor, const std::string& what, Elements& into) const;

  const tinygltf::Model& model_;
  std::string file_;
  bool quantized_;
};

}  // namespace welkin::gltf
