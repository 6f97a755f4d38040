// SPDX-License-Identifier: Apache-2.0
// Turns a scene's instances into triangles in the world.
#include "probes/loader/surfaces_of.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "probes/loader/texture_source.h"
#include "sky/base/error.h"

namespace welkin::loader {
namespace {

using f64::Number3;

Number3 load(const float (&v)[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

Number3 load(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

/// The nearest multiple of 2^-24 m. Sums of such numbers are exact up to 1e6 m.
Number3 rounded(const Number3& p) {
  const auto nearest = [](double v) { return std::floor(v * 0x1p24 + 0.5) * 0x1p-24; };
  return {nearest(p.x), nearest(p.y), nearest(p.z)};
}

/// A placed position. A level that is moved by sectors has the same positions from its sectors' corners to the last
/// bit.
Number3 placed(const geometry::Affine& transform, const Number3& p) {
  return rounded(transform.linear(p)) + rounded(transform.translation);
}

class Flattening {
 public:
  Flattening(const level::Scene& scene, double luminance_unit) : scene_(scene), luminance_unit_(luminance_unit) {
    has_uv_ = std::any_of(scene.materials.begin(), scene.materials.end(),
                          [](const level::SceneMaterial& m) { return m.surface.isTextured(); });
    has_colours_ = std::any_of(scene.vertices.begin(), scene.vertices.end(), [](const level::Vertex& v) {
      return v.colour[0] != 1.0F || v.colour[1] != 1.0F || v.colour[2] != 1.0F;
    });
  }

  geometry::Surfaces run() {
    result_.object = scene_.objects;
    result_.light = scene_.lights;
    for (geometry::StaticLight& light : result_.light) {
      light.position = rounded(light.position);
      light.intensity = light.intensity / luminance_unit_;
    }
    result_.warning = scene_.warnings;
    result_.file = scene_.files;
    for (const level::TextureSource& source : scene_.textures) result_.texture.push_back(decodeTexture(source));
    for (const level::SceneMaterial& material : scene_.materials) addMaterial(material);
    for (const level::Draw& draw : scene_.draws)
      for (uint32_t i = 0; i < draw.instance_count; ++i) addInstance(draw, scene_.placings[draw.first_instance + i]);
    if (result_.dropped_triangles > 0)
      result_.warning.push_back(fmt::format("{} of {} triangles are dropped: without area, or not finite",
                                            result_.dropped_triangles,
                                            result_.dropped_triangles + result_.triangle.size()));
    return std::move(result_);
  }

 private:
  void addMaterial(const level::SceneMaterial& from) {
    geometry::Material material = from.surface;
    const auto texture = [&](int index) -> const geometry::Texture& {
      return result_.texture[static_cast<std::size_t>(index)];
    };
    if (from.mean_emission_texture >= 0)
      material.emission = material.emission * meanColour(texture(from.mean_emission_texture));
    if (from.mean_transmission_texture >= 0) material.transmission *= meanRed(texture(from.mean_transmission_texture));
    material.emission = material.emission / luminance_unit_;
    const bool opaque =
        material.alpha >= material.alpha_cutoff && (material.texture < 0 || isOpaque(texture(material.texture)));
    if (opaque) material.alpha_cutoff = 0.0;  // so rays need not read the alpha
    if (opaque && material.alpha == 1.0) material.blended = false;
    result_.material.push_back(material);
  }

  void addInstance(const level::Draw& draw, const level::Placing& placing) {
    const auto* indices = scene_.indices.data() + draw.first_index;
    result_.dropped_triangles += draw.dropped_triangles;
    if (draw.index_count == 0) return;
    const std::size_t count = std::size_t{*std::max_element(indices, indices + draw.index_count)} + 1;
    const std::size_t first = result_.position.size();
    if (first + count > std::numeric_limits<uint32_t>::max())
      throw base::Error(base::ExitStatus::content, "the level has more than 2^32 placed vertices");
    for (std::size_t i = 0; i < count; ++i)
      addVertex(scene_.vertices[static_cast<std::size_t>(draw.vertex_offset) + i], placing);
    for (uint32_t i = 0; i < draw.index_count; i += 3) {
      geometry::Triangle triangle{{}, draw.material, placing.object};
      for (std::size_t c = 0; c < 3; ++c) triangle.vertex[c] = static_cast<uint32_t>(first + indices[i + c]);
      if (draw.mirrored) std::swap(triangle.vertex[1], triangle.vertex[2]);
      const Number3 a = load(result_.position[triangle.vertex[0]]);
      const Number3 area =
          cross(load(result_.position[triangle.vertex[1]]) - a, load(result_.position[triangle.vertex[2]]) - a);
      if (dot(area, area) > 0.0)
        result_.triangle.push_back(triangle);
      else
        ++result_.dropped_triangles;
    }
  }

  void addVertex(const level::Vertex& vertex, const level::Placing& placing) {
    constexpr double kFarthest_m = 1e6;
    const Number3 p = placed(placing.transform, load(vertex.position));
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(p[i]) <= kFarthest_m))
        throw base::Error(base::ExitStatus::content,
                          fmt::format("object \"{}\" reaches ({}, {}, {}) m: at most {} from the origin is "
                                      "allowed",
                                      scene_.objects[placing.object].name, p.x, p.y, p.z, kFarthest_m));
    result_.position.push_back({p.x, p.y, p.z});
    if (has_uv_) result_.uv.push_back({vertex.uv[0], vertex.uv[1]});
    if (has_colours_) result_.colour.push_back({vertex.colour[0], vertex.colour[1], vertex.colour[2]});
  }

  const level::Scene& scene_;
  double luminance_unit_;
  geometry::Surfaces result_;
  bool has_uv_ = false;
  bool has_colours_ = false;
};

}  // namespace

geometry::Surfaces surfacesOf(const level::Scene& scene, double luminance_unit) {
  return Flattening(scene, luminance_unit).run();
}

void useMeanColours(level::Scene& scene) {
  struct Mean {
    Number3 colour;
    double alpha, red;
  };
  std::vector<Mean> mean;
  for (const level::TextureSource& source : scene.textures) {
    const geometry::Texture texture = decodeTexture(source);
    mean.push_back({meanColour(texture), meanAlpha(texture), meanRed(texture)});
  }
  struct MeanMetal {
    double roughness, metallic;
  };
  std::vector<MeanMetal> mean_metal;
  for (const level::TextureSource& source : scene.metal_textures) {
    const geometry::Texture texture = decodeTexture(source);
    mean_metal.push_back({meanChannel(texture, 1), meanChannel(texture, 2)});
  }
  const auto meanOf = [&](int texture) -> const Mean& { return mean[static_cast<std::size_t>(texture)]; };
  for (level::SceneMaterial& material : scene.materials) {
    geometry::Material& surface = material.surface;
    if (surface.texture >= 0) surface.alpha *= meanOf(surface.texture).alpha;
    if (material.mean_transmission_texture >= 0) surface.transmission *= meanOf(material.mean_transmission_texture).red;
    if (surface.alpha == 1.0) surface.blended = false;
    if (material.mean_metal_texture >= 0) {
      const MeanMetal& factor = mean_metal[static_cast<std::size_t>(material.mean_metal_texture)];
      material.roughness *= factor.roughness;
      material.metallic *= factor.metallic;
      material.mean_metal_texture = -1;
    }
    for (int* const texture : {&surface.emission_texture, &material.mean_emission_texture}) {
      if (*texture >= 0) surface.emission = surface.emission * meanOf(*texture).colour;
      *texture = -1;
    }
  }
  for (const level::Draw& draw : scene.draws) {
    const int texture = scene.materials[draw.material].surface.texture;
    if (texture < 0) continue;
    const Number3& colour = meanOf(texture).colour;
    for (uint32_t i = 0; i < draw.instance_count; ++i)
      for (int c = 0; c < 3; ++c) scene.instances[draw.first_instance + i].albedo[c] *= static_cast<float>(colour[c]);
  }
}

}  // namespace welkin::loader
