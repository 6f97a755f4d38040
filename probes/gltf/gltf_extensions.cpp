// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_extensions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::gltf {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kRead[] = {
    "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression", "EXT_texture_webp",
    "KHR_draco_mesh_compression", "KHR_lights_punctual",     "KHR_materials_emissive_strength",
    "KHR_materials_transmission",
    "KHR_materials_unlit",  // the albedo is that of the base colour
    "KHR_mesh_quantization",      "KHR_node_visibility",     "KHR_texture_transform",
    "MSFT_texture_dds",
};

/// Formats of textures: who reads a texture warns of them.
constexpr std::string_view kTextures[] = {"EXT_texture_avif", "KHR_texture_basisu"};

/// Extensions that change no diffuse light: gloss, behaviour, descriptions, and variants other than the default.
constexpr std::string_view kHarmless[] = {
    "AGI_articulations",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "EXT_instance_features",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "FB_ngon_encoding",
    "GODOT_single_root",
    "KHR_animation_pointer",
    "KHR_audio_emitter",
    "KHR_collision_shapes",
    "KHR_implicit_shapes",
    "KHR_interactivity",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_specular",
    "KHR_materials_variants",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_physics_rigid_bodies",
    "KHR_rigid_bodies",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "MSFT_audio_emitter",
    "MSFT_lod",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
    "OMI_collider",
    "OMI_physics_body",
    "OMI_physics_gravity",
    "OMI_physics_joint",
    "OMI_physics_shape",
    "OMI_spawn_point",
};

template <std::size_t kCount>
bool isIn(const std::string_view (&list)[kCount], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

/// Collects the extensions of everything that the scene reaches.
class Walk {
 public:
  explicit Walk(const Json& gltf) : gltf_(gltf) {
    note(gltf, "the file");
    if (const Json* asset = member(gltf, "asset")) note(*asset, "asset");
    for (const char* list : {"accessors", "bufferViews", "buffers"})
      for (std::size_t i = 0; i < sizeOf(list); ++i) note(gltf[list][i], nameOf(list, i));
    for (const std::size_t root : roots()) node(root);
    for (std::size_t i = 0; i < waiting_.size(); ++i) placeNode(waiting_[i]);
  }

  struct Use {
    std::string first;  ///< place
    std::size_t count = 0;
  };
  const std::map<std::string, Use>& uses() const { return uses_; }

 private:
  static const Json* member(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }

  std::size_t sizeOf(const char* list) const {
    const Json* found = member(gltf_, list);
    return found == nullptr ? 0 : found->size();
  }

  std::string nameOf(const char* list, std::size_t i) const {
    const Json* name = member(gltf_[list][i], "name");
    const std::string place = fmt::format("{}[{}]", list, i);
    return name == nullptr || !name->is_string()
               ? place
               : fmt::format("{} \"{}\"", place, base::shortened(name->get_ref<const std::string&>(), 60));
  }

  void note(const Json& object, const std::string& place) {
    const Json* extensions = member(object, "extensions");
    if (extensions == nullptr) return;
    for (const auto& [name, value] : extensions->items()) {
      Use& use = uses_[name];
      if (use.count++ == 0) use.first = place;
    }
  }

  /// The root nodes of the scene that is read; all nodes of a file without scenes.
  std::vector<std::size_t> roots() {
    std::vector<std::size_t> nodes;
    if (sizeOf("scenes") == 0) {
      for (std::size_t i = 0; i < sizeOf("nodes"); ++i) nodes.push_back(i);
      return nodes;
    }
    const Json* chosen = member(gltf_, "scene");
    const std::size_t scene = chosen == nullptr ? 0 : chosen->get<std::size_t>();
    if (scene >= sizeOf("scenes")) return nodes;
    note(gltf_["scenes"][scene], nameOf("scenes", scene));
    if (const Json* list = member(gltf_["scenes"][scene], "nodes")) nodes = list->get<std::vector<std::size_t>>();
    return nodes;
  }

  bool isNew(const char* list, std::size_t i) { return i < sizeOf(list) && seen_.insert({list, i}).second; }

  void node(std::size_t i) {
    if (isNew("nodes", i)) waiting_.push_back(i);
  }

  void placeNode(std::size_t i) {
    const Json& object = gltf_["nodes"][i];
    note(object, nameOf("nodes", i));
    if (const Json* children = member(object, "children"))
      for (const Json& child : *children) node(child.get<std::size_t>());
    if (const Json* index = member(object, "mesh"); index != nullptr && isNew("meshes", index->get<std::size_t>()))
      mesh(index->get<std::size_t>());
  }

  void mesh(std::size_t i) {
    const std::string place = nameOf("meshes", i);
    note(gltf_["meshes"][i], place);
    for (const Json& primitive : gltf_["meshes"][i]["primitives"]) {
      note(primitive, place);
      const Json* index = member(primitive, "material");
      if (index != nullptr && isNew("materials", index->get<std::size_t>())) material(index->get<std::size_t>());
    }
  }

  void material(std::size_t i) {
    const Json& object = gltf_["materials"][i];
    const std::string place = nameOf("materials", i);
    note(object, place);
    textureOf(object, "emissiveTexture", place);
    if (const Json* extensions = member(object, "extensions"))
      if (const Json* glass = member(*extensions, "KHR_materials_transmission"))
        textureOf(*glass, "transmissionTexture", place);
    const Json* pbr = member(object, "pbrMetallicRoughness");
    if (pbr == nullptr) return;
    note(*pbr, place);
    textureOf(*pbr, "baseColorTexture", place);
  }

  /// The texture that a key of an object names, with its sampler and image.
  void textureOf(const Json& object, const char* key, const std::string& place) {
    const Json* info = member(object, key);
    if (info == nullptr) return;
    note(*info, place);
    const auto i = (*info)["index"].get<std::size_t>();
    if (!isNew("textures", i)) return;
    const Json& texture = gltf_["textures"][i];
    note(texture, nameOf("textures", i));
    for (const auto& [index, list] : {std::pair("sampler", "samplers"), std::pair("source", "images")})
      if (const Json* part = member(texture, index); part != nullptr && isNew(list, part->get<std::size_t>()))
        note(gltf_[list][part->get<std::size_t>()], nameOf(list, part->get<std::size_t>()));
  }

  const Json& gltf_;
  std::map<std::string, Use> uses_;
  std::set<std::pair<std::string, std::size_t>> seen_;
  std::vector<std::size_t> waiting_;
};

}  // namespace

void requireKnownExtensions(const Json& gltf, const std::string& file) {
  const auto required = gltf.find("extensionsRequired");
  if (required == gltf.end()) return;
  for (const Json& value : *required) {
    const auto& name = value.get_ref<const std::string&>();
    if (!isIn(kRead, name) && !isIn(kTextures, name) && !isIn(kHarmless, name))
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: extensionsRequired: \"{}\" is not read; {} are", file,
                                    base::shortened(name, 60), fmt::join(kRead, ", ")));
  }
}

std::vector<std::string> extensionWarnings(const Json& gltf, const std::string& file) {
  const Walk walk(gltf);
  std::vector<std::string> warnings;
  for (const auto& [name, use] : walk.uses()) {
    if (isIn(kRead, name) || isIn(kTextures, name) || isIn(kHarmless, name)) continue;
    const std::string more = use.count > 1 ? fmt::format(" and {} more", use.count - 1) : "";
    warnings.push_back(fmt::format("{}: {} is not read: {}{}", file, base::shortened(name, 60), use.first, more));
  }
  return warnings;
}

}  // namespace welkin::gltf
