// SPDX-License-Identifier: Apache-2.0
// A display without a screen (Xvfb), and a person's hand at its mouse and keys (XTest).
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

namespace welkin::tests {

class XDisplay {
 public:
  /// Starts Xvfb on a free number. Without Xvfb isOpen() is false.
  XDisplay();
  ~XDisplay();
  XDisplay(const XDisplay&) = delete;
  XDisplay& operator=(const XDisplay&) = delete;

  bool isOpen() const { return connection_ != nullptr; }
  const std::string& name() const { return name_; }
  /// Whether a program's window is shown within the time.
  bool showsWindowWithin(double seconds) const;

  void moveTo(int x, int y) const;
  void button(unsigned number, bool down) const;  ///< 1 left, 2 middle, 3 right, 4 wheel up
  void click(unsigned number) const;
  /// A key by its X11 name, such as "w" or "Control_L".
  void key(const char* key_name, bool down) const;
  void type(const char* key_name) const;

 private:
  pid_t server_ = -1;
  std::string name_;
  void* connection_ = nullptr;
};

}  // namespace welkin::tests
