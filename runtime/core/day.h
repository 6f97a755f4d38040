// SPDX-License-Identifier: Apache-2.0
// The day's table of an opened file: its numbers at any hour, and the modes for which they may be weights.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/polar_frame.h"
#include "welkin_generated.h"

namespace welkin::core {

/// Most rows of a table: 15 coefficients and the horizontal irradiance.
inline constexpr std::size_t kMostRows = 16;
inline constexpr std::size_t kMostModes = 12;

/// The map of the modes. It is read bilinearly, as a GPU filters it.
class ModeMap {
 public:
  ModeMap() = default;
  explicit ModeMap(const format::Modes& modes)
      : count_(modes.count()), columns_(modes.columns()), rows_(modes.rows()), texels_(modes.texels()->data()) {}

  std::size_t count() const { return count_; }
  /// Every mode at the coordinates modeColumn and modeRow of a normal, in [0, 1].
  std::array<double, kMostModes> at(double column, double row) const;

 private:
  std::size_t count_ = 0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  const std::uint16_t* texels_ = nullptr;
};

/// The table. Borrows the numbers of a file that checkContent let pass.
class Day {
 public:
  Day() = default;
  explicit Day(const format::Day& day);

  /// The shape of the sky at an hour: intensity 1, without ground. Elements that the file does not have are not set.
  struct Shape {
    std::array<Channels, kMostModes> weight;  ///< weights of the modes
    std::array<Channels, kMostRows> polar;    ///< coefficients of radiance in the sun's frame
    f64::Number3 horizontal_irradiance;       ///< 0 if the file needs none
  };
  /// `time_h` in [0, 24).
  void shapeAt(double time_h, Shape& shape) const;

  std::size_t bands() const { return bands_; }
  const ModeMap& modes() const { return modes_; }
  /// format::familyOf the modes; 0 without modes.
  std::uint64_t family() const { return family_; }

 private:
  using Blend = void (Day::*)(double time_h, Channels* rows) const;
  template <format::Encoding kEncoding>
  void blend(double time_h, Channels* rows) const;

  Blend blend_ = nullptr;  ///< for the file's encoding
  std::span<const double> key_time_h_;
  std::span<const float> key_scale_, row_scale_;
  const std::uint8_t* numbers_ = nullptr;
  std::size_t bands_ = 0, rows_ = 0, channels_ = 0;
  ModeMap modes_;
  std::uint64_t family_ = 0;
  std::span<const float> mode_sh_;                 ///< mode, coefficient
  std::array<double, kMostModes> mode_upwards_{};  ///< modes of the normal that looks up
};

}  // namespace welkin::core
