// SPDX-License-Identifier: Apache-2.0
// The sixth axis of a study: cost and accuracy of integrating the sky.
#pragma once

#include "study/report.h"
#include "study/study_day.h"

namespace welkin::study {

/// SkyProjector under a tolerance, five bands.
struct QuadratureRow {
  double tolerance = 0.0;
  double evaluations = 0.0;  ///< evaluations of the radiance a key, on average
  double error = 0.0;        ///< largest difference of a coefficient from those under 1e-12, over c0
  double key_s = 0.0;        ///< on one thread
};

/// Irradiance of all normals of the study's grid at one instant.
struct IrradianceRow {
  std::string method;
  double error = 0.0;      ///< largest difference from direct integration under 1e-9, over the mean
  double instant_s = 0.0;  ///< on one thread
};

struct QuadratureStudy {
  std::vector<QuadratureRow> quadrature;
  std::vector<IrradianceRow> irradiance;
};

QuadratureStudy measureQuadrature(const StudyDay& day, const StudyOptions& options);

/// Adds the tables "quadrature" and "irradiance" and the chart "quadrature".
void reportQuadrature(const QuadratureStudy& study, StudyReport& report);

}  // namespace welkin::study
