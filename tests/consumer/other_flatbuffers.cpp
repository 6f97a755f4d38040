// SPDX-License-Identifier: Apache-2.0
// A game that links another FlatBuffers: functions with the names that Welkin's own would have. None may be called.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <welkin/welkin.hpp>

namespace flatbuffers {

[[noreturn]] void called(const char* name) {
  std::fprintf(stderr, "Welkin called the game's flatbuffers::%s\n", name);
  std::abort();
}

class Table {
 public:
  const uint8_t* GetVTable() const;
  uint16_t GetOptionalFieldOffset(uint16_t field) const;
};
const uint8_t* Table::GetVTable() const {
  called("Table::GetVTable");
}
uint16_t Table::GetOptionalFieldOffset(uint16_t) const {
  called("Table::GetOptionalFieldOffset");
}

class Verifier {
 public:
  bool Verify(size_t element, size_t bytes) const;
  bool VerifyTableStart(const uint8_t* table);
  bool VerifyVectorOrString(const uint8_t* vector, size_t element_bytes, size_t* end) const;
};
bool Verifier::Verify(size_t, size_t) const {
  called("Verifier::Verify");
}
bool Verifier::VerifyTableStart(const uint8_t*) {
  called("Verifier::VerifyTableStart");
}
bool Verifier::VerifyVectorOrString(const uint8_t*, size_t, size_t*) const {
  called("Verifier::VerifyVectorOrString");
}

}  // namespace flatbuffers

int main(int argc, char** argv) {
  welkin::Sky sky;
  WelkinSkySample sample{};
  const welkin::Status opened = argc == 2 ? sky.open(argv[1]) : welkin::Status{WELKIN_ERROR_ARGUMENT, "no file"};
  if (!opened || !sky.sample(7.0, sample)) {
    std::fprintf(stderr, "%s\n", opened.message.c_str());
    return 1;
  }
  return 0;
}
