// SPDX-License-Identifier: Apache-2.0
// A closed form three ways: by the path tracer, by transfer per direction, and by what four directions reconstruct.
#pragma once

#include <array>

#include "closed_form_list.h"

namespace welkin::tests {

/// A result beside what it should be. Irradiance over pi.
struct Compared {
  Number3 found;
  Number3 standard_error;
  Number3 expected;  ///< with what the column is known to lose
  Number3 lost;      ///< expected less the exact value: the column's own stated error
};

struct ClosedFormColumns {
  std::vector<Compared> path_tracer;                     ///< asked normals, then the basis
  std::array<Compared, transfer::kDirections> transfer;  ///< directions of the basis
  std::vector<Compared> four_directions;                 ///< asked normals
};

/// By `paths` of the path tracer for each normal and of the transfer in all, those of 64 independent probes: at least
/// 64 kLeastRays.
ClosedFormColumns columnsOf(const ClosedForm& form, std::size_t paths);

/// Whether a result is within three standard errors, what the level is off by and rounding (1e-6 of the largest exact
/// value: corners are floats); exactly 0 where the form is.
bool agrees(const ClosedForm& form, const Compared& compared);

}  // namespace welkin::tests
