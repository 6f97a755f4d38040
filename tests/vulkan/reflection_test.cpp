// SPDX-License-Identifier: Apache-2.0
// The filtered sky on the device against the integral over the lobe, of the dome that the runtime computes in double.
#include <welkin/welkin_vulkan_reflection.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

#include "compute.h"
#include "materials.h"
#include "object.h"
#include "sky/cubemap/cubemap.h"
#include "sky/reflection/lobe_reference.h"
#include "spirv/kReflectionComp.h"
#include "test_sky.h"
#include "tests/sky/baked.h"
#include "tests/sky/some_skies.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using det::Number3;

constexpr uint32_t kSize = 64;

/// A place to read the chain at.
struct Look {
  Number3 direction;
  double gloss;
};

/// A sky and its chain on a device that reports to validation.
class Chain {
 public:
  Chain(const Sky& sky, uint32_t size) : sky_(sky), object_(device_, sky, render::createInfo(device_, 1)) {
    const WelkinVulkanCreateInfo info = render::createInfo(device_, 1);
    WelkinMessage message{};
    const WelkinResult result = welkin_vulkan_reflection_create(&info, object_.get(), size, &chain_, &message);
    INFO(message.text);
    REQUIRE(result == WELKIN_OK);
  }
  ~Chain() {
    welkin_vulkan_reflection_destroy(chain_);
    CHECK(device_.messageCount() == 0);
  }
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  /// Number of pieces that are old.
  uint32_t filter(double time_h, uint32_t budget) {
    REQUIRE(sky_.sample(time_h, sample_));
    REQUIRE(welkin_vulkan_update(object_.get(), 0, &sample_) == WELKIN_OK);
    uint32_t left = ~0U;
    device_.execute([&](VkCommandBuffer commands) {
      REQUIRE(welkin_vulkan_reflection_record(chain_, commands, object_.get(), 0, budget, &left) == WELKIN_OK);
    });
    return left;
  }

  /// Red, green, blue and the number of mips for each look.
  std::vector<float> read(const std::vector<Look>& looks) {
    std::vector<float> input;
    for (const Look& look : looks) {
      for (int c = 0; c < 3; ++c) input.push_back(static_cast<float>(look.direction[c]));
      input.push_back(static_cast<float>(look.gloss));
    }
    return runCompute(device_, kReflectionComp, input, input.size(), 4,
                      welkin_vulkan_reflection_descriptor_set_layout(chain_),
                      welkin_vulkan_reflection_descriptor_set(chain_));
  }

  reflection::Radiance dome() const {
    return [this](const Number3& d) {
      const float direction[3] = {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
      float rgb[3] = {};
      welkin_dome_radiance(sky_.get(), &sample_, direction, rgb);
      return Number3(double{rgb[0]}, double{rgb[1]}, double{rgb[2]});
    };
  }

  Number3 truthOf(const Look& look) const {
    return reflection::lobeReference(dome(), f64::powerOfGloss(look.gloss), look.direction, {12, 12});
  }
  /// Largest component of the sphere's mean, as the widest lobes up and down have it.
  double mean() const {
    const Number3 twice = truthOf({{0, 1, 0}, 0.0}) + truthOf({{0, -1, 0}, 0.0});
    return 0.5 * std::max({twice.x, twice.y, twice.z});
  }

  render::VulkanDevice& device() { return device_; }
  WelkinVulkanSky* sky() const { return object_.get(); }
  WelkinVulkanReflection* get() const { return chain_; }

 private:
  render::VulkanDevice device_{true};
  const Sky& sky_;
  SkyObject object_;
  WelkinSkySample sample_{};
  WelkinVulkanReflection* chain_ = nullptr;
};

Number3 texelDirection(int size, int face, int column, int row) {
  const cubemap::FaceAxes axes = cubemap::faceAxes(cubemap::Layout::vulkan_cube, face);
  const Number3 d =
      axes.normal + axes.right * ((2.0 * column + 1.0) / size - 1.0) + axes.down * ((2.0 * row + 1.0) / size - 1.0);
  return d / std::sqrt(dot(d, d));
}

/// Texels of every mip, on each face.
std::vector<Look> someTexels(int mips) {
  std::mt19937 random(5);
  std::vector<Look> looks;
  for (int mip = 0; mip < mips; ++mip)
    for (int face = 0; face < 6; ++face)
      for (int i = 0; i < 3; ++i) {
        const int size = static_cast<int>(kSize) >> mip;
        const auto at = [&] { return static_cast<int>(random() % static_cast<unsigned>(size)); };
        const int column = at(), row = at();
        looks.push_back({texelDirection(size, face, column, row), f64::glossOfMip(mip, mips)});
      }
  return looks;
}

/// Every other sky has ground.
std::vector<NamedSky> skiesAndGrounds() {
  std::vector<NamedSky> skies = someSkies();
  for (std::size_t i = 0; i < skies.size(); i += 2) skies[i].sky.ground_albedo = {0.3, 0.2, 0.1};
  return skies;
}

/// Evenly spread directions, each at some gloss.
std::vector<Look> someLooks(int count) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Look> looks;
  for (int i = 0; i < count; ++i) {
    const double y = 2.0 * uniform(random) - 1.0, turn = det::kTwoPi * uniform(random), level = std::sqrt(1.0 - y * y);
    looks.push_back({{level * std::cos(turn), y, level * std::sin(turn)}, uniform(random)});
  }
  return looks;
}

std::string nameOf(const NamedSky& named, double time_h, const Look& look) {
  char text[80];
  std::snprintf(text, sizeof text, " at %g h, gloss %.3f, y %.3f", time_h, look.gloss, look.direction.y);
  return named.name + text;
}

}  // namespace

TEST_CASE("VulkanReflection, TexelsAreTheLobesMeans", "[vulkan]") {
  Worst worst;
  for (const NamedSky& named : skiesAndGrounds()) {
    const Baked baked(named.sky, 3, 8);
    Chain chain(baked.sky, kSize);
    const int mips = static_cast<int>(welkin_vulkan_reflection_pieces(chain.get()) / 6);
    const std::vector<Look> looks = someTexels(mips);
    for (const double time_h : {7.0, 12.0}) {
      CHECK(chain.filter(time_h, UINT32_MAX) == 0);
      const std::vector<float> texels = chain.read(looks);
      const double mean = chain.mean();
      for (std::size_t i = 0; i < looks.size(); ++i) {
        REQUIRE(texels[4 * i + 3] == static_cast<float>(mips));
        const Number3 truth = chain.truthOf(looks[i]);
        for (int c = 0; c < 3; ++c)  // half floats do not hold the darkest ground
          worst.compare(double{texels[4 * i + static_cast<std::size_t>(c)]}, truth[c], std::max(truth[c], 1e-3 * mean),
                        [&] { return nameOf(named, time_h, looks[i]); });
      }
    }
  }
  WARN("worst " << worst.error << " at " << worst.where);
  CHECK(worst.count > 2000);
  CHECK(worst.error < 4e-3 + 0x1p-11);  // the rule's 0.4 %, and half floats
}

TEST_CASE("VulkanReflection, BetweenTexelsAndMipsItIsWithinItsStatedError", "[vulkan]") {
  // Over the largest component there or of the sphere's mean. docs/materials.md states what this prints; a tenth more
  // is left to other devices.
  struct Stated {
    uint32_t size;
    double rms, worst;
  };
  for (const Stated& stated : {Stated{64, 0.077, 2.21}, Stated{128, 0.031, 0.71}}) {
    Worst worst;
    double squares = 0.0, seconds = 1e9;
    for (const NamedSky& named : skiesAndGrounds()) {
      const Baked baked(named.sky, 3, 8);
      Chain chain(baked.sky, stated.size);
      const std::vector<Look> looks = someLooks(200);
      for (const double time_h : {7.0, 12.0}) {
        const auto start = std::chrono::steady_clock::now();
        chain.filter(time_h, UINT32_MAX);
        seconds = std::min(seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        const std::vector<float> light = chain.read(looks);
        const double mean = chain.mean();
        for (std::size_t i = 0; i < looks.size(); ++i) {
          const Number3 truth = chain.truthOf(looks[i]);
          const double size = std::max({truth.x, truth.y, truth.z, mean});
          double off = 0.0;
          for (int c = 0; c < 3; ++c)
            off = std::max(off, std::abs(double{light[4 * i + static_cast<std::size_t>(c)]} - truth[c]) / size);
          worst.compare(off, 0.0, 1.0, [&] { return nameOf(named, time_h, looks[i]); });
          squares += off * off;
        }
      }
    }
    const double rms = std::sqrt(squares / static_cast<double>(worst.count));
    WARN("chain of " << stated.size << " texels: rms " << rms << ", worst " << worst.error << " at " << worst.where
                     << ", all of it in " << seconds << " s at best");
    CHECK(worst.count == 1600);
    CHECK(rms < stated.rms);
    CHECK(worst.error < stated.worst);
  }
}

TEST_CASE("VulkanReflection, PiecesFollowTheDomeInTurn", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  Chain chain(sky, 32);
  constexpr double kBetweenMips = 1e-4;  // rounding of the mip takes a little of its neighbour
  const uint32_t pieces = welkin_vulkan_reflection_pieces(chain.get());
  REQUIRE(pieces == 24);
  const std::vector<Look> looks = [&] {
    std::vector<Look> list;
    for (int mip = 0; mip < 4; ++mip)
      for (int face = 0; face < 6; ++face)
        list.push_back({texelDirection(32 >> mip, face, 1, 2), f64::glossOfMip(mip, 4)});
    return list;
  }();
  CHECK(chain.filter(9.0, 1) == 0);  // the first call filters all
  const std::vector<float> at_9 = chain.read(looks);
  CHECK(chain.filter(9.0, 5) == 0);  // nothing is old
  CHECK(chain.filter(15.0, 7) == pieces - 7);
  const std::vector<float> some = chain.read(looks);
  CHECK(chain.filter(15.0, 10) == pieces - 17);
  CHECK(chain.filter(15.0, 10) == 0);
  const std::vector<float> at_15 = chain.read(looks);
  Chain whole(sky, 32);
  whole.filter(15.0, UINT32_MAX);
  CHECK(at_15 == whole.read(looks));
  for (std::size_t i = 0; i < looks.size(); ++i) {
    CAPTURE(i);
    CHECK(at_9[4 * i] != Approx(at_15[4 * i]).epsilon(0.01));
    CHECK(some[4 * i] == Approx((i < 7 ? at_15 : at_9)[4 * i]).epsilon(kBetweenMips));
  }
  // A dome that changes again begins with the piece that is oldest.
  CHECK(chain.filter(18.0, 20) == 4);
  CHECK(chain.filter(20.0, 8) == pieces - 8);
  const std::vector<float> at_20 = chain.read(looks);
  whole.filter(18.0, UINT32_MAX);
  const std::vector<float> at_18 = whole.read(looks);
  whole.filter(20.0, UINT32_MAX);
  const std::vector<float> whole_20 = whole.read(looks);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    CAPTURE(i);
    CHECK(at_20[4 * i] == Approx((i >= 20 || i < 4 ? whole_20 : at_18)[4 * i]).epsilon(kBetweenMips));
  }
}

TEST_CASE("VulkanReflection, WrongArgumentsAreRefused", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  Chain chain(sky, 16);
  const WelkinVulkanCreateInfo info = render::createInfo(chain.device(), 1);
  for (const uint32_t size : {0U, 8U, 48U, 1024U}) {
    WelkinVulkanReflection* none = chain.get();
    WelkinMessage message{};
    CHECK(welkin_vulkan_reflection_create(&info, chain.sky(), size, &none, &message) == WELKIN_ERROR_ARGUMENT);
    CHECK(none == nullptr);
    CHECK(std::string(message.text) == "size is " + std::to_string(size) + ", must be a power of two from 16 to 512");
  }
  WelkinVulkanReflection* none = nullptr;
  CHECK(welkin_vulkan_reflection_create(&info, nullptr, 16, &none, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_vulkan_reflection_create(nullptr, chain.sky(), 16, &none, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_vulkan_reflection_create(&info, chain.sky(), 16, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  chain.device().execute([&](VkCommandBuffer commands) {
    const auto record = [&](WelkinVulkanReflection* object, VkCommandBuffer c, WelkinVulkanSky* of, uint32_t frame) {
      return welkin_vulkan_reflection_record(object, c, of, frame, 1, nullptr);
    };
    CHECK(record(nullptr, commands, chain.sky(), 0) == WELKIN_ERROR_ARGUMENT);
    CHECK(record(chain.get(), VK_NULL_HANDLE, chain.sky(), 0) == WELKIN_ERROR_ARGUMENT);
    CHECK(record(chain.get(), commands, nullptr, 0) == WELKIN_ERROR_ARGUMENT);
    CHECK(record(chain.get(), commands, chain.sky(), 1) == WELKIN_ERROR_ARGUMENT);
    CHECK(record(chain.get(), commands, chain.sky(), 0) == WELKIN_ERROR_ARGUMENT);  // no update yet
    CHECK(std::string(welkin_argument_error()) ==
          "welkin_vulkan_reflection_record: welkin_vulkan_update was not called for frame 0");
  });
  WelkinVulkanMemory memory{};
  CHECK(welkin_vulkan_reflection_memory(chain.get(), &memory) == WELKIN_OK);
  CHECK(memory.images >= 6 * 8 * (16 * 16 + 8 * 8 + 4 * 4));
  CHECK(memory.staging == 0);
  CHECK(welkin_vulkan_reflection_pieces(nullptr) == 0);
  CHECK(welkin_vulkan_reflection_descriptor_set(nullptr) == VkDescriptorSet{VK_NULL_HANDLE});
  CHECK(welkin_vulkan_reflection_descriptor_set_layout(nullptr) == VkDescriptorSetLayout{VK_NULL_HANDLE});
}

}  // namespace welkin::tests
