// SPDX-License-Identifier: Apache-2.0
// Mathematical constants of the shared formulas.
CONSTANT Number kPi = NUMBER(3.14159265358979323846);
CONSTANT Number kHalfPi = NUMBER(1.57079632679489661923);
CONSTANT Number kTwoPi = NUMBER(6.28318530717958647692);
CONSTANT Number kDegree = kPi / NUMBER(180.0);
