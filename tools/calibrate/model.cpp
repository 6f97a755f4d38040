// SPDX-License-Identifier: Apache-2.0
#include "calibrate/model.h"

#include <algorithm>
#include <array>
#include <string>

#include "calibrate/affine_cubic.h"
#include "calibrate/curve_models.h"
#include "calibrate/matrix_models.h"

namespace welkin::calibrate {
namespace {

constexpr std::array<ModelKind, 5> kModels = {{
    {"aca", fitAffineCubic, applyAffineCubic, kAffineCubicNumbers},
    {"3x3", fitMatrix, applyMatrix, kMatrixNumbers},
    {"root-polynomial", fitRootPolynomial, applyRootPolynomial, kRootPolynomialNumbers},
    {"curve-affine", fitCurveAffine, applyCurveAffine, kCurveAffineNumbers},
    {"curve-root", fitCurveRoot, applyCurveRoot, kCurveRootNumbers},
}};

}  // namespace

std::span<const ModelKind> models() {
  return kModels;
}

const ModelKind* modelNamed(std::string_view name) {
  const auto found = std::find_if(kModels.begin(), kModels.end(), [&](const ModelKind& m) { return name == m.name; });
  return found == kModels.end() ? nullptr : &*found;
}

std::string_view modelNames() {
  static const std::string kNames = [] {
    std::string names;
    for (const ModelKind& m : kModels) names += (names.empty() ? "" : ", ") + std::string(m.name);
    return names;
  }();
  return kNames;
}

}  // namespace welkin::calibrate
