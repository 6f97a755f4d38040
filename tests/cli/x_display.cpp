// SPDX-License-Identifier: Apache-2.0
#include "x_display.h"

#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

namespace welkin::tests {
namespace {

constexpr auto kBetween = std::chrono::milliseconds(20);

Display* displayOf(void* connection) {
  return static_cast<Display*>(connection);
}

void settle(void* connection) {
  XFlush(displayOf(connection));
  std::this_thread::sleep_for(kBetween);
}

}  // namespace

XDisplay::XDisplay() {
  int ends[2];
  if (pipe(ends) != 0) return;
  const pid_t test = getpid();
  server_ = fork();
  if (server_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // a test that is killed leaves no server behind
    if (getppid() != test) _exit(127);
    close(ends[0]);
    const std::string fd = std::to_string(ends[1]);
    execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1280x800x24", "-nolisten", "tcp",
           static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  std::string number;  // Xvfb writes it when it is ready; without Xvfb the pipe ends
  for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
  close(ends[0]);
  if (number.empty()) return;
  name_ = ":" + number;
  connection_ = XOpenDisplay(name_.c_str());
}

XDisplay::~XDisplay() {
  if (connection_ != nullptr) XCloseDisplay(displayOf(connection_));
  if (server_ <= 0) return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

bool XDisplay::showsWindowWithin(double seconds) const {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  Display* display = displayOf(connection_);
  while (std::chrono::steady_clock::now() < end) {
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    bool shown = false;
    if (XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count) != 0) {
      for (unsigned i = 0; i < count; ++i) {
        XWindowAttributes attributes;
        shown = shown || (XGetWindowAttributes(display, children[i], &attributes) != 0 &&
                          attributes.map_state == IsViewable && attributes.width > 64);
      }
      if (children != nullptr) XFree(children);
    }
    if (shown) return true;
    std::this_thread::sleep_for(kBetween);
  }
  return false;
}

void XDisplay::moveTo(int x, int y) const {
  XTestFakeMotionEvent(displayOf(connection_), -1, x, y, CurrentTime);
  settle(connection_);
}

void XDisplay::button(unsigned number, bool down) const {
  XTestFakeButtonEvent(displayOf(connection_), number, down ? True : False, CurrentTime);
  settle(connection_);
}

void XDisplay::click(unsigned number) const {
  button(number, true);
  button(number, false);
}

void XDisplay::key(const char* key_name, bool down) const {
  const KeyCode code = XKeysymToKeycode(displayOf(connection_), XStringToKeysym(key_name));
  XTestFakeKeyEvent(displayOf(connection_), code, down ? True : False, CurrentTime);
  settle(connection_);
}

void XDisplay::type(const char* key_name) const {
  key(key_name, true);
  key(key_name, false);
}

}  // namespace welkin::tests
