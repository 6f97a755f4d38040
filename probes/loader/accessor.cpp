// SPDX-License-Identifier: Apache-2.0
// Checked access to a glTF model's buffers. glTF 2.0 specification, 3.6.2.
#include "probes/loader/accessor.h"

#include <fmt/format.h>

#include <cstring>

#include "sky/base/error.h"

namespace welkin::loader {
namespace {

std::size_t componentBytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

/// Number of components; 0 for matrices and for unknown types.
int componentCount(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    default:
      return 0;
  }
}

template <typename T>
T load(const unsigned char* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

float component(const unsigned char* from, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return static_cast<float>(*from) / 255.0F;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return static_cast<float>(load<uint16_t>(from)) / 65535.0F;
  return load<float>(from);
}

uint32_t index(const unsigned char* from, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *from;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<uint16_t>(from);
  return load<uint32_t>(from);
}

}  // namespace

void AccessorReader::refuse(const std::string& what, const std::string& why) const {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}: {}", file_, what, why));
}

const tinygltf::Accessor& AccessorReader::at(int accessor, const std::string& what) const {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size())
    refuse(what, fmt::format("accessor {} is none of the {}", accessor, model_.accessors.size()));
  return model_.accessors[static_cast<std::size_t>(accessor)];
}

std::span<const std::byte> AccessorReader::bytes(int view_index, const std::string& what) const {
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size())
    refuse(what, fmt::format("bufferView {} is none of the {}", view_index, model_.bufferViews.size()));
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size())
    refuse(what, fmt::format("buffer {} is none of the {}", view.buffer, model_.buffers.size()));
  const std::vector<unsigned char>& bytes = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
    refuse(what, fmt::format("bufferView {}: {} bytes from byte {} of a buffer of {}", view_index, view.byteLength,
                             view.byteOffset, bytes.size()));
  return std::as_bytes(std::span(bytes)).subspan(view.byteOffset, view.byteLength);
}

AccessorReader::Elements AccessorReader::elements(const tinygltf::Accessor& accessor, const std::string& what) const {
  if (accessor.sparse.isSparse) refuse(what, "sparse accessors are not supported");
  const std::span<const std::byte> view_bytes = bytes(accessor.bufferView, what);
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  const std::size_t one = componentBytes(accessor.componentType);
  const std::size_t element = one * static_cast<std::size_t>(componentCount(accessor.type));
  const std::size_t stride = view.byteStride == 0 ? element : view.byteStride;
  if (element == 0) refuse(what, "its type is not one that glTF has");
  if (stride < element || stride > 252 || stride % one != 0)
    refuse(what, fmt::format("a byteStride of {} for elements of {} bytes", stride, element));
  if ((accessor.byteOffset + view.byteOffset) % one != 0)
    refuse(what, fmt::format("byte {} is not aligned to {}", accessor.byteOffset + view.byteOffset, one));
  const std::size_t count = accessor.count;
  const bool fits = accessor.byteOffset <= view.byteLength && element <= view.byteLength - accessor.byteOffset &&
                    count <= (view.byteLength - accessor.byteOffset - element) / stride + 1;
  if (count == 0 || !fits)
    refuse(what, fmt::format("{} elements of {} bytes, stride {}, from byte {} of a bufferView of {}", count, element,
                             stride, accessor.byteOffset, view.byteLength));
  return {reinterpret_cast<const unsigned char*>(view_bytes.data()) + accessor.byteOffset, stride, count};
}

level::FloatRows AccessorReader::floats(int accessor, const std::string& what, int least, int most,
                                        bool normalised) const {
  const tinygltf::Accessor& a = at(accessor, what);
  const int components = componentCount(a.type);
  if (components < least || components > most)
    refuse(what, fmt::format("{} components, must be {} to {}", components, least, most));
  const bool is_float = a.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  const bool is_fraction = a.normalized && (a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                            a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
  if (!is_float && !(normalised && is_fraction))
    refuse(what, fmt::format("componentType {}{}: must be float{}", a.componentType, a.normalized ? ", normalized" : "",
                             normalised ? ", or normalized unsigned byte or short" : ""));
  const Elements e = elements(a, what);
  level::FloatRows rows{e.count, components, {}};
  rows.values.reserve(e.count * static_cast<std::size_t>(components));
  const std::size_t one = componentBytes(a.componentType);
  for (std::size_t i = 0; i < e.count; ++i)
    for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
      rows.values.push_back(component(e.first + i * e.stride + c * one, a.componentType));
  return rows;
}

std::vector<uint32_t> AccessorReader::indices(int accessor, const std::string& what, std::size_t vertex_count) const {
  const tinygltf::Accessor& a = at(accessor, what);
  if (a.type != TINYGLTF_TYPE_SCALAR || (a.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
                                         a.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
                                         a.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT))
    refuse(what, "indices must be scalars, unsigned byte, short or int");
  const Elements e = elements(a, what);
  std::vector<uint32_t> values;
  values.reserve(e.count);
  for (std::size_t i = 0; i < e.count; ++i) {
    values.push_back(index(e.first + i * e.stride, a.componentType));
    if (values.back() >= vertex_count)
      refuse(what, fmt::format("index {} is {}, and there are {} vertices", i, values.back(), vertex_count));
  }
  return values;
}

}  // namespace welkin::loader
