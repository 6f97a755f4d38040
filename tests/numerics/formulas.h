// SPDX-License-Identifier: Apache-2.0
// Every shared formula once, as calls that compile as GLSL and as C++: PUT(name, size, arguments, value) and PUT3 for a
// vector. An error counts in units of the last place of the value or of `size`, whichever is larger. `size` is 0 for a
// formula that owes its relative digits. Otherwise it is the size of the number that the value is added to or
// multiplied with. `arguments` names the arguments of body.h that matter.
#ifndef WELKIN_NUMERICS_FORMULAS_H
#define WELKIN_NUMERICS_FORMULAS_H

#define WELKIN_MODEL(a, b, c, d, e, k) LuminanceModel(NUMBER(a), NUMBER(b), NUMBER(c), NUMBER(d), NUMBER(e), NUMBER(k))

// A circle of a lobe of power 64.
#define WELKIN_CIRCLE lobeCircle(NUMBER(64.0), a, int(t * NUMBER(32.0)), 5)

#define WELKIN_FORMULAS_OF_ANGLES                                                                                   \
  PUT3(directionOf, 1.0, "az el", directionOf(azimuth_rad, angle_rad))                                              \
  PUT(sineFromCosine, 0.0, "y", sineFromCosine(up))                                                                 \
  PUT(horizontalLength, 0.0, "a", horizontalLength(a))                                                              \
  PUT(elevationOf, 0.0, "a", elevationOf(a))                                                                        \
  PUT(angleBetween, 0.0, "a b", angleBetween(a, b))                                                                 \
  PUT(angleBetween_opposite, 0.0, "a b", angleBetween(a, -b))                                                       \
  PUT3(celestialDirection, 1.0, "az el t", celestialDirection(azimuth_rad, angle_rad, t* NUMBER(1.5), NUMBER(0.7))) \
  PUT3(equatorialOf, 1.0, "a el", equatorialOf(a, angle_rad, NUMBER(0.7)))                                          \
  PUT3(starCoordinates, NUMBER(1.0) / horizontalLength(equatorialOf(a, angle_rad, NUMBER(0.7))), "a el az",         \
       starCoordinates(a, angle_rad, NUMBER(0.7), azimuth_rad))                                                     \
  PUT(discCoverage, 1.0, "s t", discCoverage(s* NUMBER(0.02), NUMBER(0.01), NUMBER(0.001) + t * NUMBER(0.01)))      \
  PUT(moonPhase, 1.0, "a b near", moonPhase(near_b, b, NUMBER(0.0047), a))                                          \
  PUT(ditherAt, 1.0, "s t", ditherAt(int(s * NUMBER(4096.0)), int(t * NUMBER(4096.0))))

#define WELKIN_FORMULAS_OF_LUMINANCE                                      \
  PUT(expMinusOne, 0.0, "x", expMinusOne(x))                              \
  PUT(gradation_clear, 0.0, "y", gradation(clear_sky, up))                \
  PUT(gradation_thin, 0.0, "y", gradation(thin, up))                      \
  PUT(gradation_overcast, 0.0, "y", gradation(overcast, up))              \
  PUT(gradation_strong, 0.0, "y", gradation(strong, up))                  \
  PUT(indicatrix_clear, 0.0, "theta", indicatrix(clear_sky, theta))       \
  PUT(indicatrix_delta, 0.0, "theta", indicatrix(delta, theta))           \
  PUT(indicatrix_strong, 0.0, "theta", indicatrix(strong, theta))         \
  PUT(constantNorm_sun, 0.0, "", constantNorm(clear_sky, true))           \
  PUT(constantNorm_zenith, 0.0, "", constantNorm(clear_sky, false))       \
  PUT(luminanceNorm_sun, 0.0, "b", luminanceNorm(clear_sky, b, true))     \
  PUT(luminanceNorm_zenith, 0.0, "b", luminanceNorm(clear_sky, b, false)) \
  PUT(relativeLuminance, 0.0, "a b", relativeLuminance(clear_sky, a, b, NUMBER(1.5)))

#define WELKIN_FORMULAS_OF_COLOUR                                                 \
  PUT(luminanceOf, 0.0, "rgb", luminanceOf(rgb))                                  \
  PUT3(normalIrradiance, 0.0, "rgb s", normalIrradiance(rgb, s))                  \
  PUT3(levelIrradiance, 0.0, "rgb b", levelIrradiance(rgb, b))                    \
  PUT3(groundRadiance, 0.0, "rgb s", groundRadiance(Number3(s), rgb))             \
  PUT3(chromaticity, 1.0, "rgb", chromaticity(rgb, NUMBER(1e-4)))                 \
  PUT3(desaturate, luminanceOf(rgb), "rgb s", desaturate(rgb, s))                 \
  PUT(srgbDecode, 0.0, "s", srgbDecode(s))                                        \
  PUT(srgbEncode, 0.0, "s", srgbEncode(s))                                        \
  PUT(gradientColumn, 64.0, "t", gradientColumn(t* NUMBER(23.999), NUMBER(64.0))) \
  PUT(gradientRow, 64.0, "el", gradientRow(angle_rad, NUMBER(64.0)))              \
  PUT(azimuthWeight, 1.0, "a b", azimuthWeight(a, b))                             \
  PUT(starFade, 1.0, "s t", starFade(s, NUMBER(0.01) + t))

#define WELKIN_FORMULAS_OF_MATERIALS                                                                          \
  PUT(powerOfGloss, 0.0, "s", powerOfGloss(s))                                                                \
  PUT(glossOfPower, 1.0, "s", glossOfPower(NUMBER(1.0) + s * NUMBER(8191.0)))                                 \
  PUT(powerOfRoughness, 0.0, "s", powerOfRoughness(s))                                                        \
  PUT(roughnessOfPower, 0.0, "s", roughnessOfPower(NUMBER(1.0) + s * NUMBER(8191.0)))                         \
  PUT(toksvigPower, 0.0, "s t", toksvigPower(NUMBER(1.0) + s * NUMBER(8191.0), t))                            \
  PUT3(halfVector, 1.0, "a b", halfVector(a, b))                                                              \
  PUT(schlickShare, 1.0, "t", schlickShare(t))                                                                \
  PUT(gaussianShare, 0.0, "t", gaussianShare(t))                                                              \
  PUT(laterGaussianShare, 0.0, "t", laterGaussianShare(t))                                                    \
  PUT3(fresnel, 0.0, "rgb t", fresnel(rgb, t))                                                                \
  PUT(blinnPhong, NUMBER(1.0) + s * NUMBER(8191.0), "s t", blinnPhong(NUMBER(1.0) + s * NUMBER(8191.0), t))   \
  PUT(smithRoughness, 0.0, "s", smithRoughness(NUMBER(1.0) + s * NUMBER(8191.0)))                             \
  PUT(schlickSmith, 0.0, "s t y", schlickSmith(NUMBER(0.0124) + s * NUMBER(0.6), t, up))                      \
  PUT(meanVisibility, 0.0, "s", meanVisibility(NUMBER(0.0124) + s * NUMBER(0.9876)))                          \
  PUT(meanFactor, 0.0, "s", meanFactor(s))                                                                    \
  PUT(fittedFactor, 0.0, "s", fittedFactor(s))                                                                \
  PUT(linearFactor, 0.0, "s", linearFactor(NUMBER(1.0) + s * NUMBER(8191.0), NUMBER(4.0), NUMBER(-1.0)))      \
  PUT(shippedFactor, 0.0, "s", shippedFactor(NUMBER(1.0) + s * NUMBER(8191.0)))                               \
  PUT3(shippedSpecular, NUMBER(100.0), "a b rgb", shippedSpecular(rgb, NUMBER(64.0), a, b, near_b))           \
  PUT3(schlickSmithSpecular, NUMBER(100.0), "a b rgb", schlickSmithSpecular(rgb, NUMBER(64.0), a, b, near_b)) \
  PUT3(lambert, 0.0, "rgb", lambert(rgb))                                                                     \
  PUT(wrappedDiffuse, 1.0, "theta s", wrappedDiffuse(cos(theta), s))                                          \
  PUT(wrappedDiffusePower, 1.0, "theta s t", wrappedDiffusePower(cos(theta), s, t* NUMBER(8.0)))              \
  PUT(halfLambert, 1.0, "theta", halfLambert(cos(theta)))                                                     \
  PUT(sloanWrapped, 1.0, "theta s", sloanWrapped(cos(theta), s))                                              \
  PUT(mipOfGloss, 8.0, "s", mipOfGloss(s, NUMBER(9.0)))                                                       \
  PUT(glossOfMip, 1.0, "s", glossOfMip(s* NUMBER(8.0), NUMBER(9.0)))                                          \
  PUT(whiteShare, 0.0, "s t", whiteShare(NUMBER(1.0) + s * NUMBER(8191.0), t))                                \
  PUT(meanSchlickShare, 1.0, "s t", meanSchlickShare(NUMBER(1.0) + s * NUMBER(8191.0), t))                    \
  PUT3(reflectedShare, 1.0, "rgb s t", reflectedShare(rgb, NUMBER(1.0) + s * NUMBER(8191.0), t))              \
  PUT3(openShare, 0.0, "rgb s", openShare(rgb, Number3(NUMBER(0.1) + s)))                                     \
  PUT3(specularColourOf, 0.0, "rgb s", specularColourOf(rgb, s))                                              \
  PUT3(diffuseColourOf, 0.0, "rgb s", diffuseColourOf(rgb, s))                                                \
  PUT(lobeHalfEnd, 0.0, "s", lobeHalfEnd(NUMBER(1.0) + s * NUMBER(8191.0)))                                   \
  PUT(lobeCircle_cosine, 1.0, "a s t", WELKIN_CIRCLE.cosine)                                                  \
  PUT(lobeCircle_sine, 1.0, "a s t", WELKIN_CIRCLE.sine)                                                      \
  PUT(lobeCircle_weight, 1.0, "a s t", WELKIN_CIRCLE.weight)                                                  \
  PUT(lobeCircle_turn, 1.0, "a s t", WELKIN_CIRCLE.turn)                                                      \
  PUT3(lobeDirection, 1.0, "a s t", lobeDirection(WELKIN_CIRCLE, a, int(s * NUMBER(16.0)), 5))

#endif
