// SPDX-License-Identifier: Apache-2.0
// A window of the system, by GLFW. It is a module of its own, which `welkin view` loads, so that nothing else of the
// tool needs GLFW and X11.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace welkin::view {

inline constexpr std::size_t kWindowKeys = 512;
inline constexpr const char* kWindowModuleEntry = "welkinWindowModule";

/// What a person did. No press is lost: a call returns what happened until one button or key changed, and the next call
/// goes on from there. Keys have GLFW's numbers, which are ASCII for letters and digits.
struct WindowInput {
  uint32_t width = 0, height = 0;  ///< of the picture, pixels; 0 while the window is minimised
  double x = -1.0, y = -1.0;       ///< of the mouse, pixels of the picture
  std::array<bool, 3> button{};    ///< left, right, middle
  double wheel = 0.0;              ///< turned since the last call, up is positive
  std::array<bool, kWindowKeys> key{};
  std::vector<uint32_t> text;  ///< characters typed since the last call
  bool more = false;           ///< more has happened already
  bool closed = false;         ///< the window is to be closed
};

class Window {
 public:
  virtual ~Window() = default;
  /// Instance extensions that the surface needs.
  virtual std::vector<const char*> extensions() const = 0;
  /// Whether a queue family of a device can show pictures in windows.
  virtual bool presents(VkInstance instance, VkPhysicalDevice device, uint32_t family) const = 0;
  virtual VkResult createSurface(VkInstance instance, VkSurfaceKHR* surface) = 0;
  /// Waits for input, at most some seconds, and returns it.
  virtual const WindowInput& input(double wait_s) = 0;
};

/// Opens a window. Null, with the reason in `why`, if there is no display or no Vulkan for it.
struct WindowModule {
  Window* (*open)(uint32_t width, uint32_t height, const char* title, std::string& why);
};

}  // namespace welkin::view
