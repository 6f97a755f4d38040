// SPDX-License-Identifier: Apache-2.0
// C++ wrapper of welkin.h, header only. It adds ownership and results with messages, nothing else.
#pragma once

#include <welkin/welkin.h>

#include <cstddef>
#include <string>
#include <utility>

namespace welkin {

/// Result of a call; true means success. `message` gives the reason for a failure, and is empty on success.
struct Status {
  WelkinResult code = WELKIN_OK;
  std::string message;
  explicit operator bool() const { return code == WELKIN_OK; }
};

/// Owns a WelkinSky. Movable; empty until an open succeeds. The thread rules of welkin.h apply.
class Sky {
 public:
  Sky() = default;
  Sky(Sky&& other) noexcept : sky_(std::exchange(other.sky_, nullptr)) {}
  Sky& operator=(Sky&& other) noexcept {
    std::swap(sky_, other.sky_);
    return *this;
  }
  Sky(const Sky&) = delete;
  Sky& operator=(const Sky&) = delete;
  ~Sky() { welkin_sky_close(sky_); }

  /// Opens a file and closes the sky held before. On an error the sky held before stays open.
  Status open(const std::string& path) {
    WelkinSky* sky = nullptr;
    WelkinMessage message{};
    const WelkinResult code = welkin_sky_open_file(path.c_str(), &sky, &message);
    return adopt(code, sky, message);
  }

  /// Opens bytes in memory likewise. `data` must be aligned to 16. Keep the bytes unchanged while the sky is open.
  Status open(const void* data, std::size_t size) {
    WelkinSky* sky = nullptr;
    WelkinMessage message{};
    const WelkinResult code = welkin_sky_open_memory(data, size, &sky, &message);
    return adopt(code, sky, message);
  }

  /// The sky for the functions of welkin.h; null when none is open.
  const WelkinSky* get() const { return sky_; }
  explicit operator bool() const { return sky_ != nullptr; }

  /// Sizes and constants of the sky; all 0 when none is open.
  WelkinSkyInfo info() const {
    WelkinSkyInfo info{};
    welkin_sky_info(sky_, &info);
    return info;
  }

  /// Writes the sky at `time_h` hours to `out`. False when `time_h` is not finite or no sky is open.
  bool sample(double time_h, WelkinSkySample& out) const { return welkin_sky_sample(sky_, time_h, &out) == WELKIN_OK; }

 private:
  Status adopt(WelkinResult code, WelkinSky* sky, const WelkinMessage& message) {
    if (code != WELKIN_OK) return {code, message.text};
    welkin_sky_close(std::exchange(sky_, sky));
    return {};
  }

  WelkinSky* sky_ = nullptr;
};

}  // namespace welkin
