// SPDX-License-Identifier: Apache-2.0
// The ambient light of a sample in the forms and axes of other engines (docs/engines.md). All functions are pure.
//
// Three bands of irradiance are a polynomial of degree 2 of the normal. An engine's axes permute and mirror the
// normal's components, and with them the polynomial's terms; each engine then wants its terms in an order and with
// signs of its own.
#include <welkin/engines.h>

#include <array>
#include <cstddef>

#include "core/arguments.h"
#include "core/floats.h"
#include "core/sky.h"

namespace welkin::core {
namespace {

/// Coefficients of the nine terms 1, y, z, x, xy, yz, 3 z^2 - 1, zx, x^2 - y^2.
using Terms = std::array<double, 9>;

/// Component i of a converted vector is `sign` times component `axis` of the vector.
struct Component {
  int axis;
  double sign;
};

/// The components of a vector in an engine's axes; null for other numbers than those of WelkinAxes.
const Component* componentsOf(WelkinAxes axes) {
  static constexpr Component kAxes[4][3] = {{{0, 1.0}, {1, 1.0}, {2, 1.0}},
                                            {{0, 1.0}, {1, 1.0}, {2, -1.0}},
                                            {{0, -1.0}, {1, 1.0}, {2, 1.0}},
                                            {{0, 1.0}, {2, 1.0}, {1, 1.0}}};
  const auto index = static_cast<std::uint32_t>(axes);
  return index < 4 ? kAxes[index] : nullptr;
}

/// WELKIN_OK if `to` is one of the axes, and neither struct is null.
WelkinResult checkPacking(const char* function, const Component* to, const WelkinSkySample* sample,
                          const void* packed) {
  if (const auto r = checkSample(function, "sample", sample)) return r;
  if (const auto r = nonNull(function, {{"packed", packed}})) return r;
  return to != nullptr ? WELKIN_OK : refuse(function, "axes must be one of WelkinAxes");
}

/// Constants of the basis functions, by which a coefficient becomes that of a term.
constexpr double kBasis[9] = {f64::kShConstant, f64::kShLinear, f64::kShLinear,  f64::kShLinear,    f64::kShProduct,
                              f64::kShProduct,  f64::kShZonal,  f64::kShProduct, f64::kShDifference};

/// Terms of the radiance of a channel.
Terms radianceTerms(const WelkinSkySample& sample, int channel) {
  Terms terms{};
  for (std::uint32_t i = 0; i < 9 && i < sample.coefficient_count; ++i)
    terms[i] = double{sample.ambient_sh[i][channel]} * kBasis[i];
  return terms;
}

/// Terms of the irradiance over pi: radiance coefficient x A_l / pi x the constant of the basis.
Terms irradianceTerms(const WelkinSkySample& sample, int channel) {
  Terms terms{};
  for (std::uint32_t i = 0; i < 9 && i < sample.coefficient_count; ++i)
    terms[i] = double{sample.ambient_sh[i][channel]} * f64::cosineLobe(bandOf(i)) / f64::kPi * kBasis[i];
  return terms;
}

/// The same polynomial of a vector in an engine's axes. A unit vector's squares sum to 1: 3 z^2 - 1 = 2 z^2 - x^2 -
/// y^2.
Terms converted(const Terms& t, const Component* to) {
  const double linear[3] = {t[3], t[1], t[2]};
  const double square[3] = {t[8] - t[6], -t[8] - t[6], 2.0 * t[6]};
  const double product[3] = {t[5], t[7], t[4]};  // yz, zx, xy: each at the component that it leaves out
  double l[3], s[3], p[3];
  for (int i = 0; i < 3; ++i) {
    l[i] = to[i].sign * linear[to[i].axis];
    s[i] = square[to[i].axis];
    p[i] = to[(i + 1) % 3].sign * to[(i + 2) % 3].sign * product[to[i].axis];
  }
  const bool same_z = to[2].axis == 2;  // x and y are the same then, too: keep the bits of both terms
  return {t[0], l[1], l[2], l[0], p[2], p[0], same_z ? t[6] : 0.5 * s[2], p[1], same_z ? t[8] : 0.5 * (s[0] - s[1])};
}

/// Writes a channel's terms as the vectors of the form that Unity and Unreal share.
void storeVectors(const Terms& t, float first[4], float second[4], float& difference) {
  const double a[4] = {t[3], t[1], t[2], t[0] - t[6]};
  const double b[4] = {t[4], t[5], 3.0 * t[6], t[7]};
  store(a, 4, first);
  store(b, 4, second);
  difference = toFloat(t[8]);
}

void storeVectors(const WelkinSkySample& sample, const Component* axes, float vectors[7][4]) {
  for (int c = 0; c < 3; ++c)
    storeVectors(converted(irradianceTerms(sample, c), axes), vectors[c], vectors[3 + c], vectors[6][c]);
  vectors[6][3] = 1.0F;
}

}  // namespace
}  // namespace welkin::core

WelkinResult welkin_axes_vector(WelkinAxes axes, const float vector[3], float converted[3]) {
  using namespace welkin::core;
  const Component* to = componentsOf(axes);
  if (const auto r = nonNull(__func__, {{"vector", vector}, {"converted", converted}})) return r;
  if (to == nullptr) return refuse(__func__, "axes is %d, must be one of WelkinAxes", static_cast<int>(axes));
  const float from[3] = {vector[0], vector[1], vector[2]};
  for (int i = 0; i < 3; ++i) converted[i] = to[i].sign < 0.0 ? -from[to[i].axis] : from[to[i].axis];
  return WELKIN_OK;
}

WelkinResult welkin_pack_radiance(const WelkinSkySample* sample, WelkinAxes axes, WelkinRadianceSh* packed) {
  using namespace welkin::core;
  const Component* to = componentsOf(axes);
  if (const auto r = checkPacking(__func__, to, sample, packed)) return r;
  for (int c = 0; c < 3; ++c) {
    const Terms terms = converted(radianceTerms(*sample, c), to);
    for (std::size_t i = 0; i < 9; ++i) packed->sh[i][c] = toFloat(terms[i] / kBasis[i]);
  }
  return WELKIN_OK;
}

WelkinResult welkin_pack_filament(const WelkinSkySample* sample, WelkinFilamentIrradianceOverPi* packed) {
  using namespace welkin::core;
  if (const auto r = checkPacking(__func__, componentsOf(WELKIN_AXES_WELKIN), sample, packed)) return r;
  for (int c = 0; c < 3; ++c) {
    const Terms terms = irradianceTerms(*sample, c);
    for (std::size_t i = 0; i < 9; ++i) packed->sh[i][c] = toFloat(terms[i]);
  }
  return WELKIN_OK;
}

WelkinResult welkin_pack_filament_radiance(const WelkinSkySample* sample, WelkinFilamentRadiance* packed) {
  using namespace welkin::core;
  if (const auto r = checkPacking(__func__, componentsOf(WELKIN_AXES_WELKIN), sample, packed)) return r;
  for (std::uint32_t i = 0; i < 9; ++i) {
    const bool odd_m = i % 2 != 0;  // l (l + 1) is even, so the index is odd where m is
    for (int c = 0; c < 3; ++c) {
      const float value = i < sample->coefficient_count ? sample->ambient_sh[i][c] : 0.0F;
      packed->sh[i][c] = odd_m ? -value : value;
    }
  }
  return WELKIN_OK;
}

WelkinResult welkin_pack_unity_axes(const WelkinSkySample* sample, WelkinAxes axes,
                                    WelkinUnityIrradianceOverPi* packed) {
  using namespace welkin::core;
  const Component* to = componentsOf(axes);
  if (const auto r = checkPacking(__func__, to, sample, packed)) return r;
  float* const first[3] = {packed->shar, packed->shag, packed->shab};
  float* const second[3] = {packed->shbr, packed->shbg, packed->shbb};
  for (int c = 0; c < 3; ++c)
    storeVectors(converted(irradianceTerms(*sample, c), to), first[c], second[c], packed->shc[c]);
  packed->shc[3] = 1.0F;
  return WELKIN_OK;
}

WelkinResult welkin_pack_unity(const WelkinSkySample* sample, WelkinUnityIrradianceOverPi* packed) {
  return welkin_pack_unity_axes(sample, WELKIN_AXES_WELKIN, packed);
}

WelkinResult welkin_pack_unity_probe(const WelkinSkySample* sample, WelkinAxes axes, WelkinUnityProbe* packed) {
  using namespace welkin::core;
  const Component* to = componentsOf(axes);
  if (const auto r = checkPacking(__func__, to, sample, packed)) return r;
  for (int c = 0; c < 3; ++c) store(converted(irradianceTerms(*sample, c), to).data(), 9, packed->sh[c]);
  return WELKIN_OK;
}

WelkinResult welkin_pack_unreal(const WelkinSkySample* sample, WelkinUnrealIrradianceOverPi* packed) {
  using namespace welkin::core;
  if (const auto r = checkPacking(__func__, componentsOf(WELKIN_AXES_WELKIN), sample, packed)) return r;
  storeVectors(*sample, componentsOf(WELKIN_AXES_UNREAL), packed->vectors);
  return WELKIN_OK;
}

WelkinResult welkin_pack_godot(const WelkinSkySample* sample, WelkinGodotIrradianceOverPi* packed) {
  using namespace welkin::core;
  if (const auto r = checkPacking(__func__, componentsOf(WELKIN_AXES_WELKIN), sample, packed)) return r;
  storeVectors(*sample, componentsOf(WELKIN_AXES_WELKIN), packed->vectors);
  for (std::uint32_t i = 0; i < 9; ++i) {
    for (int c = 0; c < 3; ++c)
      packed->probe[i][c] =
          i < sample->coefficient_count ? toFloat(double{sample->ambient_sh[i][c]} / welkin::f64::kPi) : 0.0F;
    packed->probe[i][3] = 1.0F;
  }
  return WELKIN_OK;
}
