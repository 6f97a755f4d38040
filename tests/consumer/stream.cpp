// SPDX-License-Identifier: Apache-2.0
// A headless game of a level: it streams sectors by the camera's position, relights a few probes in each frame, moves
// the volume and draws the ambient light of its own G-buffer. A wrong pixel or a message of the validation layer fails.
#include <welkin/welkin_vulkan_volume.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <vector>
#include <welkin/level.hpp>

#include "ambient.comp.h"
#include "gbuffer.comp.h"
#include "headless.h"

namespace {
constexpr uint32_t kWidth = 64, kHeight = 32, kFramesInFlight = 2, kFrames = 96;
constexpr double kTolerance = 1e-4;  // of the largest irradiance: lavapipe filters halfs in floats
constexpr auto kCompute = vk::PipelineBindPoint::eCompute;
using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

struct Pixel {  // of gbuffer.glsl
  float position[4], normal[4], irradiance[4];
};
constexpr vk::DeviceSize kBytes = kWidth * kHeight * sizeof(Pixel);

template <std::size_t words>
vk::raii::Pipeline createPass(const vk::raii::Device& device, vk::PipelineLayout layout,
                              const uint32_t (&code)[words]) {
  const vk::raii::ShaderModule shader(device, {{}, sizeof(code), code});
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
  return {device, nullptr, vk::ComputePipelineCreateInfo({}, stage, layout)};
}

struct Frame {
  vk::raii::CommandBuffer commands;
  vk::raii::Fence done;
  vk::DescriptorSet set;  // the frame's G-buffer
  const Pixel* pixels;
};

/// Members are in the order of their creation, so that the device outlives everything on it.
class Stream {
 public:
  explicit Stream(const std::string& folder) : folder_(folder) {
    require(sky_.open(folder + "/sky.welkin"));
    const std::string index = folder + "/level.welkin";
    WelkinOpenInfo open{};
    open.path = index.c_str();
    WelkinLevelLimits limits{};
    limits.sector_capacity = 2;
    require(level_.open(open, sky_, limits));
    WelkinVolumeSettings settings{};
    settings.texels[0] = settings.texels[2] = 32;
    WelkinVolume* volume = nullptr;
    require(welkin_volume_create(&settings, &volume));
    volume_.reset(volume);
    WelkinVulkanCreateInfo info = createInfo(context_, instance_, physical_, device_);
    info.frames_in_flight = kFramesInFlight;
    info.colour_format = VK_FORMAT_R32G32B32A32_SFLOAT;  // of the dome, which this game does not draw
    require(dome_.create(info, sky_));
    WelkinVulkanVolume* textures = nullptr;
    require(welkin_vulkan_volume_create(&info, volume, &textures, nullptr));
    textures_.reset(textures);
    createPasses();
    submit(frames_[0], [&](const auto& commands) { require(dome_.recordUpload(*commands)); });
    queue_.waitIdle();
    dome_.freeStaging();
  }
  ~Stream() { device_.waitIdle(); }  // also after an exception

  void run() {
    for (uint32_t i = 0; i < kFrames; ++i) {
      const uint32_t index = i % kFramesInFlight;
      const Frame& frame = frames_[index];
      (void)device_.waitForFences(*frame.done, VK_TRUE, UINT64_MAX);
      const welkin::Float3 camera{-20.0F + 200.0F * float(i) / kFrames, 7.0F, 30.0F};
      stream(camera);
      require(sky_.sample(24.0 * i / kFrames, sample_));
      WelkinLevelLight light{};
      light.sample = &sample_;
      light.sky = light.sun_bounce = light.local = 1.0F;
      WelkinRelight relit{};
      require(level_.setLight(light));
      require(level_.relight(level_.info().resident_probes / 4 + 1, relit));
      WelkinVolumeUpdate update{};
      require(welkin_volume_update(volume_.get(), level_.get(), &sample_, camera.data(), 8192, &update));
      require(dome_.update(index, sample_));
      submit(frame, [&](const auto& commands) { record(commands, index, camera, update); });
      if (i % 6 != 5) continue;
      (void)device_.waitForFences(*frame.done, VK_TRUE, UINT64_MAX);
      compare(frame.pixels);
    }
  }
  double worst = 0.0, largest = 0.0;  // error of a pixel, and irradiance
  unsigned compared = 0, inside = 0, opened = 0, left = 0;

 private:
  /// Makes the sectors about the camera resident; the farthest leaves for them.
  void stream(const welkin::Float3& camera) {
    for (uint32_t i = 0; i < level_.info().sector_count; ++i) {
      WelkinSectorEntry entry{};
      require(level_.entry(i, entry));
      const float x = 64.0F * (float(entry.x) + 0.5F), z = 64.0F * (float(entry.z) + 0.5F);
      if (std::hypot(x - camera[0], z - camera[2]) > 60.0F || files_.count({entry.x, entry.z}) != 0) continue;
      welkin::Sector sector;
      if (const auto info = level_.info(); info.resident_sectors == info.sector_capacity) {
        std::int32_t far_x = 0, far_z = 0;
        require(level_.farthest(camera, far_x, far_z));
        require(level_.remove(far_x, far_z, sector));
        sector = welkin::Sector();  // closed, before its file goes
        files_.erase({far_x, far_z});
        ++left;
      }
      std::vector<std::max_align_t>& file = files_[{entry.x, entry.z}];
      file.resize(entry.bytes / sizeof(file[0]) + 1);
      const std::string name = "sector_" + std::to_string(entry.x) + "_" + std::to_string(entry.z) + ".welkin";
      std::ifstream(folder_ + "/sectors/" + name, std::ios::binary)
          .read(reinterpret_cast<char*>(file.data()), std::streamsize(entry.bytes));
      require(level_.openSector(file.data(), entry.bytes, sector));
      require(level_.add(sector));
      ++opened;
    }
  }

  void createPasses() {
    const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eStorageBuffer, 1,
                                                 vk::ShaderStageFlagBits::eCompute);
    set_layout_ = {device_, {{}, binding}};
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, kFramesInFlight);
    descriptors_ = {device_, {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, kFramesInFlight, size}};
    const std::vector<vk::DescriptorSetLayout> layouts(kFramesInFlight, *set_layout_);
    sets_ = vk::raii::DescriptorSets(device_, {*descriptors_, layouts});
    buffer_.bindMemory(*memory_, 0);
    const auto* pixels = static_cast<const Pixel*>(memory_.mapMemory(0, VK_WHOLE_SIZE));
    vk::raii::CommandBuffers commands(device_, {*pool_, {}, kFramesInFlight});
    for (uint32_t i = 0; i < kFramesInFlight; ++i) {
      const vk::DescriptorBufferInfo part(*buffer_, i * kBytes, kBytes);
      device_.updateDescriptorSets(
          vk::WriteDescriptorSet(*sets_[i], 0, 0, vk::DescriptorType::eStorageBuffer, {}, part), {});
      frames_.push_back({std::move(commands[i]),
                         {device_, {vk::FenceCreateFlagBits::eSignaled}},
                         *sets_[i],
                         pixels + i * kWidth * kHeight});
    }
    const vk::DescriptorSetLayout all[]{welkin_vulkan_volume_descriptor_set_layout(textures_.get()),
                                        dome_.descriptorSetLayout(), *set_layout_};
    const vk::PushConstantRange camera(vk::ShaderStageFlagBits::eCompute, 0, sizeof(float[4]));
    layout_ = {device_, vk::PipelineLayoutCreateInfo({}, all, camera)};
    gbuffer_ = createPass(device_, *layout_, gbuffer_comp);
    ambient_ = createPass(device_, *layout_, ambient_comp);
  }

  template <typename Record>
  void submit(const Frame& frame, Record&& record_commands) {
    frame.commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record_commands(frame.commands);
    frame.commands.end();
    device_.resetFences(*frame.done);
    queue_.submit(vk::SubmitInfo({}, {}, *frame.commands), *frame.done);
  }

  void record(const auto& commands, uint32_t index, const welkin::Float3& camera, const WelkinVolumeUpdate& update) {
    require(welkin_vulkan_volume_record(textures_.get(), *commands, index, volume_.get(), &update));
    const vk::DescriptorSet sets[]{welkin_vulkan_volume_descriptor_set(textures_.get(), index),
                                   dome_.descriptorSet(index), frames_[index].set};
    commands.bindDescriptorSets(kCompute, *layout_, 0, sets, {});
    const std::array<float, 4> place{camera[0], camera[1], camera[2], 0.0F};
    commands.template pushConstants<float>(*layout_, vk::ShaderStageFlagBits::eCompute, 0, place);
    const auto pass = [&](const vk::raii::Pipeline& pipeline, Stage next, vk::AccessFlags2 use) {
      commands.bindPipeline(kCompute, *pipeline);
      commands.dispatch(kWidth / 8, kHeight / 8, 1);
      const vk::MemoryBarrier2 wait(Stage::eComputeShader, Access::eShaderStorageWrite, next, use);
      commands.pipelineBarrier2({{}, wait});
    };
    pass(gbuffer_, Stage::eComputeShader, Access::eShaderStorageRead | Access::eShaderStorageWrite);
    pass(ambient_, Stage::eHost, Access::eHostRead);
  }

  /// Compares the pixels with the volume on the CPU, whose texels are those of this frame.
  void compare(const Pixel* pixels) {
    for (const Pixel* p = pixels; p < pixels + kWidth * kHeight; ++p) {
      if (p->position[3] == 0.0F) continue;
      welkin::Float3 light{}, beyond{};
      float share = 0.0F, free = 0.0F;
      require(welkin_volume_irradiance(volume_.get(), p->position, p->normal, light.data(), &share));
      require(welkin::irradiance(sample_, {p->normal[0], p->normal[1], p->normal[2]}, beyond));
      require(welkin_volume_far_visibility(volume_.get(), p->position, p->normal, &free));
      ++compared;
      if (share > 0.0F) ++inside;
      for (std::size_t c = 0; c < 3; ++c) {
        const float expected = share * light[c] + (1.0F - share) * free * beyond[c];
        largest = std::max(largest, double(expected));
        const double error = std::abs(double(p->irradiance[c]) - double(expected));
        if (!(error <= worst)) worst = error;
      }
    }
  }

  std::string folder_;
  vk::raii::Context context_;
  vk::raii::Instance instance_ = createInstance(context_);
  vk::raii::DebugUtilsMessengerEXT messenger_{instance_, kMessenger};
  vk::raii::PhysicalDevice physical_ = std::move(vk::raii::PhysicalDevices(instance_).at(0));
  vk::raii::Device device_ = createDevice(physical_);
  vk::raii::Queue queue_{device_, 0, 0};
  vk::raii::CommandPool pool_{device_, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, 0}};
  vk::raii::Buffer buffer_{device_, {{}, kFramesInFlight* kBytes, vk::BufferUsageFlagBits::eStorageBuffer}};
  vk::raii::DeviceMemory memory_ = allocate(physical_, device_, buffer_.getMemoryRequirements(), kHostMemory);
  welkin::Sky sky_;
  WelkinSkySample sample_{};
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::max_align_t>> files_;  // of the resident sectors
  welkin::Level level_;
  std::unique_ptr<WelkinVolume, Destroy<welkin_volume_destroy>> volume_;
  welkin::VulkanSky dome_;
  std::unique_ptr<WelkinVulkanVolume, Destroy<welkin_vulkan_volume_destroy>> textures_;
  vk::raii::DescriptorSetLayout set_layout_{nullptr};
  vk::raii::DescriptorPool descriptors_{nullptr};
  std::vector<vk::raii::DescriptorSet> sets_;
  vk::raii::PipelineLayout layout_{nullptr};
  vk::raii::Pipeline gbuffer_{nullptr}, ambient_{nullptr};
  std::vector<Frame> frames_;
};
}  // namespace

int main(int argc, char** argv) try {  // stream LEVEL_DIR
  Stream game(argc > 1 ? argv[1] : "street");
  game.run();
  std::printf(
      "%u frames: %u sectors opened, %u left, %u pixels, %u in the volume, largest error %.2g of %.2g, %u messages\n",
      kFrames, game.opened, game.left, game.compared, game.inside, game.worst, game.largest, messages);
  const bool streamed = game.opened >= 3 && game.left >= 1;
  return streamed && game.inside > 5000 && game.worst <= kTolerance * game.largest && messages == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "stream: %s\n", error.what());
  return 1;
}
