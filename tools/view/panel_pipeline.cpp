// SPDX-License-Identifier: Apache-2.0
#include "view/panel_pipeline.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "render/graphics_pipeline.h"
#include "spirv/kPanelsFrag.h"
#include "spirv/kPanelsVert.h"

namespace welkin::view {
namespace {

struct Push {
  float to_device[2];
  float font_size[2];
};

std::unique_ptr<render::FloatTexture> fontTexture(render::VulkanDevice& device) {
  unsigned char* rgba = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&rgba, &width, &height);
  render::FloatImage image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
  const std::size_t count = std::size_t{4} * image.width * image.height;
  image.rgba.reserve(count);
  for (std::size_t i = 0; i < count; ++i) image.rgba.push_back(static_cast<float>(rgba[i]) / 255.0F);
  return std::make_unique<render::FloatTexture>(device, image);
}

/// Makes the buffer as large as needed, with room to grow.
void require(const render::VulkanDevice& device, std::unique_ptr<render::Buffer>& buffer, std::size_t bytes,
             VkBufferUsageFlags usage) {
  if (buffer && buffer->bytes() >= bytes) return;
  buffer = std::make_unique<render::Buffer>(device, std::max<std::size_t>(2 * bytes, 4096), usage);
}

}  // namespace

PanelPipeline::PanelPipeline(render::VulkanDevice& device, VkFormat format)
    : device_(device), font_(fontTexture(device)) {
  try {
    createLayout();
    createSet();
    const VkVertexInputAttributeDescription attributes[3] = {
        {0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, pos)},
        {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, uv)},
        {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ImDrawVert, col)}};
    render::PipelineDescription d;
    d.layout = layout_;
    d.vertex = kPanelsVert;
    d.fragment = kPanelsFrag;
    d.attributes = attributes;
    d.vertex_bytes = sizeof(ImDrawVert);
    d.colours = {format};
    d.dual_source = true;
    pipeline_ = render::createGraphicsPipeline(device.device(), d);
  } catch (...) {
    destroy();
    throw;
  }
}

void PanelPipeline::destroy() {
  vkDestroyPipeline(device_.device(), pipeline_, nullptr);
  vkDestroyPipelineLayout(device_.device(), layout_, nullptr);
  vkDestroyDescriptorPool(device_.device(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.device(), set_layout_, nullptr);
}

void PanelPipeline::createLayout() {
  VkDescriptorSetLayoutBinding binding{};
  binding.descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
  binding.descriptorCount = 1;
  binding.stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
  VkDescriptorSetLayoutCreateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set.bindingCount = 1;
  set.pBindings = &binding;
  render::require(vkCreateDescriptorSetLayout(device_.device(), &set, nullptr, &set_layout_),
                  "vkCreateDescriptorSetLayout");
  const VkPushConstantRange range{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(Push)};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &range;
  render::require(vkCreatePipelineLayout(device_.device(), &layout, nullptr, &layout_), "vkCreatePipelineLayout");
}

void PanelPipeline::createSet() {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 1};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  render::require(vkCreateDescriptorPool(device_.device(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");
  VkDescriptorSetAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &set_layout_;
  render::require(vkAllocateDescriptorSets(device_.device(), &allocate, &set_), "vkAllocateDescriptorSets");
  const VkDescriptorImageInfo image{VK_NULL_HANDLE, font_->image().view(), render::kSampled.layout};
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set_;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
  write.pImageInfo = &image;
  vkUpdateDescriptorSets(device_.device(), 1, &write, 0, nullptr);
}

void PanelPipeline::upload(const ImDrawData& panels) {
  const auto vertex_bytes = static_cast<std::size_t>(panels.TotalVtxCount) * sizeof(ImDrawVert);
  const auto index_bytes = static_cast<std::size_t>(panels.TotalIdxCount) * sizeof(ImDrawIdx);
  require(device_, vertices_, vertex_bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  require(device_, indices_, index_bytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  auto* vertex = vertices_->as<ImDrawVert>();
  auto* index = indices_->as<ImDrawIdx>();
  for (int i = 0; i < panels.CmdListsCount; ++i) {
    const ImDrawList& list = *panels.CmdLists[i];
    vertex = std::copy_n(list.VtxBuffer.Data, list.VtxBuffer.Size, vertex);
    index = std::copy_n(list.IdxBuffer.Data, list.IdxBuffer.Size, index);
  }
}

void PanelPipeline::record(VkCommandBuffer commands, render::Image& over, const ImDrawData& panels) {
  upload(panels);
  over.use(commands, render::kDrawnColour);
  const VkExtent2D extent = over.extent();
  const VkRenderingAttachmentInfo colour =
      render::attachmentOf(over, render::kDrawnColour.layout, VK_ATTACHMENT_LOAD_OP_LOAD);
  render::beginRendering(commands, extent, 1, &colour, nullptr);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &set_, 0, nullptr);
  const VkExtent2D font = font_->image().extent();
  const Push push{{2.0F / static_cast<float>(extent.width), 2.0F / static_cast<float>(extent.height)},
                  {static_cast<float>(font.width), static_cast<float>(font.height)}};
  vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(push), &push);
  const VkDeviceSize offset = 0;
  const VkBuffer vertices = vertices_->handle();
  vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
  vkCmdBindIndexBuffer(commands, indices_->handle(), 0,
                       sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
  uint32_t first_index = 0;
  int32_t first_vertex = 0;
  for (int i = 0; i < panels.CmdListsCount; ++i) {
    const ImDrawList& list = *panels.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr) continue;
      const auto clamped = [](float v, uint32_t high) {
        return static_cast<int32_t>(std::clamp(v, 0.0F, static_cast<float>(high)));
      };
      const int32_t left = clamped(command.ClipRect.x, extent.width), top = clamped(command.ClipRect.y, extent.height);
      const int32_t right = clamped(command.ClipRect.z, extent.width);
      const int32_t bottom = clamped(command.ClipRect.w, extent.height);
      if (right <= left || bottom <= top) continue;
      const VkRect2D scissor{{left, top}, {static_cast<uint32_t>(right - left), static_cast<uint32_t>(bottom - top)}};
      vkCmdSetScissor(commands, 0, 1, &scissor);
      vkCmdDrawIndexed(commands, command.ElemCount, 1, first_index + command.IdxOffset,
                       first_vertex + static_cast<int32_t>(command.VtxOffset), 0);
    }
    first_index += static_cast<uint32_t>(list.IdxBuffer.Size);
    first_vertex += list.VtxBuffer.Size;
  }
  vkCmdEndRendering(commands);
}

}  // namespace welkin::view
