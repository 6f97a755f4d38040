// SPDX-License-Identifier: Apache-2.0
// Checked access to a glTF model's buffers. glTF 2.0 specification, 3.6.2.
#include "probes/gltf/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "sky/base/error.h"

namespace welkin::gltf {
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

/// A component as a float; a fraction is a part of the type's largest value. glTF 2.0, 3.11.
float component(const unsigned char* from, int type, bool fraction) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const auto value = static_cast<float>(load<int8_t>(from));
      return fraction ? std::max(value / 127.0F, -1.0F) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return static_cast<float>(*from) / (fraction ? 255.0F : 1.0F);
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const auto value = static_cast<float>(load<int16_t>(from));
      return fraction ? std::max(value / 32767.0F, -1.0F) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return static_cast<float>(load<uint16_t>(from)) / (fraction ? 65535.0F : 1.0F);
    default:
      return load<float>(from);
  }
}

uint32_t index(const unsigned char* from, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *from;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<uint16_t>(from);
  return load<uint32_t>(from);
}

/// The kinds that floats() allows, for its message.
const char* allowedOf(Integers integers, bool quantized) {
  if (integers == Integers::fractions) return "float, or normalized unsigned byte or short";
  if (integers == Integers::any_fractions) return "float, or normalized byte or short";
  if (integers == Integers::quantized && quantized) return "float, byte or short";
  return "float";
}

bool isAllowed(const tinygltf::Accessor& accessor, Integers integers, bool quantized) {
  const int type = accessor.componentType;
  if (type == TINYGLTF_COMPONENT_TYPE_FLOAT) return true;
  const bool is_unsigned =
      type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  const bool is_signed = type == TINYGLTF_COMPONENT_TYPE_BYTE || type == TINYGLTF_COMPONENT_TYPE_SHORT;
  switch (integers) {
    case Integers::none:
      return false;
    case Integers::fractions:
      return is_unsigned && accessor.normalized;
    case Integers::any_fractions:
      return (is_unsigned || is_signed) && accessor.normalized;
    case Integers::quantized:
      return (is_unsigned || is_signed) && quantized;
  }
  return false;
}

constexpr const char* kQuantization = "KHR_mesh_quantization";

}  // namespace

AccessorReader::AccessorReader(const tinygltf::Model& model, std::string file)
    : model_(model), file_(std::move(file)), quantized_(false) {
  for (const auto* list : {&model.extensionsUsed, &model.extensionsRequired})
    quantized_ = quantized_ || std::find(list->begin(), list->end(), kQuantization) != list->end();
}

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
  Elements found = accessor.bufferView < 0 ? zeros(accessor, what) : stored(accessor, what);
  if (accessor.sparse.isSparse) putSparse(accessor, what, found);
  return found;
}

AccessorReader::Elements AccessorReader::zeros(const tinygltf::Accessor& accessor, const std::string& what) const {
  constexpr std::size_t kMost = std::size_t{1} << 24;
  const std::size_t element =
      componentBytes(accessor.componentType) * static_cast<std::size_t>(componentCount(accessor.type));
  if (element == 0) refuse(what, "its type is not one that glTF has");
  if (accessor.count > kMost)
    refuse(what, fmt::format("{} elements without a bufferView: at most {} are allowed", accessor.count, kMost));
  Elements result{nullptr, element, accessor.count, std::vector<unsigned char>(element * accessor.count)};
  result.first = result.own.data();
  return result;
}

/// glTF 2.0, 3.6.2.3.
void AccessorReader::putSparse(const tinygltf::Accessor& accessor, const std::string& what, Elements& into) const {
  const auto& sparse = accessor.sparse;
  const std::size_t element =
      componentBytes(accessor.componentType) * static_cast<std::size_t>(componentCount(accessor.type));
  tinygltf::Accessor places;
  places.bufferView = sparse.indices.bufferView;
  places.byteOffset = static_cast<std::size_t>(sparse.indices.byteOffset);
  places.componentType = sparse.indices.componentType;
  places.type = TINYGLTF_TYPE_SCALAR;
  tinygltf::Accessor values = accessor;
  values.bufferView = sparse.values.bufferView;
  values.byteOffset = static_cast<std::size_t>(sparse.values.byteOffset);
  places.count = values.count = static_cast<std::size_t>(sparse.count);
  if (places.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
      places.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      places.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    refuse(what, "sparse indices must be unsigned byte, short or int");
  const Elements at = stored(places, what + " sparse indices");
  const Elements from = stored(values, what + " sparse values");
  if (into.own.empty()) {
    std::vector<unsigned char> dense(element * into.count);
    for (std::size_t i = 0; i < into.count; ++i)
      std::memcpy(dense.data() + i * element, into.first + i * into.stride, element);
    into = {nullptr, element, into.count, std::move(dense)};
    into.first = into.own.data();
  }
  for (std::size_t i = 0, least = 0; i < at.count; ++i) {
    const std::size_t place = index(at.first + i * at.stride, places.componentType);
    if (place >= into.count)
      refuse(what, fmt::format("sparse index {} is {}, and there are {} elements", i, place, into.count));
    if (place < least)
      refuse(what, fmt::format("sparse index {} is {}, and must be larger than the one before it", i, place));
    least = place + 1;
    std::memcpy(into.own.data() + place * element, from.first + i * from.stride, element);
  }
}

AccessorReader::Elements AccessorReader::stored(const tinygltf::Accessor& accessor, const std::string& what) const {
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
  return {reinterpret_cast<const unsigned char*>(view_bytes.data()) + accessor.byteOffset, stride, count, {}};
}

level::FloatRows AccessorReader::floats(int accessor, const std::string& what, int least, int most,
                                        Integers integers) const {
  const tinygltf::Accessor& a = at(accessor, what);
  const int components = componentCount(a.type);
  if (components < least || components > most)
    refuse(what, fmt::format("{} components, must be {} to {}", components, least, most));
  if (!isAllowed(a, integers, quantized_))
    refuse(what, fmt::format("componentType {}{}: must be {}", a.componentType, a.normalized ? ", normalized" : "",
                             allowedOf(integers, quantized_)));
  const Elements e = elements(a, what);
  level::FloatRows rows{e.count, components, {}};
  rows.values.reserve(e.count * static_cast<std::size_t>(components));
  const std::size_t one = componentBytes(a.componentType);
  for (std::size_t i = 0; i < e.count; ++i)
    for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
      rows.values.push_back(component(e.first + i * e.stride + c * one, a.componentType, a.normalized));
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

}  // namespace welkin::gltf
