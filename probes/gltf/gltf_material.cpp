// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "probes/gltf/gltf_value.h"
#include "sh/deterministic.h"
#include "sky/base/error.h"
#include "sky/image/coded_image.h"
#include "sky/image/dds_header.h"

namespace welkin::gltf {
namespace {

using f64::Number3;
using geometry::UvRows;

/// The matrix of KHR_texture_transform: scale, rotation, offset. With u right and v down, the rotation turns u towards
/// -v.
UvRows readTransform(const tinygltf::Value& t, const AccessorReader& reader, const std::string& what) {
  const double angle_rad = numberIn(t, "rotation", 0.0, reader, what);
  const double c = det::cos(angle_rad);
  const double s = det::sin(angle_rad);
  const auto scale = [&](int i) { return elementIn(t, "scale", i, 2, 1.0, reader, what); };
  const auto offset = [&](int i) { return elementIn(t, "offset", i, 2, 0.0, reader, what); };
  return {{{c * scale(0), s * scale(1), offset(0)}, {-s * scale(0), c * scale(1), offset(1)}}};
}

/// Whether an image is of a format that is read, or says so, and is then damaged.
bool isTexture(const tinygltf::Image& image, const level::TextureSource& source) {
  if (image::isTexture(source.name, source.bytes)) return true;
  if (image::isDds(source.bytes)) return false;  // whole, but of pixels that are not read
  std::string says = image.mimeType + " " + image.uri;
  std::transform(says.begin(), says.end(), says.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr const char* kKinds[] = {
      "image/png", "image/jpeg", "image/webp", "image/vnd-ms.dds", ".png", ".jpg", ".jpeg", ".webp", ".bmp", ".dds"};
  return std::any_of(std::begin(kKinds), std::end(kKinds),
                     [&](const char* kind) { return says.find(kind) != std::string::npos; });
}

}  // namespace

const GltfMaterial& GltfMaterials::at(int index, const std::string& what) {
  if (index < 0 || static_cast<std::size_t>(index) >= model_.materials.size())
    reader_.refuse(what, fmt::format("material {} is none of the {}", index, model_.materials.size()));
  if (const auto found = materials_.find(index); found != materials_.end()) return found->second;
  const tinygltf::Material& material = model_.materials[static_cast<std::size_t>(index)];
  return materials_
      .emplace(index, read(material, fmt::format("material {} \"{}\"", index, material.name.substr(0, 60))))
      .first->second;
}

GltfMaterial GltfMaterials::withoutTexture(int index) {
  if (const auto found = without_texture_.find(index); found != without_texture_.end()) return found->second;
  level::SceneMaterial copy = builder_.scene().materials[materials_.at(index).material];
  copy.surface.texture = -1;
  copy.surface.emission_texture = -1;
  return without_texture_.emplace(index, GltfMaterial{builder_.addMaterial(std::move(copy)), -1}).first->second;
}

GltfMaterial GltfMaterials::read(const tinygltf::Material& material, const std::string& name) {
  const auto& pbr = material.pbrMetallicRoughness;
  level::SceneMaterial result;
  geometry::Material& surface = result.surface;
  if (pbr.baseColorFactor.size() != 4) reader_.refuse(name, "baseColorFactor must have 4 numbers");
  for (const double f : pbr.baseColorFactor)
    if (!(f >= 0.0 && f <= 1.0)) reader_.refuse(name, fmt::format("baseColorFactor holds {}, must be 0 to 1", f));
  surface.albedo = Number3(pbr.baseColorFactor[0], pbr.baseColorFactor[1], pbr.baseColorFactor[2]);
  surface.alpha = pbr.baseColorFactor[3];
  surface.double_sided = material.doubleSided;
  readMetal(material, result);
  GltfMaterial placed;
  if (pbr.baseColorTexture.index >= 0) {
    const auto& info = pbr.baseColorTexture;
    const Use use = readUse(info.index, info.texCoord, extensionOf(info.extensions, "KHR_texture_transform"),
                            name + " baseColorTexture");
    surface.texture = use.texture;
    surface.uv_row = use.uv_row;
    if (use.texture >= 0)
      placed.uv_set = use.uv_set;
    else
      builder_.scene().warnings.back() += ": the factor of the material stands in";
  }
  readAlpha(material, name, surface);
  readTransmission(material, name, result);
  readEmission(material, name, placed.uv_set, result);
  placed.material = builder_.addMaterial(std::move(result));
  return placed;
}

GltfMaterials::Use GltfMaterials::readUse(int index, int uv_set, const tinygltf::Value& transform,
                                          const std::string& what) {
  constexpr std::size_t kMostSets = 64;
  const int other_set = indexIn(transform, "texCoord", kMostSets, reader_, what);
  const Use use{readTexture(index, what), other_set >= 0 ? other_set : uv_set, readTransform(transform, reader_, what)};
  if (use.uv_set < 0) reader_.refuse(what, fmt::format("texCoord {} is negative", use.uv_set));
  return use;
}

void GltfMaterials::readMetal(const tinygltf::Material& material, level::SceneMaterial& into) {
  const auto& pbr = material.pbrMetallicRoughness;
  into.roughness = pbr.roughnessFactor;
  const int index = pbr.metallicRoughnessTexture.index;
  // Its defaults speak of a metal, and materials of other models have nothing else.
  if (material.extensions.count("KHR_materials_pbrSpecularGlossiness") > 0) return;
  if (index < 0) {
    into.metallic = pbr.metallicFactor;
    return;
  }
  into.mean_metal_texture = readMetalTexture(index);
  if (into.mean_metal_texture >= 0) into.metallic = pbr.metallicFactor;
}

int GltfMaterials::readMetalTexture(int index) {
  if (static_cast<std::size_t>(index) >= model_.textures.size()) return -1;
  const int image = model_.textures[static_cast<std::size_t>(index)].source;
  if (image < 0 || static_cast<std::size_t>(image) >= model_.images.size()) return -1;
  const auto [known, is_new] = metal_textures_.emplace(image, -1);
  if (!is_new) return known->second;
  const tinygltf::Image& held = model_.images[static_cast<std::size_t>(image)];
  if (held.bufferView < 0 && held.image.empty()) return -1;
  level::TextureSource source;
  try {
    source = readImage(image, "metallicRoughnessTexture");
  } catch (const base::Error&) {
    return -1;  // no bake needs it
  }
  if (!isTexture(held, source)) return -1;
  std::vector<level::TextureSource>& list = builder_.scene().metal_textures;
  list.push_back(std::move(source));
  return known->second = static_cast<int>(list.size()) - 1;
}

void GltfMaterials::readAlpha(const tinygltf::Material& material, const std::string& name,
                              geometry::Material& surface) {
  constexpr double kBlendedCutoff = 0.5;
  if (material.alphaMode == "MASK") {
    if (!(material.alphaCutoff >= 0.0))
      reader_.refuse(name, fmt::format("alphaCutoff = {}: must be 0 or more", material.alphaCutoff));
    surface.alpha_cutoff = material.alphaCutoff;
  } else if (material.alphaMode == "BLEND") {
    surface.alpha_cutoff = kBlendedCutoff;
    surface.blended = true;
  } else if (!material.alphaMode.empty() && material.alphaMode != "OPAQUE") {
    reader_.refuse(name,
                   fmt::format("alphaMode = \"{}\": must be OPAQUE, MASK or BLEND", material.alphaMode.substr(0, 20)));
  }
}

void GltfMaterials::readTransmission(const tinygltf::Material& material, const std::string& name,
                                     level::SceneMaterial& into) {
  const tinygltf::Value glass = extensionOf(material.extensions, "KHR_materials_transmission");
  const double factor = numberIn(glass, "transmissionFactor", 0.0, reader_, name);
  if (!(factor >= 0.0 && factor <= 1.0))
    reader_.refuse(name, fmt::format("transmissionFactor = {}: must be 0 to 1", factor));
  into.surface.transmission = factor;
  if (factor == 0.0 || !glass.IsObject() || !glass.Has("transmissionTexture")) return;
  const std::string what = name + " transmissionTexture";
  into.mean_transmission_texture =
      readTexture(indexIn(glass.Get("transmissionTexture"), "index", model_.textures.size(), reader_, what), what);
  builder_.scene().warnings.push_back(
      fmt::format("{}: {}: the whole surface passes the mean of its transmissionTexture", reader_.file(), name));
}

void GltfMaterials::readEmission(const tinygltf::Material& material, const std::string& name, int& uv_set,
                                 level::SceneMaterial& into) {
  const double strength = numberIn(extensionOf(material.extensions, "KHR_materials_emissive_strength"),
                                   "emissiveStrength", 1.0, reader_, name);
  if (strength < 0.0) reader_.refuse(name, fmt::format("emissiveStrength = {}: must be 0 or more", strength));
  Number3& emission = into.surface.emission;
  for (int i = 0; i < 3; ++i) {
    const double f = material.emissiveFactor[static_cast<std::size_t>(i)];
    if (!(f >= 0.0 && f <= 1.0)) reader_.refuse(name, fmt::format("emissiveFactor holds {}, must be 0 to 1", f));
    emission[i] = f * strength;
  }
  if (material.emissiveTexture.index < 0 || (emission.x == 0.0 && emission.y == 0.0 && emission.z == 0.0)) return;
  const auto& info = material.emissiveTexture;
  const Use use = readUse(info.index, info.texCoord, extensionOf(info.extensions, "KHR_texture_transform"),
                          name + " emissiveTexture");
  if (use.texture < 0) {
    builder_.scene().warnings.back() += ": its emissiveFactor stands in";
    return;
  }
  if (uv_set < 0 || uv_set == use.uv_set) {
    uv_set = use.uv_set;
    into.surface.emission_texture = use.texture;
    into.surface.emission_uv_row = use.uv_row;
    return;
  }
  into.mean_emission_texture = use.texture;
  builder_.scene().warnings.push_back(
      fmt::format("{}: {}: the whole surface emits the mean of its emissiveTexture, whose TEXCOORD_{} is not that of "
                  "its baseColorTexture",
                  reader_.file(), name, use.uv_set));
}

int GltfMaterials::readTexture(int index, const std::string& what) {
  if (index < 0 || static_cast<std::size_t>(index) >= model_.textures.size())
    reader_.refuse(what, fmt::format("texture {} is none of the {}", index, model_.textures.size()));
  const tinygltf::Texture& texture = model_.textures[static_cast<std::size_t>(index)];
  const std::string who = fmt::format("{}: texture {}", what, index);
  const auto warn = [&](const std::string& why) {
    builder_.scene().warnings.push_back(fmt::format("{}: {} {}", reader_.file(), who, why));
    return -1;
  };
  std::vector<int> images;
  const auto add = [&](const char* extension) {
    const int image = indexIn(extensionOf(texture.extensions, extension), "source", model_.images.size(), reader_,
                              who + " " + extension);
    if (image >= 0) images.push_back(image);
  };
  add("EXT_texture_webp");
  add("MSFT_texture_dds");
  if (texture.source >= 0) images.push_back(texture.source);
  if (images.empty()) {
    std::string names;
    for (const auto& [name, value] : texture.extensions) names += (names.empty() ? "" : ", ") + name;
    return warn(names.empty() ? "has no image" : fmt::format("has an image of {} alone, which is not read", names));
  }
  level::TextureSource source;
  const auto isRead = [&](int image) {
    source = readImage(image, who);
    return isTexture(model_.images[static_cast<std::size_t>(image)], source);
  };
  if (std::none_of(images.begin(), images.end(), isRead))
    return warn(fmt::format("is in a format that is not read: image {} \"{}\"", images.back(), source.name));
  if (texture.sampler >= 0) {
    if (static_cast<std::size_t>(texture.sampler) >= model_.samplers.size())
      reader_.refuse(who, fmt::format("sampler {} is none of the {}", texture.sampler, model_.samplers.size()));
    const tinygltf::Sampler& sampler = model_.samplers[static_cast<std::size_t>(texture.sampler)];
    const auto wrapOf = [&](int mode, const char* key) {
      if (mode == TINYGLTF_TEXTURE_WRAP_REPEAT) return geometry::Texture::Wrap::repeat;
      if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return geometry::Texture::Wrap::mirrored;
      if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return geometry::Texture::Wrap::clamped;
      reader_.refuse(who,
                     fmt::format("sampler {}: {} = {}: must be 10497, 33648 or 33071", texture.sampler, key, mode));
    };
    source.wrap_u = wrapOf(sampler.wrapS, "wrapS");
    source.wrap_v = wrapOf(sampler.wrapT, "wrapT");
  }
  return builder_.addTexture(std::move(source));
}

level::TextureSource GltfMaterials::readImage(int index, const std::string& what) {
  if (index < 0 || static_cast<std::size_t>(index) >= model_.images.size())
    reader_.refuse(what, fmt::format("source {} is none of the {} images", index, model_.images.size()));
  const tinygltf::Image& image = model_.images[static_cast<std::size_t>(index)];
  level::TextureSource source;
  source.name = image.uri.empty() ? fmt::format("{}: image {} \"{}\"", reader_.file(), index, image.name.substr(0, 60))
                                  : (std::filesystem::path(reader_.file()).parent_path() / image.uri).string();
  if (image.bufferView >= 0) {
    const auto bytes = reader_.bytes(image.bufferView, fmt::format("image {}", index));
    source.bytes.assign(bytes.begin(), bytes.end());
    return source;
  }
  if (image.image.empty())
    throw base::Error(base::ExitStatus::file, fmt::format("{}: {}: image {} \"{}\" is missing or cannot be read",
                                                          reader_.file(), what, index, image.uri.substr(0, 200)));
  const auto bytes = std::as_bytes(std::span(image.image));
  source.bytes.assign(bytes.begin(), bytes.end());
  return source;
}

}  // namespace welkin::gltf
