// SPDX-License-Identifier: Apache-2.0
// The viewer without a window.
#include <imgui.h>

#include <cstdio>

#include "render/picture.h"
#include "sky/base/error.h"
#include "view/canvas.h"
#include "view/panels.h"
#include "view/run.h"
#include "view/script.h"
#include "view/state_json.h"

namespace welkin::view {
namespace {

/// Draws pictures where they are asked for.
class Headless : public Host {
 public:
  Headless(render::VulkanDevice& device, Session& session)
      : device_(device), session_(session), panels_(session), canvas_(device) {
    session.setHost(this);
  }

  void screenshot(const std::string& path, bool moving) override {
    const render::Picture picture = session_.picture(moving);
    render::writePng(canvas_.read(picture, session_.width(), session_.height(), panels_.settled()), path);
  }

  void show(const render::Picture& picture) override {
    const ImDrawData& drawn = panels_.build();
    device_.execute([&](VkCommandBuffer commands) {
      canvas_.record(commands, picture, session_.width(), session_.height(), drawn);
    });
  }

 private:
  render::VulkanDevice& device_;
  Session& session_;
  Panels panels_;
  Canvas canvas_;
};

}  // namespace

void runHeadless(const ViewOptions& options) {
  if (options.script.empty() && options.screenshot.empty() && options.state.empty())
    throw base::Error(base::ExitStatus::usage,
                      "--headless has nothing to do: give --script, --screenshot or --state, each with a file");
  Level level(levelFiles(options.folder, options.level));
  render::VulkanDevice device(options.validate);
  std::fprintf(stderr, "device: %s\n", device.properties().deviceName);
  {
    Session session(device, level, options.width, options.height);
    Headless host(device, session);
    if (!options.script.empty()) runScript(session, options.script);
    if (!options.screenshot.empty()) host.screenshot(options.screenshot, false);
    if (!options.state.empty()) writeState(session, options.state);
  }
  if (device.messageCount() > 0)
    throw base::Error(base::ExitStatus::internal,
                      std::to_string(device.messageCount()) + " Vulkan validation messages");
}

}  // namespace welkin::view
