// SPDX-License-Identifier: Apache-2.0
// Computes a closed form in three ways: by the path tracer, by transfer per direction, and by reconstruction from four
// directions.
#pragma once

#include <array>

#include "closed_form_list.h"

namespace welkin::tests {

/// A result and its expected value. Irradiance over pi.
struct Compared {
  Number3 found;
  Number3 standard_error;
  Number3 expected;  ///< includes the column's known loss
  Number3 lost;      ///< expected less the exact value: the column's own stated error
};

struct ClosedFormColumns {
  std::vector<Compared> path_tracer;                     ///< asked normals, then the basis
  std::array<Compared, transfer::kDirections> transfer;  ///< directions of the basis
  std::vector<Compared> four_directions;                 ///< asked normals
};

/// Uses `paths` paths of the path tracer for each normal. The transfer takes as many in all, from 64 independent
/// probes: at least 64 kLeastRays.
ClosedFormColumns columnsOf(const ClosedForm& form, std::size_t paths);

/// Whether a result is within three standard errors, the level's own error, and rounding (1e-6 of the largest exact
/// value, as corners are floats). Exactly 0 where the form is 0.
bool agrees(const ClosedForm& form, const Compared& compared);

}  // namespace welkin::tests
