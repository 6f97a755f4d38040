// SPDX-License-Identifier: Apache-2.0
#include "fp_traps.h"

#include <dlfcn.h>
#include <execinfo.h>
#include <signal.h>
#include <sys/auxv.h>
#include <ucontext.h>
#include <unistd.h>
#include <xmmintrin.h>

#include <cstdint>
#include <string_view>

namespace welkin::tests {
namespace {

constexpr std::uint32_t kMasks = _MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW;
constexpr greg_t kSingleStep = 0x100;  // the trap flag of EFLAGS
constexpr int kStatus = 99;

void* baseOf(const void* address) {
  Dl_info info{};
  return dladdr(address, &info) != 0 ? info.dli_fbase : nullptr;
}

void say(std::string_view text) {
  const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  static_cast<void>(written);
}

/// Ends the program for an instruction of its own. One of a library runs once more without traps, up to onStep.
void onFault(int, siginfo_t* info, void* context) {
  static void* const kProgram = baseOf(reinterpret_cast<const void*>(getauxval(AT_ENTRY)));
  if (baseOf(info->si_addr) == kProgram) {
    say(info->si_code == FPE_FLTDIV   ? "division by zero\n"
        : info->si_code == FPE_FLTOVF ? "overflow\n"
                                      : "invalid operation\n");
    void* frames[16];
    backtrace_symbols_fd(frames, backtrace(frames, 16), STDERR_FILENO);
    ::_exit(kStatus);
  }
  mcontext_t& state = static_cast<ucontext_t*>(context)->uc_mcontext;
  state.fpregs->mxcsr |= kMasks;
  state.gregs[REG_EFL] |= kSingleStep;
}

void onStep(int, siginfo_t*, void* context) {
  mcontext_t& state = static_cast<ucontext_t*>(context)->uc_mcontext;
  state.fpregs->mxcsr &= ~(kMasks | static_cast<std::uint32_t>(_MM_EXCEPT_MASK));
  state.gregs[REG_EFL] &= ~kSingleStep;
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void trapFloatingPointFaults() {
  handle(SIGFPE, onFault);
  handle(SIGTRAP, onStep);
  _mm_setcsr(_mm_getcsr() & ~(kMasks | static_cast<std::uint32_t>(_MM_EXCEPT_MASK)));
}

}  // namespace welkin::tests
