// SPDX-License-Identifier: Apache-2.0
// Irradiance of every normal at once. On a circle of constant elevation the sky is a cosine series of the azimuth from
// the sun's; the clipped cosine of a surface is one too, in closed form (the Fourier coefficients of max(0, a + b
// cos)). So irradiance is a sum over circles of products of the two: exact at the clip, without kernels of spherical
// harmonics, whose series converges slowly for a bright horizon.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sky/model/projection.h"

namespace welkin::model {

using det::Number3;

/// Irradiance at intensity 1, pi included, without ground, sun and moon, of normals in the frame of the sun's azimuth:
/// of row r and azimuth alpha from the sun's the sum over orders m of series[r orders + m] cos(m alpha).
struct IrradianceField {
  std::vector<Number3> series;
  Number3 mean;          ///< over all normals
  PolarMoments moments;  ///< of the same quadrature, in five bands

  /// n . V of a normal with component y and azimuth alpha from the sun's: by what it exceeds its opposite.
  Number3 excess(double y, double cos_alpha) const;
};

/// How fine the circles lie: panels of elevation at the least, further ones where the sky bends.
struct IrradianceRule {
  int panels;
  /// Largest error of a row's series, over the mean, for every named model and sun elevation: the finest against direct
  /// integration, the others against circles four times as fine as that (tests/sky/irradiance_test.cpp).
  double error;
};
/// From the finest to the least work; the first is what certificates compare with.
inline constexpr IrradianceRule kIrradianceRules[] = {{12, 8e-5}, {4, 2.3e-4}, {2, 1e-3}};

/// The source of a table's moments.
struct Quadrature {
  double tolerance = kTolerance;            ///< of SkyProjector
  const IrradianceRule* circles = nullptr;  ///< those of IrradianceProjector instead
};

/// The least work whose error is at most `error`; the finest when none's is.
const IrradianceRule& irradianceRuleFor(double error);

/// Immutable after construction; fieldOf may be called from many threads. The same bits everywhere.
class IrradianceProjector {
 public:
  /// Elevations of the upper normals, from the horizon to the zenith: rows of y, the sine of the elevation, evenly
  /// spaced in modeRow (shaders/shared/modes.glsl). A lower normal has what its opposite has less n . V.
  static constexpr int kRows = 49;
  static constexpr int kOrders = 24;
  static constexpr int kBands = 5;
  static constexpr double kError = kIrradianceRules[0].error;

  explicit IrradianceProjector(const LuminanceModel& model, const IrradianceRule& rule = kIrradianceRules[0]);

  IrradianceField fieldOf(const SkyInstant& instant) const;
  /// What the orders that are left out may add, over that channel's mean: as a sum of falling powers of the order, from
  /// m^-4, as at a conical cusp, to m^-2, as at the edge of a lobe that kOrders do not resolve. An estimate from the
  /// last orders and those of half their number: 1 to 4 times the error found (tests/sky/irradiance_test.cpp).
  double truncationOf(const IrradianceField& field, int channel) const;
  double rowY(int row) const { return row_[static_cast<std::size_t>(row)].y; }

 private:
  struct Row {
    double y, across;  ///< sine and cosine of the normal's elevation
  };
  void addCircle(const Latitude& at, const std::vector<Number3>& order, IrradianceField& field) const;
  void addClipped(const Latitude& at, double weight, std::array<std::size_t, 2> row, const std::vector<Number3>& order,
                  IrradianceField& field) const;

  std::vector<Row> row_;
  std::vector<double> extra_;  ///< elevations of further panels: the clip may lie anywhere
  HemisphereQuadrature quadrature_;
  sh::LatitudeRecurrence recurrence_;
  std::optional<IndicatrixTable> table_;
};

/// Values cos(m alpha) of `orders` orders at `columns` azimuths 0..pi, evenly spaced: order-major rows of a column.
std::vector<double> azimuthCosines(int columns, int orders);

}  // namespace welkin::model
