// SPDX-License-Identifier: Apache-2.0
// Reports of errors, checks of the arguments of the C interface, and access to its structs that can grow.
#pragma once

#include <welkin/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace welkin::core {

static_assert(sizeof(void*) == 8, "the sizes of the C interface's structs are those of 64-bit processors");

// MinGW's "printf" is that of the old C library of Windows. The libraries ask for the standard one.
#if defined(__MINGW32__) && !defined(__clang__)
#define WELKIN_PRINTF gnu_printf
#else
#define WELKIN_PRINTF printf
#endif

/// Writes a formatted message when there is somewhere to write it, and returns `code`.
[[gnu::format(WELKIN_PRINTF, 3, 4)]] WelkinResult fail(WelkinMessage* message, WelkinResult code, const char* format,
                                                       ...);

/// Stores "function: " and the formatted text for welkin_argument_error. Returns WELKIN_ERROR_ARGUMENT.
[[gnu::format(WELKIN_PRINTF, 2, 3)]] WelkinResult refuse(const char* function, const char* format, ...);

/// Size of a struct in its first release. A struct that grows keeps it.
template <typename Struct>
inline constexpr std::size_t kFirstSize = 0;
template <>
inline constexpr std::size_t kFirstSize<WelkinAllocator> = 32;
template <>
inline constexpr std::size_t kFirstSize<WelkinLog> = 24;
template <>
inline constexpr std::size_t kFirstSize<WelkinOpenInfo> = 48;
template <>
inline constexpr std::size_t kFirstSize<WelkinSkyInfo> = 52;
template <>
inline constexpr std::size_t kFirstSize<WelkinSkySample> = 936;
template <>
inline constexpr std::size_t kFirstSize<WelkinLuminance> = 32;
template <>
inline constexpr std::size_t kFirstSize<WelkinGradients> = 48;
template <>
inline constexpr std::size_t kFirstSize<WelkinCubemap> = 40;
template <>
inline constexpr std::size_t kFirstSize<WelkinStars> = 48;
template <>
inline constexpr std::size_t kFirstSize<WelkinModes> = 24;
template <>
inline constexpr std::size_t kFirstSize<WelkinCertificate> = 144;

/// A function's address for `nonNull`.
template <typename Function>
const void* asPointer(Function* function) {
  return reinterpret_cast<const void*>(function);
}

struct Pointer {
  const char* name;
  const void* value;
};

/// WELKIN_OK if no pointer is null.
inline WelkinResult nonNull(const char* function, std::initializer_list<Pointer> pointers) {
  for (const Pointer& pointer : pointers)
    if (pointer.value == nullptr) return refuse(function, "%s is null", pointer.name);
  return WELKIN_OK;
}

/// WELKIN_OK if the struct has a size between that of its first release and that of this library.
template <typename Struct>
WelkinResult sized(const char* function, const char* name, const Struct* value) {
  static_assert(kFirstSize<Struct> > 0 && kFirstSize<Struct> <= sizeof(Struct));
  if (value == nullptr) return refuse(function, "%s is null", name);
  if (value->struct_size >= kFirstSize<Struct> && value->struct_size <= sizeof(Struct)) return WELKIN_OK;
  return refuse(function, "%s->struct_size is %u, must be the struct's size, %zu to %zu in this library", name,
                value->struct_size, kFirstSize<Struct>, sizeof(Struct));
}

/// WELKIN_OK if the vector is finite and its length is within 0.1 % of 1.
inline WelkinResult unit(const char* function, const char* name, const float v[3]) {
  if (v == nullptr) return refuse(function, "%s is null", name);
  const double square =
      double{v[0]} * double{v[0]} + double{v[1]} * double{v[1]} + double{v[2]} * double{v[2]};  // NaN fails, too
  if (square >= 0.999 * 0.999 && square <= 1.001 * 1.001) return WELKIN_OK;
  return refuse(function, "%s has the length %g, must be a unit vector", name, std::sqrt(square));
}

/// WELKIN_OK if a sample has the sizes that welkin_sky_sample can give it.
inline WelkinResult checkSample(const char* function, const char* name, const WelkinSkySample* sample) {
  if (const auto r = sized(function, name, sample)) return r;
  if (sample->coefficient_count > WELKIN_MAX_COEFFICIENTS)
    return refuse(function, "%s->coefficient_count is %u, must be 0 to %d", name, sample->coefficient_count,
                  WELKIN_MAX_COEFFICIENTS);
  if (sample->mode_count > WELKIN_MAX_MODES)
    return refuse(function, "%s->mode_count is %u, must be 0 to %d", name, sample->mode_count, WELKIN_MAX_MODES);
  if (!(sample->time_h >= 0.0 && sample->time_h < 24.0))
    return refuse(function, "%s->time_h is %g, must be in [0, 24)", name, sample->time_h);
  return WELKIN_OK;
}

/// The family of a sample's modes; 0 if there is none, or if the caller's struct has no room for it.
inline std::uint64_t familyOf(const WelkinSkySample& sample) {
  constexpr std::size_t kEnd = offsetof(WelkinSkySample, mode_family) + sizeof sample.mode_family;
  return sample.struct_size >= kEnd ? sample.mode_family : 0;
}

/// WELKIN_OK if a sample, which `checkSample` has checked, has no modes or those of a sky.
inline WelkinResult checkModes(const char* function, const char* name, const WelkinSkySample& sample, std::size_t count,
                               std::uint64_t family) {
  if (sample.mode_count == 0) return WELKIN_OK;
  if (sample.mode_count != count)
    return refuse(function, "%s->mode_count is %u, must be 0 or the sky's, %zu", name, sample.mode_count, count);
  if (familyOf(sample) != 0 && familyOf(sample) != family)
    return refuse(function, "%s->mode_family is %#llx, must be the sky's, %#llx: its modes are those of another sky",
                  name, static_cast<unsigned long long>(familyOf(sample)), static_cast<unsigned long long>(family));
  return WELKIN_OK;
}

/// Writes the part of `value` that the caller's struct, which `sized` has checked, has room for.
template <typename Struct>
void give(const Struct& value, Struct* out) {
  const std::uint32_t size = out->struct_size;
  std::memcpy(static_cast<void*>(out), &value, std::min<std::size_t>(size, sizeof value));
  out->struct_size = size;
}

/// The caller's struct, which `sized` has checked; fields that the caller does not know are 0.
template <typename Struct>
Struct take(const Struct& in) {
  Struct value{};
  std::memcpy(static_cast<void*>(&value), &in, std::min<std::size_t>(in.struct_size, sizeof value));
  value.struct_size = sizeof value;
  return value;
}

}  // namespace welkin::core
