// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a sector or of a level's index in the runtime. It reads nothing outside them. What it
// accepts is made resident, relit, looked up and written to a volume, with finite light everywhere.
#include "fuzz.h"
#include "tests/runtime/exercise_level.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto result = welkin::tests::exerciseFile({reinterpret_cast<const std::byte*>(bytes), size});
  welkin::fuzz::require(result.fault.empty(), result.fault);
  return 0;
}
