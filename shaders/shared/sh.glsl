// SPDX-License-Identifier: Apache-2.0
// Real spherical harmonics up to 5 bands: orthonormal, no Condon-Shortley phase, world axes, index l (l + 1) + m.
// Sloan, "Stupid Spherical Harmonics Tricks" (GDC 2008), appendix A2, with the signs of odd m made positive.

// Constants of the first three bands, for 1; x, y, z; xy, yz, zx; 3 z^2 - 1; x^2 - y^2.
CONSTANT Number kShConstant = NUMBER(0.28209479177387814347);
CONSTANT Number kShLinear = NUMBER(0.48860251190291992159);
CONSTANT Number kShProduct = NUMBER(1.09254843059207907054);
CONSTANT Number kShZonal = NUMBER(0.31539156525252000603);
CONSTANT Number kShDifference = NUMBER(0.54627421529603953527);

// Values of the 25 basis functions of bands l = 0..4.
struct ShBasis {
  Number v[25];
};

INLINE ShBasis shBasis(Number3 n) {
  Number x2 = n.x * n.x;
  Number y2 = n.y * n.y;
  Number z2 = n.z * n.z;
  ShBasis basis;
  basis.v[0] = kShConstant;
  basis.v[1] = kShLinear * n.y;
  basis.v[2] = kShLinear * n.z;
  basis.v[3] = kShLinear * n.x;
  basis.v[4] = kShProduct * n.x * n.y;
  basis.v[5] = kShProduct * n.y * n.z;
  basis.v[6] = kShZonal * (NUMBER(3.0) * z2 - NUMBER(1.0));
  basis.v[7] = kShProduct * n.x * n.z;
  basis.v[8] = kShDifference * (x2 - y2);
  basis.v[9] = NUMBER(0.59004358992664351035) * n.y * (NUMBER(3.0) * x2 - y2);
  basis.v[10] = NUMBER(2.89061144264055405539) * n.x * n.y * n.z;
  basis.v[11] = NUMBER(0.45704579946446573616) * n.y * (NUMBER(5.0) * z2 - NUMBER(1.0));
  basis.v[12] = NUMBER(0.37317633259011539141) * n.z * (NUMBER(5.0) * z2 - NUMBER(3.0));
  basis.v[13] = NUMBER(0.45704579946446573616) * n.x * (NUMBER(5.0) * z2 - NUMBER(1.0));
  basis.v[14] = NUMBER(1.44530572132027702770) * n.z * (x2 - y2);
  basis.v[15] = NUMBER(0.59004358992664351035) * n.x * (x2 - NUMBER(3.0) * y2);
  basis.v[16] = NUMBER(2.50334294179670453835) * n.x * n.y * (x2 - y2);
  basis.v[17] = NUMBER(1.77013076977993053104) * n.y * n.z * (NUMBER(3.0) * x2 - y2);
  basis.v[18] = NUMBER(0.94617469575756001809) * n.x * n.y * (NUMBER(7.0) * z2 - NUMBER(1.0));
  basis.v[19] = NUMBER(0.66904654355728916795) * n.y * n.z * (NUMBER(7.0) * z2 - NUMBER(3.0));
  basis.v[20] = NUMBER(0.10578554691520430380) * (NUMBER(35.0) * z2 * z2 - NUMBER(30.0) * z2 + NUMBER(3.0));
  basis.v[21] = NUMBER(0.66904654355728916795) * n.x * n.z * (NUMBER(7.0) * z2 - NUMBER(3.0));
  basis.v[22] = NUMBER(0.47308734787878000905) * (x2 - y2) * (NUMBER(7.0) * z2 - NUMBER(1.0));
  basis.v[23] = NUMBER(1.77013076977993053104) * n.x * n.z * (x2 - NUMBER(3.0) * y2);
  basis.v[24] = NUMBER(0.62583573544917613459) * (x2 * (x2 - NUMBER(3.0) * y2) - y2 * (NUMBER(3.0) * x2 - y2));
  return basis;
}

// Factor A_l that turns the radiance coefficients of band l = 0..4 into irradiance, pi included: pi, 2 pi/3, pi/4, 0,
// -pi/24. Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps" (2001), eq. 8.
INLINE Number cosineLobe(int band) {
  if (band == 0) return kPi;
  if (band == 1) return kTwoPi / NUMBER(3.0);
  if (band == 2) return kPi / NUMBER(4.0);
  if (band == 4) return -kPi / NUMBER(24.0);
  return NUMBER(0.0);
}

// Factor of band l = 0..4 for a radiance of 1 below the horizon and 0 above, whose coefficients are groundLobe(l)
// Y_lm(up). These are the Funk-Hecke factors of the lower hemisphere: 2 pi times the integral of the Legendre
// polynomial over [-1, 0].
INLINE Number groundLobe(int band) {
  if (band == 0) return kTwoPi;
  if (band == 1) return -kPi;
  if (band == 3) return kPi / NUMBER(4.0);
  return NUMBER(0.0);
}
