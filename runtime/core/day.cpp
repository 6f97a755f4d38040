// SPDX-License-Identifier: Apache-2.0
#include "core/day.h"

#include <algorithm>

#include "core/sky.h"
#include "format/day_numbers.h"
#include "format/key_segment.h"
#include "format/mode_family.h"
#include "format/mode_texels.h"

namespace welkin::core {

using f64::Number3;
using format::Encoding;

namespace {

Number3 notNegative(const Channels& v) {
  return {std::max(v[0], 0.0), std::max(v[1], 0.0), std::max(v[2], 0.0)};
}

}  // namespace

std::array<double, kMostModes> ModeMap::at(double column, double row) const {
  const auto texels = format::modeTexelsAt(column, row, columns_, rows_);
  std::array<double, kMostModes> value{};
  for (std::size_t k = 0; k < count_; ++k)
    value[k] = texels.blend([&](std::size_t i, std::size_t j) {
      return double{format::floatFromHalf(texels_[(j * columns_ + i) * count_ + k])};
    });
  return value;
}

Day::Day(const format::Day& day)
    : key_time_h_(spanOf(day.key_time_h())),
      key_scale_(spanOf(day.key_scale())),
      row_scale_(spanOf(day.row_scale())),
      numbers_(day.numbers()->data()),
      bands_(day.bands()),
      rows_(day.rows()),
      channels_(day.channels()) {
  format::visitEncoding(day.encoding(), [this](auto encoding) { blend_ = &Day::blend<encoding()>; });
  if (day.modes() == nullptr) return;
  modes_ = ModeMap(*day.modes());
  family_ = format::familyOf(*day.modes());
  mode_sh_ = spanOf(day.modes()->polar_sh());
  mode_upwards_ = modes_.at(0.5, 1.0);
}

template <Encoding kEncoding>
void Day::blend(double time_h, Channels* rows) const {
  const auto s = format::findSegment(key_time_h_, time_h);
  double weight[2] = {1.0 - s.weight, s.weight};
  if constexpr (format::hasKeyScale(kEncoding)) {
    weight[0] *= double{key_scale_[s.first]};
    weight[1] *= double{key_scale_[s.second]};
  }
  const std::size_t count = rows_ * channels_;
  double value[3 * kMostRows];
  for (std::size_t i = 0; i < count; ++i)
    value[i] = weight[0] * format::storedNumber<kEncoding>(numbers_, s.first * count + i) +
               weight[1] * format::storedNumber<kEncoding>(numbers_, s.second * count + i);
  if constexpr (format::hasRowScale(kEncoding))
    for (std::size_t i = 0; i < count; ++i) value[i] *= double{row_scale_[i]};
  const std::size_t step = channels_ == 1 ? 0 : 1;
  for (std::size_t i = 0; i < rows_; ++i) {
    const double* v = value + i * channels_;
    const Number3 colour(v[0], v[step], v[2 * step]);
    rows[i] = {colour.x, colour.y, colour.z, f64::luminanceOf(colour)};
  }
}

void Day::shapeAt(double time_h, Shape& shape) const {
  const std::size_t coefficients = format::polarCount(bands_);
  const std::size_t modes = modes_.count();
  (this->*blend_)(time_h, modes == 0 ? shape.polar.data() : shape.weight.data());
  if (modes == 0) {
    shape.horizontal_irradiance = rows_ > coefficients ? notNegative(shape.polar[coefficients]) : Number3(0.0);
    return;
  }
  std::fill_n(shape.polar.begin(), coefficients, Channels{});
  Channels horizontal{};
  for (std::size_t k = 0; k < modes; ++k) {
    const float* sh = mode_sh_.data() + k * coefficients;
    for (std::size_t i = 0; i < coefficients; ++i)
      for (std::size_t c = 0; c < 4; ++c) shape.polar[i][c] += shape.weight[k][c] * double{sh[i]};
    for (std::size_t c = 0; c < 4; ++c) horizontal[c] += shape.weight[k][c] * mode_upwards_[k];
  }
  shape.horizontal_irradiance = notNegative(horizontal);
}

}  // namespace welkin::core
