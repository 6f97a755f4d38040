// SPDX-License-Identifier: Apache-2.0
// Luminance, chromaticity and desaturation of linear Rec. 709 colour, and the sRGB encoding.

// Relative luminance of linear Rec. 709 (ITU-R BT.709, rounded coefficients that add up to 1).
INLINE Number luminanceOf(Number3 rgb) {
  return NUMBER(0.2126) * rgb.x + NUMBER(0.7152) * rgb.y + NUMBER(0.0722) * rgb.z;
}

// Colour of luminance 1 with the hue and saturation of `rgb` (components >= 0). Exact for a luminance of at least
// `delta` > 0. Below that it fades continuously to neutral (1, 1, 1) at black.
INLINE Number3 chromaticity(Number3 rgb, Number delta) {
  Number y = luminanceOf(rgb);
  return (rgb + Number3(max(delta - y, NUMBER(0.0)))) / max(y, delta);
}

// `saturation` in [0, 1]: 1 keeps the colour, 0 leaves its luminance. Linear in rgb, so it applies to SH coefficients.
INLINE Number3 desaturate(Number3 rgb, Number saturation) {
  Number3 grey = Number3(luminanceOf(rgb));
  return grey + (rgb - grey) * saturation;
}

// IEC 61966-2-1 (sRGB): decodes an encoded value, encodes a linear one. Both are in [0, 1].
INLINE Number srgbDecode(Number encoded) {
  if (encoded <= NUMBER(0.04045)) return encoded / NUMBER(12.92);
  return pow((encoded + NUMBER(0.055)) / NUMBER(1.055), NUMBER(2.4));
}

INLINE Number srgbEncode(Number linear) {
  if (linear <= NUMBER(0.0031308)) return linear * NUMBER(12.92);
  return NUMBER(1.055) * pow(linear, NUMBER(1.0) / NUMBER(2.4)) - NUMBER(0.055);
}
