// SPDX-License-Identifier: Apache-2.0
// Checks that numbers of a file lie in their domain.
#pragma once

#include <algorithm>
#include <span>

#include "welkin_generated.h"

namespace welkin::format {

inline constexpr double kAny = 1e30;  ///< finite, and its square stays finite

/// Whether `value` lies in the closed interval; false for NaN.
inline bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

template <typename T>
bool within(std::span<const T> values, double low, double high) {
  return std::all_of(values.begin(), values.end(), [=](T v) { return within(static_cast<double>(v), low, high); });
}

/// The elements of a vector; empty if the vector is absent.
template <typename T>
std::span<const T> spanOf(const flatbuffers::Vector<T>* vector) {
  return vector == nullptr ? std::span<const T>() : std::span<const T>(vector->data(), vector->size());
}

/// The verifier of FlatBuffers checks the alignment of a vector's length, but not of its elements.
bool aligned(const flatbuffers::Vector<double>* vector);

/// The fault of a path, in words; null if it has none.
const char* faultOf(const LightPath& path);

}  // namespace welkin::format
