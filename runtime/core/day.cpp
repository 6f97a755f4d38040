// SPDX-License-Identifier: Apache-2.0
#include "core/day.h"

#include <algorithm>

#include "core/sky.h"
#include "format/day_numbers.h"
#include "format/key_segment.h"

namespace welkin::core {

using f64::Number3;
using format::Encoding;

namespace {

Number3 notNegative(const Number3& v) {
  return {std::max(v.x, 0.0), std::max(v.y, 0.0), std::max(v.z, 0.0)};
}

}  // namespace

std::array<double, kMostModes> ModeMap::at(double column, double row) const {
  const double across = column * static_cast<double>(columns_ - 1);
  const double upwards = row * static_cast<double>(rows_ - 1);
  const auto left = static_cast<std::size_t>(across);
  const auto low = static_cast<std::size_t>(upwards);
  const std::size_t right = std::min(left + 1, columns_ - 1);
  const std::size_t high = std::min(low + 1, rows_ - 1);
  const double x = across - static_cast<double>(left);
  const double t = upwards - static_cast<double>(low);
  const auto texel = [&](std::size_t i, std::size_t j, std::size_t k) {
    return double{format::floatFromHalf(texels_[(j * columns_ + i) * count_ + k])};
  };
  std::array<double, kMostModes> value{};
  for (std::size_t k = 0; k < count_; ++k)
    value[k] = (1.0 - t) * ((1.0 - x) * texel(left, low, k) + x * texel(right, low, k)) +
               t * ((1.0 - x) * texel(left, high, k) + x * texel(right, high, k));
  return value;
}

Day::Day(const format::Day& day) : day_(&day), bands_(day.bands()), rows_(day.rows()) {
  if (day.modes() != nullptr) modes_ = ModeMap(*day.modes());
}

template <Encoding kEncoding>
void Day::blend(double time_h, Rows& rows) const {
  const auto s = format::findSegment(spanOf(day_->key_time_h()), time_h);
  double weight[2] = {1.0 - s.weight, s.weight};
  if constexpr (format::hasKeyScale(kEncoding)) {
    weight[0] *= double{day_->key_scale()->Get(static_cast<flatbuffers::uoffset_t>(s.first))};
    weight[1] *= double{day_->key_scale()->Get(static_cast<flatbuffers::uoffset_t>(s.second))};
  }
  const std::uint8_t* numbers = day_->numbers()->data();
  const std::size_t channels = day_->channels();
  const std::size_t count = rows_ * channels;
  for (std::size_t i = 0; i < count; ++i) {
    double value = weight[0] * format::storedNumber<kEncoding>(numbers, s.first * count + i) +
                   weight[1] * format::storedNumber<kEncoding>(numbers, s.second * count + i);
    if constexpr (format::hasRowScale(kEncoding))
      value *= double{day_->row_scale()->Get(static_cast<flatbuffers::uoffset_t>(i))};
    if (channels == 1)
      rows[i] = Number3(value);
    else
      rows[i / 3][static_cast<int>(i % 3)] = value;
  }
}

void Day::shapeAt(double time_h, Shape& shape) const {
  Rows rows;
  switch (day_->encoding()) {
    case Encoding::float32:
      blend<Encoding::float32>(time_h, rows);
      break;
    case Encoding::float16:
      blend<Encoding::float16>(time_h, rows);
      break;
    case Encoding::fixed16:
      blend<Encoding::fixed16>(time_h, rows);
      break;
    case Encoding::fixed8:
      blend<Encoding::fixed8>(time_h, rows);
      break;
  }
  const std::size_t coefficients = format::polarCount(bands_);
  if (modes_.count() == 0) {
    std::copy_n(rows.begin(), coefficients, shape.polar.begin());
    if (rows_ > coefficients) shape.horizontal_irradiance = notNegative(rows[coefficients]);
    return;
  }
  std::copy_n(rows.begin(), modes_.count(), shape.weight.begin());
  const float* of_mode = day_->modes()->polar_sh()->data();
  for (std::size_t i = 0; i < coefficients; ++i) {
    Number3 sum(0.0);
    for (std::size_t k = 0; k < modes_.count(); ++k) sum += rows[k] * double{of_mode[k * coefficients + i]};
    shape.polar[i] = sum;
  }
  const auto up = modes_.at(0.5, 1.0);
  Number3 horizontal(0.0);
  for (std::size_t k = 0; k < modes_.count(); ++k) horizontal += rows[k] * up[k];
  shape.horizontal_irradiance = notNegative(horizontal);
}

}  // namespace welkin::core
