// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_value.h"

#include <fmt/format.h>

#include <cmath>

namespace welkin::gltf {
namespace {

double checked(const tinygltf::Value& value, const AccessorReader& reader, const std::string& what,
               const std::string& key) {
  constexpr double kLargest = 1e9;
  if (!value.IsNumber()) reader.refuse(what, key + " must hold numbers");
  const double number = value.GetNumberAsDouble();
  if (!(std::abs(number) <= kLargest)) reader.refuse(what, fmt::format("{} holds {}", key, number));
  return number;
}

}  // namespace

tinygltf::Value extensionOf(const tinygltf::ExtensionMap& extensions, const std::string& name) {
  const auto found = extensions.find(name);
  return found == extensions.end() || !found->second.IsObject() ? tinygltf::Value(tinygltf::Value::Object())
                                                                : found->second;
}

double numberIn(const tinygltf::Value& object, const std::string& key, double otherwise, const AccessorReader& reader,
                const std::string& what) {
  return object.Has(key) ? checked(object.Get(key), reader, what, key) : otherwise;
}

double elementIn(const tinygltf::Value& object, const std::string& key, int i, int size, double otherwise,
                 const AccessorReader& reader, const std::string& what) {
  if (!object.Has(key)) return otherwise;
  const tinygltf::Value& array = object.Get(key);
  if (!array.IsArray() || array.ArrayLen() != static_cast<std::size_t>(size))
    reader.refuse(what, fmt::format("{} must have {} numbers", key, size));
  return checked(array.Get(i), reader, what, key);
}

int indexIn(const tinygltf::Value& object, const std::string& key, std::size_t count, const AccessorReader& reader,
            const std::string& what) {
  if (!object.Has(key)) return -1;
  const double number = checked(object.Get(key), reader, what, key);
  if (!(number >= 0.0 && number < static_cast<double>(count) && number == std::floor(number)))
    reader.refuse(what, fmt::format("{} {} is none of the {}", key, number, count));
  return static_cast<int>(number);
}

}  // namespace welkin::gltf
