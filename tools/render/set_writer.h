// SPDX-License-Identifier: Apache-2.0
// Collects the writes of a descriptor set and applies them.
#pragma once

#include <cstdint>

#include "render/image.h"
#include "render/shaders/level_constants.h"

namespace welkin::render {

class SetWriter {
 public:
  explicit SetWriter(VkDescriptorSet set) : set_(set) {}

  /// `binding` is below WELKIN_LEVEL_BINDINGS, and written once.
  void buffer(uint32_t binding, VkDescriptorType type, VkBuffer handle) {
    buffers_[binding] = {handle, 0, VK_WHOLE_SIZE};
    write(binding, type);
  }
  void image(uint32_t binding, VkSampler sampler, const Image& image, VkImageLayout layout) {
    images_[binding] = {sampler, image.view(), layout};
    write(binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
  }
  void commit(VkDevice device) const { vkUpdateDescriptorSets(device, count_, writes_, 0, nullptr); }

 private:
  void write(uint32_t binding, VkDescriptorType type) {
    VkWriteDescriptorSet& w = writes_[count_++];
    w = {};
    w.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    w.dstSet = set_;
    w.dstBinding = binding;
    w.descriptorCount = 1;
    w.descriptorType = type;
    w.pBufferInfo = &buffers_[binding];
    w.pImageInfo = &images_[binding];
  }

  VkDescriptorSet set_;
  uint32_t count_ = 0;
  VkWriteDescriptorSet writes_[WELKIN_LEVEL_BINDINGS] = {};
  VkDescriptorBufferInfo buffers_[WELKIN_LEVEL_BINDINGS] = {};
  VkDescriptorImageInfo images_[WELKIN_LEVEL_BINDINGS] = {};
};

}  // namespace welkin::render
