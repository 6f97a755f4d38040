// SPDX-License-Identifier: Apache-2.0
#include "study/spirv_arithmetic.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <cmath>

namespace welkin::study {
namespace {

using spv::Op;

TraceNumber known(double value) {
  return {true, value, 0};
}
TraceNumber knownFloat(double value) {
  return known(static_cast<double>(static_cast<float>(value)));
}

bool is(const TraceNumber& number, double value) {
  return number.known && number.value == value;
}

std::optional<TraceNumber> ofKnownLibrary(std::uint32_t function, const std::vector<TraceNumber>& x) {
  switch (function) {
    case GLSLstd450FAbs:
    case GLSLstd450SAbs:
      return known(std::abs(x[0].value));
    case GLSLstd450FMin:
    case GLSLstd450SMin:
    case GLSLstd450UMin:
      return known(std::min(x[0].value, x[1].value));
    case GLSLstd450FMax:
    case GLSLstd450SMax:
    case GLSLstd450UMax:
      return known(std::max(x[0].value, x[1].value));
    case GLSLstd450Fma:
      return knownFloat(x[0].value * x[1].value + x[2].value);
    default:
      return std::nullopt;
  }
}

std::optional<TraceNumber> ofKnownPair(Op op, double a, double b) {
  switch (op) {
    case Op::OpFAdd:
      return knownFloat(a + b);
    case Op::OpFSub:
      return knownFloat(a - b);
    case Op::OpFMul:
    case Op::OpVectorTimesScalar:
      return knownFloat(a * b);
    case Op::OpFDiv:
      return knownFloat(a / b);
    case Op::OpIAdd:
      return known(a + b);
    case Op::OpISub:
      return known(a - b);
    case Op::OpIMul:
      return known(a * b);
    case Op::OpSDiv:
    case Op::OpUDiv:
      if (b == 0.0) return std::nullopt;
      return known(std::trunc(a / b));
    case Op::OpIEqual:
    case Op::OpFOrdEqual:
    case Op::OpLogicalEqual:
      return known(a == b ? 1.0 : 0.0);
    case Op::OpINotEqual:
    case Op::OpFOrdNotEqual:
    case Op::OpFUnordNotEqual:
    case Op::OpLogicalNotEqual:
      return known(a != b ? 1.0 : 0.0);
    case Op::OpSLessThan:
    case Op::OpULessThan:
    case Op::OpFOrdLessThan:
      return known(a < b ? 1.0 : 0.0);
    case Op::OpSLessThanEqual:
    case Op::OpULessThanEqual:
    case Op::OpFOrdLessThanEqual:
      return known(a <= b ? 1.0 : 0.0);
    case Op::OpSGreaterThan:
    case Op::OpUGreaterThan:
    case Op::OpFOrdGreaterThan:
      return known(a > b ? 1.0 : 0.0);
    case Op::OpSGreaterThanEqual:
    case Op::OpUGreaterThanEqual:
    case Op::OpFOrdGreaterThanEqual:
      return known(a >= b ? 1.0 : 0.0);
    case Op::OpLogicalAnd:
      return known(a != 0.0 && b != 0.0 ? 1.0 : 0.0);
    case Op::OpLogicalOr:
      return known(a != 0.0 || b != 0.0 ? 1.0 : 0.0);
    default:
      return std::nullopt;
  }
}

std::optional<TraceNumber> ofKnown(const SpirvOperation& operation, const std::vector<TraceNumber>& x) {
  if (operation.op == Op::OpExtInst) return ofKnownLibrary(operation.function, x);
  if (x.size() == 2) return ofKnownPair(operation.op, x[0].value, x[1].value);
  switch (operation.op) {
    case Op::OpFNegate:
    case Op::OpSNegate:
      return known(-x[0].value);
    case Op::OpLogicalNot:
      return known(x[0].value == 0.0 ? 1.0 : 0.0);
    case Op::OpConvertSToF:
    case Op::OpConvertUToF:
      return knownFloat(x[0].value);
    case Op::OpConvertFToS:
    case Op::OpConvertFToU:
      return known(std::trunc(x[0].value));
    default:
      return std::nullopt;
  }
}

std::optional<TraceNumber> ofProduct(const TraceNumber& a, const TraceNumber& b) {
  if (is(a, 0.0) || is(b, 0.0)) return known(0.0);
  if (is(a, 1.0)) return b;
  if (is(b, 1.0)) return a;
  return std::nullopt;
}

std::optional<TraceNumber> ofSum(const TraceNumber& a, const TraceNumber& b) {
  if (is(a, 0.0)) return b;
  if (is(b, 0.0)) return a;
  return std::nullopt;
}

}  // namespace

bool worksByComponent(const SpirvOperation& operation) {
  const auto between = [&](Op first, Op last) { return operation.op >= first && operation.op <= last; };
  if (operation.op != Op::OpExtInst) {
    return between(Op::OpConvertFToU, Op::OpBitcast) || between(Op::OpSNegate, Op::OpVectorTimesScalar) ||
           between(Op::OpIsNan, Op::OpFUnordGreaterThanEqual) || between(Op::OpShiftRightLogical, Op::OpBitCount);
  }
  const std::uint32_t function = operation.function;
  return function >= GLSLstd450Round && function <= GLSLstd450NClamp &&
         !(function >= GLSLstd450Determinant && function <= GLSLstd450ModfStruct) &&
         !(function >= GLSLstd450Frexp && function <= GLSLstd450FrexpStruct) &&
         !(function >= GLSLstd450PackSnorm4x8 && function <= GLSLstd450Refract) &&
         !(function >= GLSLstd450InterpolateAtCentroid && function <= GLSLstd450InterpolateAtOffset);
}

std::optional<TraceNumber> simplified(const SpirvOperation& operation, const std::vector<TraceNumber>& operands) {
  if (std::ranges::all_of(operands, &TraceNumber::known)) {
    if (const auto value = ofKnown(operation, operands)) return value;
  }
  switch (operation.op) {
    case Op::OpFMul:
    case Op::OpIMul:
    case Op::OpVectorTimesScalar:
      return ofProduct(operands[0], operands[1]);
    case Op::OpFAdd:
    case Op::OpIAdd:
      return ofSum(operands[0], operands[1]);
    case Op::OpFSub:
    case Op::OpISub:
      if (is(operands[1], 0.0)) return operands[0];
      break;
    case Op::OpFDiv:
      if (is(operands[1], 1.0) || is(operands[0], 0.0)) return operands[0];
      break;
    case Op::OpSelect:
      if (operands[0].known) return operands[0].value != 0.0 ? operands[1] : operands[2];
      if (operands[1] == operands[2]) return operands[1];
      break;
    case Op::OpExtInst:
      if (operation.function == GLSLstd450Fma) {
        const auto product = ofProduct(operands[0], operands[1]);
        if (product && product->known) return ofSum(*product, operands[2]);
      }
      break;
    default:
      break;
  }
  return std::nullopt;
}

}  // namespace welkin::study
