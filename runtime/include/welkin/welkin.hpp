// SPDX-License-Identifier: Apache-2.0
// C++17 wrapper of welkin.h, header only. It adds ownership, spans and results with messages, nothing else.
// Conventions, units, errors and the rules of threads are those of welkin.h.
#pragma once

#include <welkin/engines.h>
#include <welkin/sky_constants.h>
#include <welkin/welkin.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace welkin {

/// Result of a call; true means success. `message` gives the reason for a failure, and is empty on success.
struct Status {
  WelkinResult code = WELKIN_OK;
  std::string message;
  explicit operator bool() const { return code == WELKIN_OK; }
};

/// A view of numbers that an opened sky owns.
template <typename T>
struct Span {
  const T* first = nullptr;
  std::size_t count = 0;
  const T* begin() const { return first; }
  const T* end() const { return first + count; }
  const T* data() const { return first; }
  std::size_t size() const { return count; }
  bool empty() const { return count == 0; }
  const T& operator[](std::size_t i) const { return first[i]; }
};

/// A colour (red, green, blue) or a direction (x, y, z).
using Float3 = std::array<float, 3>;

/// The Status of a call that has no message of its own.
inline Status statusOf(WelkinResult code) {
  if (code == WELKIN_OK) return {};
  return {code, code == WELKIN_ERROR_ARGUMENT ? welkin_argument_error() : welkin_result_string(code)};
}

/// WELKIN_VERSION of the library that runs, and the format version of its skies.
inline std::uint32_t version() {
  return welkin_version();
}
inline std::uint32_t formatVersion() {
  return welkin_format_version();
}

/// Kind of the file that starts with these bytes; 64 of them are enough.
inline WelkinFileKind fileKind(const void* data, std::size_t size) {
  return welkin_file_kind(data, size);
}

/// Owns a WelkinSky. Movable; empty until an open succeeds. While none is open, getters return zeros, and the other
/// functions fail.
class Sky {
 public:
  Sky() = default;
  Sky(Sky&& other) noexcept : sky_(std::exchange(other.sky_, nullptr)) {}
  Sky& operator=(Sky&& other) noexcept {
    std::swap(sky_, other.sky_);
    return *this;
  }
  Sky(const Sky&) = delete;
  Sky& operator=(const Sky&) = delete;
  ~Sky() { welkin_sky_close(sky_); }

  /// Opens a file and closes the sky held before. On an error the sky held before stays open.
  Status open(const std::string& path) {
    WelkinOpenInfo info{};
    info.path = path.c_str();
    return open(info);
  }
  /// Opens bytes in memory likewise. `data` must be aligned to 16. Keep the bytes unchanged while the sky is open.
  Status open(const void* data, std::size_t size) {
    WelkinOpenInfo info{};
    info.data = data;
    info.size = size;
    return open(info);
  }
  /// Opens a sky with the game's memory, a log, or a copy of the bytes.
  Status open(const WelkinOpenInfo& info) {
    WelkinSky* sky = nullptr;
    WelkinMessage message{};
    const WelkinResult code = welkin_sky_open(&info, &sky, &message);
    if (code != WELKIN_OK) return {code, message.text};
    welkin_sky_close(std::exchange(sky_, sky));
    return {};
  }
  void close() { welkin_sky_close(std::exchange(sky_, nullptr)); }

  /// The sky for the functions of welkin.h; null when none is open.
  const WelkinSky* get() const { return sky_; }
  explicit operator bool() const { return sky_ != nullptr; }

  WelkinSkyInfo info() const { return described(welkin_sky_info); }
  WelkinLuminance luminance() const { return described(welkin_sky_luminance); }
  WelkinGradients gradients() const { return described(welkin_sky_gradients); }
  WelkinStars stars() const { return described(welkin_sky_stars); }
  WelkinModes modes() const { return described(welkin_sky_modes); }
  WelkinCertificate certificate() const { return described(welkin_sky_certificate); }
  /// The settings of the bake as JSON; empty when no sky is open.
  const char* settings() const {
    const char* json = "";
    welkin_sky_settings(sky_, &json);
    return json;
  }
  Status cubemap(std::uint32_t index, WelkinCubemap& cubemap) const {
    return statusOf(welkin_sky_cubemap(sky_, index, &cubemap));
  }
  Status keyTime(std::uint32_t index, double& time_h) const {
    return statusOf(welkin_sky_key_time(sky_, index, &time_h));
  }

  /// Writes the sky at `time_h` hours to `out`.
  Status sample(double time_h, WelkinSkySample& out) const { return statusOf(welkin_sky_sample(sky_, time_h, &out)); }
  Status irradiance(const WelkinSkySample& sample, const Float3& normal, Float3& rgb) const {
    return statusOf(welkin_sky_irradiance(sky_, &sample, normal.data(), rgb.data()));
  }
  Status domeRadiance(const WelkinSkySample& sample, const Float3& direction, Float3& rgb) const {
    return statusOf(welkin_dome_radiance(sky_, &sample, direction.data(), rgb.data()));
  }
  Status starRadiance(const WelkinSkySample& sample, const Float3& direction, Float3& rgb) const {
    return statusOf(welkin_star_radiance(sky_, &sample, direction.data(), rgb.data()));
  }
  /// Fills the uniform block of the shaders, for a renderer without welkin_vulkan.h.
  Status constants(const WelkinSkySample& sample, WelkinSkyConstants& block) const {
    return statusOf(welkin_sky_constants(sky_, &sample, &block, sizeof block));
  }

 private:
  template <typename Struct>
  Struct described(WelkinResult (*describe)(const WelkinSky*, Struct*)) const {
    Struct value{};
    describe(sky_, &value);
    return value;
  }

  WelkinSky* sky_ = nullptr;
};

/// The colours of a gradient: three numbers per texel, rows from the horizon.
inline Span<float> numbers(const WelkinGradient& gradient) {
  return {gradient.rgb, std::size_t{3} * gradient.width * gradient.height};
}
/// The texels of a cubemap, of a star map (four bytes each) and of the modes (half floats, `count` per texel).
inline Span<std::byte> texels(const WelkinCubemap& cubemap) {
  return {static_cast<const std::byte*>(cubemap.texels), cubemap.bytes};
}
inline Span<std::uint8_t> texels(const WelkinStars& stars) {
  return {stars.rgba8, std::size_t{4} * stars.width * stars.height};
}
inline Span<std::uint16_t> texels(const WelkinModes& modes) {
  return {modes.texels, std::size_t{modes.count} * modes.columns * modes.rows};
}

/// Irradiance from a sample's ambient coefficients alone.
inline Status irradiance(const WelkinSkySample& sample, const Float3& normal, Float3& rgb) {
  return statusOf(welkin_sample_irradiance(&sample, normal.data(), rgb.data()));
}
/// Blends two skies, for weather; `weight` is that of the second.
inline Status blend(const WelkinSkySample& first, const WelkinSkySample& second, float weight, WelkinSkySample& out) {
  return statusOf(welkin_sample_blend(&first, &second, weight, &out));
}
/// The light for a renderer with one shadowed directional light.
inline Status keyLight(const WelkinSkySample& sample, WelkinLight& light) {
  return statusOf(welkin_sample_key_light(&sample, &light));
}
/// Radiance of the discs of sun and moon.
inline Status discRadiance(const WelkinSkySample& sample, const Float3& direction, float pixel_rad, Float3& rgb) {
  return statusOf(welkin_disc_radiance(&sample, direction.data(), pixel_rad, rgb.data()));
}
/// Replaces the ambient light in a block by that of a cross-blend.
inline Status ambientConstants(const WelkinSkySample& blended, WelkinSkyConstants& block) {
  return statusOf(welkin_sample_ambient_constants(&blended, &block, sizeof block));
}

/// A vector in an engine's axes.
inline Status convert(WelkinAxes axes, const Float3& vector, Float3& converted) {
  return statusOf(welkin_axes_vector(axes, vector.data(), converted.data()));
}
/// The ambient light in the forms of engines.
inline Status pack(const WelkinSkySample& sample, WelkinAxes axes, WelkinRadianceSh& packed) {
  return statusOf(welkin_pack_radiance(&sample, axes, &packed));
}
inline Status pack(const WelkinSkySample& sample, WelkinFilamentIrradianceOverPi& packed) {
  return statusOf(welkin_pack_filament(&sample, &packed));
}
inline Status pack(const WelkinSkySample& sample, WelkinFilamentRadiance& packed) {
  return statusOf(welkin_pack_filament_radiance(&sample, &packed));
}
inline Status pack(const WelkinSkySample& sample, WelkinAxes axes, WelkinUnityIrradianceOverPi& packed) {
  return statusOf(welkin_pack_unity_axes(&sample, axes, &packed));
}
inline Status pack(const WelkinSkySample& sample, WelkinAxes axes, WelkinUnityProbe& packed) {
  return statusOf(welkin_pack_unity_probe(&sample, axes, &packed));
}
inline Status pack(const WelkinSkySample& sample, WelkinUnrealIrradianceOverPi& packed) {
  return statusOf(welkin_pack_unreal(&sample, &packed));
}
inline Status pack(const WelkinSkySample& sample, WelkinGodotIrradianceOverPi& packed) {
  return statusOf(welkin_pack_godot(&sample, &packed));
}

}  // namespace welkin
