// SPDX-License-Identifier: Apache-2.0
#include "view/window_module.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <utility>

extern "C" {  // glfw3.h declares it if vulkan.h came before, with prototypes
VkResult glfwCreateWindowSurface(VkInstance instance, GLFWwindow* window, const VkAllocationCallbacks* allocator,
                                 VkSurfaceKHR* surface);
int glfwGetPhysicalDevicePresentationSupport(VkInstance instance, VkPhysicalDevice device, uint32_t family);
}

namespace welkin::view {
namespace {

std::string& lastComplaint() {
  static std::string text;
  return text;
}

class GlfwWindow : public Window {
 public:
  explicit GlfwWindow(GLFWwindow* window) : window_(window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double up) {
      add(w, {[up](WindowInput& input) { input.wheel += up; }, false});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
      add(w, {[character](WindowInput& input) { input.text.push_back(character); }, false});
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
      add(w, {[x, y, scale = scaleOf(w)](WindowInput& input) {
                input.x = x * scale;
                input.y = y * scale;
              },
              false});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      if (key < 0 || key >= static_cast<int>(kWindowKeys) || action == GLFW_REPEAT) return;
      add(w, {[key, action](WindowInput& input) { input.key[static_cast<std::size_t>(key)] = action == GLFW_PRESS; },
              true});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
      if (button < 0 || button >= 3) return;
      add(w, {[button, action](WindowInput& input) {
                input.button[static_cast<std::size_t>(button)] = action == GLFW_PRESS;
              },
              true});
    });
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;
  ~GlfwWindow() override {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }

  std::vector<const char*> extensions() const override {
    uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    return names == nullptr ? std::vector<const char*>{} : std::vector<const char*>(names, names + count);
  }

  bool presents(VkInstance instance, VkPhysicalDevice device, uint32_t family) const override {
    return glfwGetPhysicalDevicePresentationSupport(instance, device, family) != 0;
  }

  VkResult createSurface(VkInstance instance, VkSurfaceKHR* surface) override {
    return glfwCreateWindowSurface(instance, window_, nullptr, surface);
  }

  const WindowInput& input(double wait_s) override {
    input_.wheel = 0.0;
    input_.text.clear();
    if (wait_s > 0.0 && events_.empty())
      glfwWaitEventsTimeout(wait_s);
    else
      glfwPollEvents();
    for (bool any = false, ends = false; !ends && !events_.empty(); any = true) {
      const Event event = events_.front();
      if (event.is_press && any) break;  // the moves before it come first, so that no drag is lost
      event.apply(input_);
      events_.pop_front();
      ends = event.is_press;
    }
    input_.more = !events_.empty();
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    input_.width = static_cast<uint32_t>(width);
    input_.height = static_cast<uint32_t>(height);
    input_.closed = glfwWindowShouldClose(window_) != 0;
    return input_;
  }

 private:
  struct Event {
    std::function<void(WindowInput&)> apply;
    bool is_press;  ///< of a button or key, or its release
  };

  static void add(GLFWwindow* window, Event event) {
    static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window))->events_.push_back(std::move(event));
  }

  /// Pixels of the picture in a unit of the mouse's position.
  static double scaleOf(GLFWwindow* window) {
    int pixels = 0, units = 0;
    glfwGetFramebufferSize(window, &pixels, nullptr);
    glfwGetWindowSize(window, &units, nullptr);
    return static_cast<double>(std::max(pixels, 1)) / std::max(units, 1);
  }

  GLFWwindow* window_;
  WindowInput input_;
  std::deque<Event> events_;
};

Window* open(uint32_t width, uint32_t height, const char* title, std::string& why) {
  glfwSetErrorCallback([](int, const char* text) { lastComplaint() = text; });
  const auto refuse = [&](const std::string& text) -> Window* {
    why = lastComplaint().empty() ? text : lastComplaint();
    glfwTerminate();
    return nullptr;
  };
  if (glfwInit() == 0) return refuse("GLFW does not start");
  if (glfwVulkanSupported() == 0) return refuse("no Vulkan for windows");
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  GLFWwindow* window = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title, nullptr, nullptr);
  if (window == nullptr) return refuse("no window can be opened");
  return new GlfwWindow(window);
}

}  // namespace
}  // namespace welkin::view

extern "C" __attribute__((visibility("default"))) const welkin::view::WindowModule* welkinWindowModule() {
  static const welkin::view::WindowModule kModule{welkin::view::open};
  return &kModule;
}
