// SPDX-License-Identifier: Apache-2.0
// A calm sea over the scene drawn so far: sky and level mirrored in its waves, the sun's glitter, and the ground seen
// through the water.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_view.glsl"
#include "welkin/reflection.glsl"

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_SCENE) uniform sampler2D levelScene;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_REFLECTION) uniform sampler2D levelReflection;

layout(location = 0) out vec4 radiance;

// The ground of a level ends somewhere. Deep water hides that over this width before the end, in metres.
const float kFloorFade = 30.0;
const float kLongestPath = 1e6;  // metres; the sea has no edge

// Bilinear and clamped. Written out because 32-bit floats need not be filterable.
vec4 reflectionAt(vec2 uv) {
  ivec2 last = textureSize(levelReflection, 0) - 1;
  vec2 at = uv * vec2(last + 1) - 0.5;
  ivec2 low = clamp(ivec2(floor(at)), ivec2(0), last);
  ivec2 high = clamp(ivec2(floor(at)) + 1, ivec2(0), last);
  vec2 weight = fract(at);
  return mix(mix(texelFetch(levelReflection, low, 0), texelFetch(levelReflection, ivec2(high.x, low.y), 0), weight.x),
             mix(texelFetch(levelReflection, ivec2(low.x, high.y), 0), texelFetch(levelReflection, high, 0), weight.x), weight.y);
}

struct Waves {
  vec2 slope;      // dy/dx, dy/dz of the waves that a pixel resolves
  float variance;  // of the slopes of smaller waves, along either axis
};

// The sum of the waves, filtered over a pixel's footprint. A wave of wave number k, seen through a Gaussian of standard
// deviation f, keeps exp(-(k f)^2 / 2) of its slope. The loss becomes roughness (Bruneton et al. 2010, 4).
Waves wavesAt(vec2 p, vec2 along, float footprint_along, float footprint_across) {
  Waves waves = Waves(vec2(0.0), level.water.y);
  for (int i = 0; i < WELKIN_WAVE_COUNT; ++i) {
    vec4 wave = level.waves[i];
    float a = dot(wave.xy, along) * footprint_along;
    float b = (wave.x * along.y - wave.y * along.x) * footprint_across;
    float kept = exp(-0.5 * (a * a + b * b));
    waves.slope += normalize(wave.xy) * (wave.z * kept * cos(dot(wave.xy, p) + wave.w));
    waves.variance += 0.25 * wave.z * wave.z * (1.0 - kept * kept);
  }
  return waves;
}

void main() {
  ivec2 size = textureSize(levelDepth, 0);
  vec2 uv = gl_FragCoord.xy / vec2(size);
  vec3 ray = rayThrough(uv * 2.0 - 1.0);
  float ray_length = length(ray);
  vec3 direction = ray / ray_length;
  float drop = level.camera.y - level.water.x;
  float distance_m = min(drop / max(-direction.y, 1e-9), kLongestPath);
  vec3 p = level.camera.xyz + direction * distance_m;

  vec2 along = normalize(direction.xz + vec2(1e-9, 0.0));
  float across_m = 0.5 * distance_m * level.options.w;
  Waves waves = wavesAt(p.xz, along, min(across_m / max(-direction.y, 1e-4), 1e4), across_m);
  vec3 normal = normalize(vec3(-waves.slope.x, 1.0, -waves.slope.y));
  vec3 view = -direction;
  float cos_view = dot(normal, view);
  if (cos_view < 0.02) {  // a facet that turns away is hidden by the wave before it
    normal = normalize(normal + view * (0.02 - cos_view));
    cos_view = 0.02;
  }

  // Facets too small to be told apart tilt the mirrored view by about twice their slope. On average they tilt it
  // upwards, since those that tilt it down are hidden or mirror other water. Along the view only the visible half of
  // the slopes counts.
  float spread = sqrt(waves.variance);
  vec3 mirrored = reflect(direction, normal);
  mirrored.y = abs(mirrored.y);
  vec3 up_tilted = normalize(mirrored + vec3(0.0, 1.5 * spread * (1.0 - mirrored.y), 0.0));
  // Slopes of variance s spread like a specular power of 1 / s - 2. That selects the mip of the cubemaps.
  float gloss = log2(max(1.0 / max(waves.variance, 1e-6) - 2.0, 1.0)) / 13.0;
  vec3 reflected = mix(welkinDomeRadiance(up_tilted), welkinSkyReflection(up_tilted, gloss), level.water.z);
  vec2 offset = vec2(dot(normal.xz, vec2(-along.y, along.x)), dot(normal.xz, along)) * vec2(0.35, 0.6);
  vec4 of_level = reflectionAt(uv + offset * min(1.0, 12.0 / distance_m));
  reflected = reflected * (1.0 - of_level.a) + of_level.rgb;  // where there is no level it is 0

  // Mean reflectance of a rough sea, Bruneton et al. 2010, eq. 18, falls to Schlick's for none.
  float fresnel = kWaterReflectance + (1.0 - kWaterReflectance) * pow(1.0 - cos_view, 5.0 * exp(-2.69 * spread)) /
                                          (1.0 + 22.7 * pow(spread, 1.5));
  fresnel = spread > 0.0 ? fresnel : schlick(kWaterReflectance, cos_view);

  // The scene behind, displaced by the waves where the displaced point still lies behind.
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float here = level.camera.w / max(texelFetch(levelDepth, pixel, 0).r, 1e-9) * ray_length;
  float displacement = clamp(here - distance_m, 0.0, 2.0) / max(distance_m, 1.0) * float(size.y) * 0.15;
  ivec2 bent = clamp(pixel + ivec2(round(normal.xz * displacement)), ivec2(0), size - 1);
  vec3 bent_ray = rayThrough((vec2(bent) + 0.5) / vec2(size) * 2.0 - 1.0);
  float bent_depth = level.camera.w / max(texelFetch(levelDepth, bent, 0).r, 1e-9);
  if (bent_depth * length(bent_ray) < distance_m) {
    bent = pixel;
    bent_ray = ray;
    bent_depth = level.camera.w / max(texelFetch(levelDepth, pixel, 0).r, 1e-9);
  }
  // The light's path straight down to the ground and back up along the refracted view.
  float depth_m = max(level.water.x - (level.camera.y + bent_ray.y * bent_depth), 0.0);
  float refracted_y = sqrt(1.0 - (1.0 - direction.y * direction.y) / (1.33 * 1.33));
  float path_m = min(depth_m + depth_m / refracted_y, kLongestPath);
  vec3 left = vec3(transmittance(kWaterExtinction.x, path_m), transmittance(kWaterExtinction.y, path_m),
                   transmittance(kWaterExtinction.z, path_m));
  vec2 bottom = level.camera.xz + bent_ray.xz * bent_depth;
  vec2 inside = min(bottom - level.floor_edge.xy, level.floor_edge.zw - bottom);
  left *= smoothstep(0.0, kFloorFade, min(inside.x, inside.y));
  float shadow = lightReaching(p, vec3(0.0, 1.0, 0.0));
  float light_y = max(level.light.y, 0.0);
  vec3 irradiance = ambientIrradiance(p, vec3(0.0, 1.0, 0.0)) + level.light_irradiance.rgb * (light_y * shadow);
  vec3 body = mix(kWaterAlbedo / kPi * irradiance, texelFetch(levelScene, bent, 0).rgb, left);

  vec3 half_vector = normalize(view + level.light.xyz);
  float variance = max(waves.variance, 1e-5);
  vec2 half_slope = -half_vector.xz / max(half_vector.y, 1e-3) - waves.slope;
  float sparkle = glitter(slopeDensity(half_slope.x, half_slope.y, variance), max(cos_view, spread), half_vector.y);
  vec3 sun = level.light.y > 0.0 ? level.light_irradiance.rgb * (sparkle * schlick(kWaterReflectance, max(dot(half_vector, view), 0.0)) * shadow) : vec3(0.0);

  vec3 sea = mix(body, reflected, fresnel) + sun;
  radiance = vec4(throughMist(sea, direction, distance_m), 1.0);
}
