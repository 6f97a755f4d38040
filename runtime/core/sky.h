// SPDX-License-Identifier: Apache-2.0
// An opened sky: the mapping of its file and the table inside it.
#pragma once

#include <welkin/welkin.h>

#include <cstdarg>
#include <cstddef>
#include <span>

#include "core/file_map.h"
#include "format/container.h"
#include "shared.h"

struct WelkinSky {
  welkin::core::FileMap map;
  const welkin::format::File* file = nullptr;  ///< checked by checkContent; points into the map or the caller's bytes
};

namespace welkin::core {

/// Writes a formatted message when there is somewhere to write it, and returns `code`.
[[gnu::format(printf, 3, 4)]] WelkinResult fail(WelkinMessage* message, WelkinResult code, const char* format, ...);

/// Whether everything that sampling reads is there and in its domain; else WELKIN_ERROR_CONTENT and which value is not.
WelkinResult checkContent(const format::File& file, WelkinMessage* message);

template <typename T>
std::span<const T> spanOf(const flatbuffers::Vector<T>* vector) {
  return vector == nullptr ? std::span<const T>() : std::span<const T>(vector->data(), vector->size());
}

inline f64::LuminanceModel luminanceModel(const format::Luminance& l) {
  return {l.a(), l.b(), l.c(), l.d(), l.e(), l.k()};
}

/// Degree l of the coefficient at an index.
constexpr int bandOf(std::uint32_t coefficient) {
  return coefficient < 1 ? 0 : coefficient < 4 ? 1 : coefficient < 9 ? 2 : coefficient < 16 ? 3 : 4;
}

/// Unit direction towards a light, at a time in [0, 24).
f64::Number3 directionAt(const format::LightPath& path, double time_h);

/// Stores a double in a float field: rounds, and keeps a value past float's range finite.
float toFloat(double value);

}  // namespace welkin::core
