// SPDX-License-Identifier: Apache-2.0
// The day's irradiance at many hours, and the measure of its error. Tables are planned from it and measured against it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sky/model/irradiance.h"
#include "sky/table/day_table.h"

namespace welkin::table {

using det::Number3;

/// One channel of an IrradianceField, or a mode of such fields.
struct FieldChannel {
  std::vector<double> series;
  std::array<double, 15> moment{};  ///< polarIndex, five bands

  FieldChannel() : series(model::IrradianceProjector::kRows * model::IrradianceProjector::kOrders) {}
  FieldChannel(const model::IrradianceField& field, int channel);
  FieldChannel& add(const FieldChannel& other, double factor);
};

/// The normals at which tables are compared, on one side of the sun's vertical plane. Azimuths are every 11.25 degrees.
/// Rows of elevation lie between the rows of any map of modes, above the horizon, with their opposites below it.
class ErrorGrid {
 public:
  ErrorGrid();
  std::size_t count() const { return 2 * rows_.size() * kColumns; }
  struct Normal {
    double y, cos_alpha;
    Number3 inSunFrame() const;  ///< x across, y up, z towards the sun's azimuth
  };
  Normal normal(std::size_t point) const;
  double y(std::size_t point) const;  ///< y of that normal
  /// Irradiance at every normal: the upper ones first, by row and column, then their opposites in the same order.
  std::vector<double> valuesOf(const FieldChannel& channel) const;
  /// Appends the lower normals, given the values of the upper ones and the two coefficients of n . V.
  void addLower(std::vector<double>& upper, double vector_up, double vector_along) const;

  static constexpr int kColumns = 17;

 private:
  std::vector<int> rows_;
  std::vector<double> row_y_;
  std::vector<double> cosine_;  ///< cos(m alpha): column, order
};

/// The sky at an hour, and the divisor of its irradiance errors.
struct DayInstant {
  double time_h = 0.0;
  model::IrradianceField field;
  double intensity = 1.0;
  double saturation = 1.0;
  Number3 mean{0.0};     ///< by channel: ambient irradiance over all normals, ground included, after desaturation
  Number3 divisor{0.0};  ///< by channel; docs/conventions.md, "Irradiance error"; 0 only where the whole day is black
};

struct DayFields {
  const model::Sky* sky = nullptr;
  std::vector<DayInstant> instant;  ///< ascending times

  /// The largest error of an instant over normals and channels. `shape` is the error of the shape at intensity 1 at
  /// the grid's normals, by channel; `horizontal` is the error of the horizontal irradiance.
  struct Error {
    double value = 0.0;
  };
  Error errorOf(const DayInstant& at, const ErrorGrid& grid, std::span<const Number3> shape,
                const Number3& horizontal) const;
};

/// The divisor of irradiance errors where the irradiance has that mean over the normals. `brightest`: of the day.
Number3 divisorOf(const Number3& mean, double brightest);

/// The largest divisor of the day, by quarter hours. Far darker instants are divided by a share of it.
double brightestOf(const model::Sky& sky);

/// Samples the day in parallel. The bits are the same for any number of threads. `time_h` ascends; `brightest` is
/// brightestOf.
DayFields sampleDay(const model::Sky& sky, const std::vector<double>& time_h, double brightest,
                    const base::Progress& progress, const model::IrradianceRule& rule = model::kIrradianceRules[0]);

/// Hours at which a day bends or is worth checking: every `step_h` hours, the keys of the sun's path, and the sun's
/// rising, setting, highest and lowest instants to the second.
std::vector<double> hoursOfInterest(const model::Sky& sky, double step_h);

}  // namespace welkin::table
