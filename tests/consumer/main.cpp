// SPDX-License-Identifier: Apache-2.0
// The integration sample and the test of the installed package: a headless game that draws a day of a baked sky with
// two frames in flight. A wrong pixel, a message of the validation layer or an allocation in the loop makes it fail.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

#include "ball.frag.h"
#include "ball.vert.h"
#include "headless.h"

static std::size_t allocations = 0;  // count for the game and Welkin; see CMakeLists.txt
static double worst = -1.0;          // relative error of a pixel; -1: none was compared

void* operator new(std::size_t bytes) {
  ++allocations;
  if (void* p = std::malloc(bytes == 0 ? 1 : bytes)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept {
  std::free(p);
}

namespace {
constexpr uint32_t kWidth = 64, kHeight = 32, kFramesInFlight = 2;
constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Sfloat;
constexpr vk::DeviceSize kFloats = kWidth * kHeight * 4, kBytes = kFloats * sizeof(float);  // per picture
constexpr vk::ImageSubresourceRange kWhole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
constexpr vk::ImageCreateInfo kImage({}, vk::ImageType::e2D, kFormat, {kWidth, kHeight, 1}, 1, 1,
                                     vk::SampleCountFlagBits::e1, {},
                                     vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc);
// Looking north, a quarter turn from top to bottom: the direction of a point is (2 x, -y, -1).
constexpr WelkinVulkanView kView{
    sizeof(kView), {}, {}, {float(kWidth) / kHeight, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0}};
constexpr float kBallRadius = 0.75F;  // of half the picture's height, as in ball.vert
constexpr double kTolerance = 1e-4;   // relative; the driver's atan alone is good for 4e-5
using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;
using Layout = vk::ImageLayout;

/// The game's own pass: its shaders read Welkin's descriptor set as set 0.
vk::raii::Pipeline createBall(const vk::raii::Device& device, vk::PipelineLayout layout) {
  const vk::raii::ShaderModule vertex(device, {{}, sizeof(ball_vert), ball_vert});
  const vk::raii::ShaderModule fragment(device, {{}, sizeof(ball_frag), ball_frag});
  const vk::PipelineShaderStageCreateInfo stages[]{{{}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"},
                                                   {{}, vk::ShaderStageFlagBits::eFragment, *fragment, "main"}};
  const vk::PipelineVertexInputStateCreateInfo input;
  const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  const vk::PipelineRasterizationStateCreateInfo raster({}, 0, 0, {}, {}, {}, 0, 0.0F, 0.0F, 0.0F, 1.0F);
  const vk::PipelineMultisampleStateCreateInfo samples;
  const vk::PipelineColorBlendAttachmentState attachment(0, {}, {}, {}, {}, {}, {}, vk::ColorComponentFlags(0xF));
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, {}, attachment);
  const vk::DynamicState states[]{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, states);
  const vk::PipelineRenderingCreateInfo rendering(0, kFormat);
  return {device, nullptr,
          vk::GraphicsPipelineCreateInfo({}, stages, &input, &assembly, nullptr, &viewport, &raster, &samples, nullptr,
                                         &blend, &dynamic, layout, {}, 0, {}, 0, &rendering)};
}

struct Frame {
  vk::raii::CommandBuffer commands;
  vk::raii::Fence done;
  WelkinSkySample sample;
};

/// Members are in the order of their creation, so that the device outlives everything on it.
class Game {
 public:
  explicit Game(const char* path) {
    if (const welkin::Status status = sky_.open(path); !status) throw std::runtime_error(status.message);
    WelkinVulkanCreateInfo info = createInfo(context_, instance_, physical_, device_);
    info.frames_in_flight = kFramesInFlight;
    info.colour_format = static_cast<VkFormat>(kFormat);
    require(dome_.create(info, sky_));
    const vk::DescriptorSetLayout set = dome_.descriptorSetLayout();
    layout_ = {device_, vk::PipelineLayoutCreateInfo({}, set)};
    ball_ = createBall(device_, *layout_);
    image_.bindMemory(*image_memory_, 0);
    copies_.bindMemory(*copies_memory_, 0);
    view_ = {device_, vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D, kFormat, {}, kWhole)};
    rgba_ = static_cast<const float*>(copies_memory_.mapMemory(0, VK_WHOLE_SIZE));
    for (auto& commands : vk::raii::CommandBuffers(device_, {*pool_, {}, kFramesInFlight}))
      frames_.push_back({std::move(commands), {device_, {vk::FenceCreateFlagBits::eSignaled}}, {}});
    submit(frames_[0], [&](const auto& commands) { require(dome_.recordUpload(*commands)); });
    queue_.waitIdle();
    dome_.freeStaging();
  }
  ~Game() { device_.waitIdle(); }  // also after an exception

  /// Draws a day in `count` frames. Returns the number of allocations.
  std::size_t run(uint32_t count) {
    const std::size_t before = allocations;
    for (uint32_t i = 0; i < count + kFramesInFlight; ++i) {
      const uint32_t index = i % kFramesInFlight;
      Frame& frame = frames_[index];
      (void)device_.waitForFences(*frame.done, VK_TRUE, UINT64_MAX);
      if (i >= kFramesInFlight) compare(frame, rgba_ + index * kFloats);
      if (i >= count) continue;
      require(sky_.sample(24.0 * i / count, frame.sample));
      require(dome_.update(index, frame.sample));
      submit(frame, [&](const auto& commands) { record(commands, index); });
    }
    return allocations - before;
  }

 private:
  template <typename Record>
  void submit(const Frame& frame, Record&& record_commands) {
    frame.commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record_commands(frame.commands);
    frame.commands.end();
    device_.resetFences(*frame.done);
    queue_.submit(vk::SubmitInfo({}, {}, *frame.commands), *frame.done);
  }

  void move(const auto& c, Layout from, Layout to, Stage first, vk::AccessFlags2 wrote, Stage next, Access use) {
    const vk::ImageMemoryBarrier2 image(first, wrote, next, use, from, to, 0, 0, *image_, kWhole);
    c.pipelineBarrier2({{}, {}, {}, image});
  }

  void record(const auto& commands, uint32_t index) {
    const vk::Rect2D area({}, {kWidth, kHeight});
    move(commands, Layout::eUndefined, Layout::eColorAttachmentOptimal, Stage::eCopy, {}, Stage::eColorAttachmentOutput,
         Access::eColorAttachmentWrite);
    const vk::RenderingAttachmentInfo colour(*view_, Layout::eColorAttachmentOptimal);
    commands.beginRendering({{}, area, 1, 0, colour});
    commands.setViewport(0, vk::Viewport(0, 0, kWidth, kHeight, 0, 1));
    commands.setScissor(0, area);
    require(dome_.drawDome(*commands, index, kView));
    const vk::DescriptorSet set = dome_.descriptorSet(index);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *ball_);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_, 0, set, {});
    commands.draw(3, 1, 0, 0);
    commands.endRendering();
    move(commands, Layout::eColorAttachmentOptimal, Layout::eTransferSrcOptimal, Stage::eColorAttachmentOutput,
         Access::eColorAttachmentWrite, Stage::eCopy, Access::eTransferRead);
    const vk::BufferImageCopy region(index * kBytes, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                     {kWidth, kHeight, 1});
    commands.copyImageToBuffer(*image_, Layout::eTransferSrcOptimal, *copies_, region);
    const vk::MemoryBarrier2 to_host(Stage::eCopy, Access::eTransferWrite, Stage::eHost, Access::eHostRead);
    commands.pipelineBarrier2({{}, to_host});
  }

  /// Compares every seventh pixel with the runtime's own evaluation on the CPU.
  void compare(const Frame& frame, const float* rgba) {
    for (uint32_t i = 0; i < kWidth * kHeight; i += 7) {
      const float x = (float(i % kWidth) + 0.5F) * 2.0F / kHeight - float(kWidth) / kHeight;
      const float y = 1.0F - (float(i / kWidth) + 0.5F) * 2.0F / kHeight;
      const float square = (x * x + y * y) / (kBallRadius * kBallRadius);
      const bool on_ball = square < 1.0F;
      if (std::abs(square - 1.0F) < 0.05F) continue;  // its edge
      const float scale = on_ball ? 1.0F / kBallRadius : 1.0F / std::sqrt(x * x + y * y + 1.0F);
      const welkin::Float3 direction{x * scale, y * scale, on_ball ? std::sqrt(1.0F - square) : -scale};
      welkin::Float3 dome{}, irradiance{};
      require(sky_.domeRadiance(frame.sample, direction, dome));
      require(welkin::irradiance(frame.sample, direction, irradiance));
      for (int c = 0; c < 3; ++c) {
        const float value = on_ball ? 0.5F * (dome[c] + irradiance[c] / float(M_PI)) : dome[c];
        const double error = std::abs(double(rgba[4 * i + c]) / value - 1.0);
        if (!(error <= worst)) worst = error;
      }
    }
  }

  vk::raii::Context context_;
  vk::raii::Instance instance_ = createInstance(context_);
  vk::raii::DebugUtilsMessengerEXT messenger_{instance_, kMessenger};
  vk::raii::PhysicalDevice physical_ = std::move(vk::raii::PhysicalDevices(instance_).at(0));
  vk::raii::Device device_ = createDevice(physical_);
  vk::raii::Queue queue_{device_, 0, 0};
  vk::raii::CommandPool pool_{device_, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, 0}};
  vk::raii::Image image_{device_, kImage};
  vk::raii::DeviceMemory image_memory_ = allocate(physical_, device_, image_.getMemoryRequirements(), {});
  vk::raii::ImageView view_{nullptr};
  vk::raii::Buffer copies_{device_, {{}, kFramesInFlight* kBytes, vk::BufferUsageFlagBits::eTransferDst}};
  vk::raii::DeviceMemory copies_memory_ = allocate(physical_, device_, copies_.getMemoryRequirements(), kHostMemory);
  const float* rgba_ = nullptr;
  welkin::Sky sky_;
  welkin::VulkanSky dome_;
  vk::raii::PipelineLayout layout_{nullptr};
  vk::raii::Pipeline ball_{nullptr};
  std::vector<Frame> frames_;
};
}  // namespace

int main(int argc, char** argv) try {  // game SKY.welkin [FRAMES]
  const uint32_t count = argc > 2 ? static_cast<uint32_t>(std::atoi(argv[2])) : 48;
  const std::size_t during = Game(argc > 1 ? argv[1] : "sky.welkin").run(count);
  std::printf("%u frames: largest error %.2g, %zu allocations (%zu before), %u messages of validation\n", count, worst,
              during, allocations - during, messages);
  return worst >= 0.0 && worst <= kTolerance && during == 0 && allocations > 0 && messages == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "game: %s\n", error.what());
  return 1;
}
