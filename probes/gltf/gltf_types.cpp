// SPDX-License-Identifier: Apache-2.0
// The types and ranges of the values of glTF that are read, as a table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "probes/gltf/gltf_json.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::gltf {
namespace {

using Json = nlohmann::json;

enum class Is {
  flag,
  text,
  texts,
  whole,
  number,
  numbers,      // an array of `count` numbers, any count if that is 0
  indices,      // an array of indices
  named,        // an object of indices, as attributes are
  named_lists,  // an array of them, as morph targets are
  object,
  objects,  // an array of objects
};

constexpr double kLargestIndex = 2147483647.0;
constexpr double kLargestLength = 9007199254740991.0;  // 2^53 - 1
constexpr double kAny = 1e300;

struct Key {
  std::string_view in;    ///< the kind of object: below, or an extension
  std::string_view name;  ///< its key
  Is is;
  double low = -kAny;
  double high = kAny;
  std::size_t count = 0;       ///< of numbers
  std::string_view kind = {};  ///< of the objects that the value holds
  bool required = false;
};

constexpr Key index(std::string_view in, std::string_view name, bool required = false) {
  return {in, name, Is::whole, 0.0, kLargestIndex, 0, {}, required};
}
constexpr Key whole(std::string_view in, std::string_view name, double low, double high, bool required = false) {
  return {in, name, Is::whole, low, high, 0, {}, required};
}
constexpr Key plain(std::string_view in, std::string_view name, Is is, bool required = false) {
  return {in, name, is, -kAny, kAny, 0, {}, required};
}
constexpr Key vector(std::string_view in, std::string_view name, std::size_t count) {
  return {in, name, Is::numbers, -kAny, kAny, count, {}, false};
}
constexpr Key one(std::string_view in, std::string_view name, std::string_view kind, bool required = false) {
  return {in, name, Is::object, -kAny, kAny, 0, kind, required};
}
constexpr Key many(std::string_view in, std::string_view name, std::string_view kind, bool required = false) {
  return {in, name, Is::objects, -kAny, kAny, 0, kind, required};
}

constexpr Key kKeys[] = {
    one("glTF", "asset", "asset", true),
    index("glTF", "scene"),
    many("glTF", "scenes", "scene"),
    many("glTF", "nodes", "node"),
    many("glTF", "meshes", "mesh"),
    many("glTF", "accessors", "accessor"),
    many("glTF", "bufferViews", "bufferView"),
    many("glTF", "buffers", "buffer"),
    many("glTF", "materials", "material"),
    many("glTF", "textures", "texture"),
    many("glTF", "images", "image"),
    many("glTF", "samplers", "sampler"),
    many("glTF", "skins", "any"),
    many("glTF", "cameras", "any"),
    many("glTF", "animations", "any"),
    plain("glTF", "extensionsUsed", Is::texts),
    plain("glTF", "extensionsRequired", Is::texts),
    plain("asset", "version", Is::text, true),
    plain("asset", "minVersion", Is::text),
    plain("scene", "nodes", Is::indices),
    plain("scene", "name", Is::text),
    plain("node", "name", Is::text),
    index("node", "mesh"),
    index("node", "skin"),
    index("node", "camera"),
    plain("node", "children", Is::indices),
    vector("node", "matrix", 16),
    vector("node", "translation", 3),
    vector("node", "rotation", 4),
    vector("node", "scale", 3),
    vector("node", "weights", 0),
    plain("mesh", "name", Is::text),
    many("mesh", "primitives", "primitive", true),
    vector("mesh", "weights", 0),
    plain("primitive", "attributes", Is::named, true),
    index("primitive", "indices"),
    index("primitive", "material"),
    whole("primitive", "mode", 0, 6),
    plain("primitive", "targets", Is::named_lists),
    plain("accessor", "name", Is::text),
    index("accessor", "bufferView"),
    whole("accessor", "byteOffset", 0, kLargestLength),
    whole("accessor", "componentType", 5120, 5126, true),
    whole("accessor", "count", 1, kLargestLength, true),
    plain("accessor", "type", Is::text, true),
    plain("accessor", "normalized", Is::flag),
    one("accessor", "sparse", "sparse"),
    whole("sparse", "count", 1, kLargestLength, true),
    one("sparse", "indices", "sparse indices", true),
    one("sparse", "values", "sparse values", true),
    index("sparse indices", "bufferView", true),
    whole("sparse indices", "byteOffset", 0, kLargestLength),
    whole("sparse indices", "componentType", 5121, 5125, true),
    index("sparse values", "bufferView", true),
    whole("sparse values", "byteOffset", 0, kLargestLength),
    plain("bufferView", "name", Is::text),
    index("bufferView", "buffer", true),
    whole("bufferView", "byteOffset", 0, kLargestLength),
    whole("bufferView", "byteLength", 0, kLargestLength, true),
    whole("bufferView", "byteStride", 0, 252),
    plain("buffer", "name", Is::text),
    plain("buffer", "uri", Is::text),
    whole("buffer", "byteLength", 0, kLargestLength, true),
    plain("material", "name", Is::text),
    one("material", "pbrMetallicRoughness", "pbrMetallicRoughness"),
    one("material", "normalTexture", "textureInfo"),
    one("material", "occlusionTexture", "textureInfo"),
    one("material", "emissiveTexture", "textureInfo"),
    vector("material", "emissiveFactor", 3),
    plain("material", "alphaMode", Is::text),
    plain("material", "alphaCutoff", Is::number),
    plain("material", "doubleSided", Is::flag),
    vector("pbrMetallicRoughness", "baseColorFactor", 4),
    one("pbrMetallicRoughness", "baseColorTexture", "textureInfo"),
    one("pbrMetallicRoughness", "metallicRoughnessTexture", "textureInfo"),
    {"pbrMetallicRoughness", "metallicFactor", Is::number, 0.0, 1.0},
    {"pbrMetallicRoughness", "roughnessFactor", Is::number, 0.0, 1.0},
    index("textureInfo", "index", true),
    index("textureInfo", "texCoord"),
    plain("texture", "name", Is::text),
    index("texture", "source"),
    index("texture", "sampler"),
    plain("image", "name", Is::text),
    plain("image", "uri", Is::text),
    plain("image", "mimeType", Is::text),
    index("image", "bufferView"),
    whole("sampler", "wrapS", 0, kLargestIndex),
    whole("sampler", "wrapT", 0, kLargestIndex),
    many("KHR_lights_punctual", "lights", "light"),
    index("KHR_lights_punctual", "light"),
    plain("light", "name", Is::text),
    plain("light", "type", Is::text, true),
    vector("light", "color", 3),
    plain("light", "intensity", Is::number),
    {"light", "range", Is::number, 0.0},
    one("light", "spot", "spot"),
    plain("spot", "innerConeAngle", Is::number),
    plain("spot", "outerConeAngle", Is::number),
    vector("KHR_texture_transform", "offset", 2),
    vector("KHR_texture_transform", "scale", 2),
    plain("KHR_texture_transform", "rotation", Is::number),
    index("KHR_texture_transform", "texCoord"),
    {"KHR_materials_emissive_strength", "emissiveStrength", Is::number, 0.0},
    {"KHR_materials_transmission", "transmissionFactor", Is::number, 0.0, 1.0},
    one("KHR_materials_transmission", "transmissionTexture", "textureInfo"),
    index("EXT_texture_webp", "source"),
    index("KHR_texture_basisu", "source"),
    index("MSFT_texture_dds", "source"),
    index("EXT_texture_avif", "source"),
    plain("KHR_node_visibility", "visible", Is::flag),
    plain("EXT_mesh_gpu_instancing", "attributes", Is::named, true),
    plain("EXT_meshopt_compression", "fallback", Is::flag),
    index("EXT_meshopt_compression", "buffer"),
    whole("EXT_meshopt_compression", "byteOffset", 0, kLargestLength),
    whole("EXT_meshopt_compression", "byteLength", 1, kLargestLength),
    whole("EXT_meshopt_compression", "byteStride", 1, 256),
    whole("EXT_meshopt_compression", "count", 1, kLargestIndex),
    plain("EXT_meshopt_compression", "mode", Is::text),
    plain("EXT_meshopt_compression", "filter", Is::text),
    index("KHR_draco_mesh_compression", "bufferView", true),
    plain("KHR_draco_mesh_compression", "attributes", Is::named, true),
};

std::string allowed(const Key& key) {
  const auto range = [&](const std::string& what) {
    if (key.low == -kAny) return what;
    if (key.high == kAny) return fmt::format("{} of {} or more", what, key.low);
    return fmt::format("{} of {:.0f} to {:.0f}", what, key.low, key.high);
  };
  switch (key.is) {
    case Is::flag:
      return "true or false";
    case Is::text:
      return "a string";
    case Is::texts:
      return "an array of strings";
    case Is::whole:
      return range("a whole number");
    case Is::number:
      return range("a number");
    case Is::numbers:
      return key.count > 0 ? fmt::format("an array of {} numbers", key.count) : "an array of numbers";
    case Is::indices:
      return "an array of indices";
    case Is::named:
      return "an object of indices";
    case Is::named_lists:
      return "an array of objects of indices";
    case Is::object:
      return "an object";
    case Is::objects:
      return "an array of objects";
  }
  return {};
}

/// Whether the value is a whole number in the range; makes an integer of one such as 1.0.
bool isWhole(Json& value, double low, double high) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  if (!(number >= low && number <= high && number == std::floor(number))) return false;
  if (value.is_number_float()) value = static_cast<std::int64_t>(number);
  return true;
}

bool isIndex(Json& value) {
  return isWhole(value, 0.0, kLargestIndex);
}

template <typename Check>
bool isListOf(Json& value, Check check) {
  return value.is_array() && std::all_of(value.begin(), value.end(), check);
}

bool areNamed(Json& value) {
  return value.is_object() && std::all_of(value.begin(), value.end(), isIndex);
}

bool fits(const Key& key, Json& value) {
  switch (key.is) {
    case Is::flag:
      return value.is_boolean();
    case Is::text:
      return value.is_string();
    case Is::texts:
      return isListOf(value, [](const Json& v) { return v.is_string(); });
    case Is::whole:
      return isWhole(value, key.low, key.high);
    case Is::number:
      return value.is_number() && value.get<double>() >= key.low && value.get<double>() <= key.high;
    case Is::numbers:
      return isListOf(value, [](const Json& v) { return v.is_number(); }) &&
             (key.count == 0 || value.size() == key.count);
    case Is::indices:
      return isListOf(value, isIndex);
    case Is::named:
      return areNamed(value);
    case Is::named_lists:
      return isListOf(value, areNamed);
    case Is::object:
      return value.is_object();
    case Is::objects:
      return isListOf(value, [](const Json& v) { return v.is_object(); });
  }
  return false;
}

class TypeCheck {
 public:
  explicit TypeCheck(const std::string& file) : file_(file) {}

  /// Checks an object; `at` is its place, such as "nodes[3].". The depth of the JSON bounds the recursion.
  void object(Json& value, std::string_view kind, const std::string& at) const {
    for (const Key& key : kKeys)
      if (key.in == kind) one(value, key, at);
    if (kind == "light" && value["type"] == "spot" && !value.contains("spot")) fail(at + "spot is missing");
    const auto extensions = value.find("extensions");
    if (extensions == value.end()) return;
    if (!extensions->is_object()) refuse(at + "extensions", *extensions, "an object");
    for (auto& [name, extension] : extensions->items()) {
      const std::string place = fmt::format("{}extensions.{}", at, name);
      if (!extension.is_object()) refuse(place, extension, "an object");
      object(extension, name, place + ".");
    }
  }

 private:
  void one(Json& object_of, const Key& key, const std::string& at) const {
    const std::string place = at + std::string(key.name);
    const auto found = object_of.find(key.name);
    if (found == object_of.end()) {
      if (key.required) fail(place + " is missing");
      return;
    }
    if (!fits(key, *found)) refuse(place, *found, allowed(key));
    if (key.is == Is::object) object(*found, key.kind, place + ".");
    if (key.is == Is::objects)
      for (std::size_t i = 0; i < found->size(); ++i) object((*found)[i], key.kind, fmt::format("{}[{}].", place, i));
  }

  [[noreturn]] void refuse(const std::string& place, const Json& value, const std::string& allowed_values) const {
    constexpr std::size_t kLongest = 60;
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    fail(fmt::format("{} = {}: must be {}", place, base::shortened(text, kLongest), allowed_values));
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw base::Error(base::ExitStatus::content, base::oneLine(fmt::format("{}: {}", file_, why)));
  }

  const std::string& file_;
};

}  // namespace

void checkGltfTypes(Json& gltf, const std::string& file) {
  TypeCheck(file).object(gltf, "glTF", "");
}

}  // namespace welkin::gltf
