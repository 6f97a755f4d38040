// SPDX-License-Identifier: Apache-2.0
#include "view/window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <chrono>
#include <cstdio>
#include <memory>

#include "render/picture.h"
#include "sky/base/error.h"
#include "sky/base/module.h"
#include "view/canvas.h"
#include "view/navigation.h"
#include "view/panels.h"
#include "view/script.h"
#include "view/settings.h"
#include "view/state_json.h"
#include "view/swapchain.h"
#include "view/user_folder.h"

namespace welkin::view {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kStillAfter_s = 0.2;  // without a change the picture gets its full size
constexpr double kIdle_s = 0.25;       // between looks at a window that nobody uses

std::unique_ptr<Window> openWindow(uint32_t width, uint32_t height) {
  void* entry = base::loadModule(WELKIN_WINDOW_MODULE, kWindowModuleEntry,
                                 "the module for windows, without which --headless works");
  const WindowModule& module = *reinterpret_cast<const WindowModule* (*)()>(entry)();
  std::string why;
  std::unique_ptr<Window> window(module.open(width, height, "Welkin", why));
  if (!window)
    throw base::Error(base::ExitStatus::file,
                      fmt::format("no window: {}; --headless with --script works without one", why));
  return window;
}

/// The rates at which pictures of both kinds were made.
struct Rate {
  double seconds = 0.0;
  std::size_t pictures = 0;
  double perSecond() const { return seconds > 0.0 ? static_cast<double>(pictures) / seconds : 0.0; }
};

class Windowed : public Host {
 public:
  Windowed(render::VulkanDevice& device, Window& window, Session& session)
      : window_(window),
        session_(session),
        panels_(session),
        canvas_(device),
        swapchain_(device, window),
        navigation_(session, panels_) {
    mapKeys();
    session.setHost(this);
  }

  void screenshot(const std::string& path, bool moving) override {
    wanted_screenshot_.clear();
    if (in_frame_) {  // a panel or a key asks for it within a frame of ImGui
      wanted_screenshot_ = path;
      return;
    }
    const render::Picture picture = session_.picture(moving);  // first, so that the panels know its error
    render::writePng(canvas_.read(picture, session_.width(), session_.height(), panels_.settled()), path);
  }

  void show(const render::Picture& picture) override {
    if (!in_frame_) present(picture, panels_.build());  // a panel's command leaves the frame as it is
  }

  void run() {
    Clock::time_point last = Clock::now(), changed = last;
    std::size_t version = session_.version() + 1;
    bool full = false, pending = true;
    for (;;) {
      const bool busy = navigation_.moves() || pending || !full;
      const WindowInput input = window_.input(busy ? 0.0 : kIdle_s);
      if (input.closed || navigation_.quits()) return;
      if (input.width == 0 || input.height == 0) continue;
      const Clock::time_point now = Clock::now();
      const double seconds = std::chrono::duration<double>(now - last).count();
      last = now;
      session_.resize(input.width, input.height);
      feedPanels(input, seconds);
      in_frame_ = true;
      navigation_.act(input, seconds);
      try {
        session_.advance();
      } catch (const base::Error& error) {  // a bake's file that cannot be read leaves the old picture
        panels_.complain(error.what());
      }
      const bool changes = session_.version() != version;
      version = session_.version();
      if (changes) changed = now;
      const bool moving = std::chrono::duration<double>(now - changed).count() < kStillAfter_s;
      pending = pending || changes || !full;
      if (pending && (!input.more || picture_.rgb.empty())) {  // all that has happened comes first
        pending = false;
        full = !moving;
        const Clock::time_point begin = Clock::now();
        picture_ = session_.picture(!full);
        Rate& rate = full ? full_rate_ : quick_rate_;
        rate.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
        ++rate.pictures;
      }
      session_.setHurry(!full);
      const ImDrawData& drawn = panels_.build();
      session_.setHurry(false);
      present(picture_, drawn);
      in_frame_ = false;
      if (wanted_screenshot_.empty()) continue;
      try {
        screenshot(std::string(wanted_screenshot_), false);
      } catch (const base::Error& error) {  // a folder that cannot be written does not end the session
        panels_.complain(error.what());
      }
    }
  }

  const Rate& quickRate() const { return quick_rate_; }
  const Rate& fullRate() const { return full_rate_; }

 private:
  void present(const render::Picture& picture, const ImDrawData& drawn) {
    swapchain_.show(session_.width(), session_.height(), [&](VkCommandBuffer commands) -> render::Image& {
      canvas_.record(commands, picture, session_.width(), session_.height(), drawn);
      return canvas_.image();
    });
  }

  Window& window_;
  Session& session_;
  Panels panels_;
  Canvas canvas_;
  Swapchain swapchain_;
  Navigation navigation_;
  render::Picture picture_;
  std::string wanted_screenshot_;
  bool in_frame_ = false;
  Rate quick_rate_, full_rate_;
};

}  // namespace

void runWindow(const ViewOptions& options) {
  const LevelFiles files = levelFiles(options.folder, options.level);
  Settings settings = readSettings(configFolder());
  if (options.has_size) {
    settings.width = options.width;
    settings.height = options.height;
  }
  const std::unique_ptr<Window> window = openWindow(settings.width, settings.height);
  render::VulkanDevice device(
      options.validate, {window->extensions(), [&](VkInstance instance, VkPhysicalDevice physical, uint32_t family) {
                           return window->presents(instance, physical, family);
                         }});
  std::fprintf(stderr, "device: %s\n", device.properties().deviceName);
  Level level(files);
  {
    Session session(device, level, settings.width, settings.height);
    State state = session.state();
    apply(settings, state);
    session.set(state);
    Windowed host(device, *window, session);
    if (!options.script.empty()) runScript(session, options.script);
    host.run();
    writeSettings(configFolder(), settingsOf(session));
    std::fprintf(stderr, "pictures a second: %.1f while moving, %.1f when still\n", host.quickRate().perSecond(),
                 host.fullRate().perSecond());
    if (!options.screenshot.empty()) host.screenshot(options.screenshot, false);
    if (!options.state.empty()) writeState(session, options.state);
  }
  if (device.messageCount() > 0)
    throw base::Error(base::ExitStatus::internal,
                      std::to_string(device.messageCount()) + " Vulkan validation messages");
}

}  // namespace welkin::view
