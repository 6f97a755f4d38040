// SPDX-License-Identifier: Apache-2.0
// Traps of floating-point arithmetic for a run of the unit tests.
#pragma once

namespace welkin::tests {

/// From now on an invalid operation, a division by zero or an overflow ends the program and names the place, in this
/// thread and in those that it makes. Instructions of shared libraries pass: SLEEF, Embree, OpenImageIO and Mesa reckon
/// with infinities and with lanes that nobody reads.
void trapFloatingPointFaults();

}  // namespace welkin::tests
