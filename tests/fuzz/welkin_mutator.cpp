// SPDX-License-Identifier: Apache-2.0
// libFuzzer's mutator of .welkin files. It changes the payload and forges size and checksum over it, so that the input
// reaches the code behind the checksum. One input in eight keeps its wrong checksum.
#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "format/container.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t size, std::size_t most);

namespace {

using Limits = std::numeric_limits<double>;
constexpr double kNumbers[] = {0.0,
                               -0.0,
                               1.0,
                               -1.0,
                               0.5,
                               12.0,
                               24.0,
                               -1e-300,
                               1e-320,
                               1e30,
                               1e38,
                               -1e300,
                               1e300,
                               -90.0,
                               1.5708,
                               Limits::max(),
                               Limits::infinity(),
                               Limits::quiet_NaN()};
constexpr std::uint32_t kIntegers[] = {0,      1,      2,     3,          5,          16,        255,
                                       0x3c00, 0x7c00, 65536, 0x7fffffff, 0x80000000, 0xffffffff};

template <typename T>
void put(std::uint8_t* bytes, std::size_t size, std::size_t place, T value) {
  const std::size_t at = place % (size / sizeof value) * sizeof value;
  std::memcpy(bytes + at, &value, sizeof value);
}

/// Overwrites one aligned number of the payload.
void placeNumber(std::uint8_t* payload, std::size_t size, std::minstd_rand& random) {
  const double number = kNumbers[random() % std::size(kNumbers)];
  const std::size_t place = random();
  switch (random() % 4) {
    case 0:
      return put(payload, size, place, kIntegers[random() % std::size(kIntegers)]);
    case 1:
      return put(payload, size, place, static_cast<float>(std::clamp(number, -1e38, 1e38)));
    default:
      return put(payload, size, place, number);
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed) {
  using welkin::format::Header;
  std::minstd_rand random(seed);
  if (size < sizeof(Header) || most <= sizeof(Header) || random() % 8 == 0) return LLVMFuzzerMutate(bytes, size, most);
  std::uint8_t* payload = bytes + sizeof(Header);
  std::size_t length = size - sizeof(Header);
  if (length >= sizeof(double) && random() % 3 == 0)
    placeNumber(payload, length, random);
  else
    length = LLVMFuzzerMutate(payload, length, most - sizeof(Header));
  const auto kind = welkin::format::kindOf(std::as_bytes(std::span(bytes, sizeof(Header))));
  const auto sealed = welkin::format::seal({payload, length}, kind.value_or(welkin::format::Kind::sky));
  std::memcpy(bytes, sealed.data(), sealed.size());
  return sealed.size();
}
