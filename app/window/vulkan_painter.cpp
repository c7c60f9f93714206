// The user interface through the graphics pipeline, for real GPUs.
#include <algorithm>
#include <array>
#include <cstring>

#include "app/window/painter.h"
#include "app/window/vulkan_textures.h"
#include "engine/core/hash.h"
#include "engine/gpu/machine.h"

namespace vamp::window {

using gpu::require;

namespace {

const uint32_t kVertexShader[] = {
#include "ui.vert.inc"
};
const uint32_t kFragmentShader[] = {
#include "ui.frag.inc"
};

constexpr size_t kFrames = 3;  // that may be in flight

// One call of vkCmdDraw.
struct Draw {
  ImTextureID texture;
  VkRect2D scissor;
  uint32_t first;
  uint32_t count;
};

struct Frame {
  gpu::TypedBuffer<ImDrawVert> vertices;
  gpu::TypedBuffer<uint32_t> indices;
  VkDescriptorSet set = VK_NULL_HANDLE;
  uint64_t value = 0;
};

class VulkanPainter final : public Painter {
 public:
  VulkanPainter(gpu::Device& device, const Textures& textures)
      : device_(device), pictures_(device, textures), table_(textures) {
    make_layouts();
    make_render_pass();
    make_pipeline();
  }

  ~VulkanPainter() override {
    device_.wait(device_.last_submitted());
    release_targets();
    const VkDevice d = device_.handle();
    vkDestroyPipeline(d, pipeline_, nullptr);
    vkDestroyRenderPass(d, pass_, nullptr);
    vkDestroyPipelineLayout(d, pipeline_layout_, nullptr);
    vkDestroyDescriptorPool(d, pool_, nullptr);
    vkDestroyDescriptorSetLayout(d, set_layout_, nullptr);
  }

  bool resize(uint32_t width, uint32_t height, std::span<const VkImage> images) override {
    // The swapchain has waited for the queue before it made new images.
    release_targets();
    extent_ = {width, height};
    for (const VkImage image : images) {
      VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
      view.image = image;
      view.viewType = VK_IMAGE_VIEW_TYPE_2D;
      view.format = VK_FORMAT_B8G8R8A8_UNORM;
      view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
      views_.emplace_back();
      require(vkCreateImageView(device_.handle(), &view, nullptr, &views_.back()), "window image");
      VkFramebufferCreateInfo target{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
      target.renderPass = pass_;
      target.attachmentCount = 1;
      target.pAttachments = &views_.back();
      target.width = width;
      target.height = height;
      target.layers = 1;
      targets_.emplace_back();
      require(vkCreateFramebuffer(device_.handle(), &target, nullptr, &targets_.back()), "window image");
    }
    forget();
    return true;
  }

  bool prepare(const ImDrawData& data) override {
    const uint64_t hash = hash_of(data);
    if (hash == hash_ || extent_.width == 0) return false;
    hash_ = hash;
    frame_ = (frame_ + 1) % kFrames;
    Frame& frame = frames_[frame_];
    if (frame.value != 0) device_.wait(frame.value);
    reserve(frame, static_cast<uint64_t>(data.TotalVtxCount), static_cast<uint64_t>(data.TotalIdxCount));
    copy(data, frame);
    return true;
  }

  void record(gpu::CommandList& list, VkImage, uint32_t index) override {
    pictures_.sweep();
    std::vector<VkDescriptorSet> sets;
    for (const Draw& draw : draws_) sets.push_back(pictures_.prepare(list, draw.texture));
    const Frame& frame = frames_[frame_];
    list.use(frame.vertices);
    list.use(frame.indices);
    const VkCommandBuffer c = list.handle();
    VkClearValue clear{};
    clear.color.float32[3] = 1;
    VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    begin.renderPass = pass_;
    begin.framebuffer = targets_[index];
    begin.renderArea.extent = extent_;
    begin.clearValueCount = 1;
    begin.pClearValues = &clear;
    vkCmdBeginRenderPass(c, &begin, VK_SUBPASS_CONTENTS_INLINE);
    vkCmdBindPipeline(c, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    const VkViewport viewport{0, 0, static_cast<float>(extent_.width), static_cast<float>(extent_.height), 0, 1};
    vkCmdSetViewport(c, 0, 1, &viewport);
    const float to_clip[2] = {2 / viewport.width, 2 / viewport.height};
    vkCmdPushConstants(c, pipeline_layout_, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof to_clip, to_clip);
    vkCmdBindDescriptorSets(c, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_layout_, 0, 1, &frame.set, 0, nullptr);
    VkDescriptorSet bound = VK_NULL_HANDLE;
    for (size_t i = 0; i < draws_.size(); ++i) {
      if (sets[i] == VK_NULL_HANDLE) continue;
      if (sets[i] != bound) {
        vkCmdBindDescriptorSets(c, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_layout_, 1, 1, &sets[i], 0, nullptr);
        bound = sets[i];
      }
      vkCmdSetScissor(c, 0, 1, &draws_[i].scissor);
      vkCmdDraw(c, draws_[i].count, 1, draws_[i].first, 0);
    }
    vkCmdEndRenderPass(c);
  }

  void submitted(uint64_t value) override { frames_[frame_].value = value; }
  void forget() override { hash_ = 0; }
  const char* name() const override { return "Vulkan"; }

 private:
  void make_layouts();
  void make_render_pass();
  void make_pipeline();

  void release_targets() {
    for (const VkFramebuffer target : targets_) vkDestroyFramebuffer(device_.handle(), target, nullptr);
    for (const VkImageView view : views_) vkDestroyImageView(device_.handle(), view, nullptr);
    targets_.clear();
    views_.clear();
  }

  uint64_t hash_of(const ImDrawData& data) const {
    uint64_t hash = 1;
    const auto add = [&](const void* bytes, size_t count) {
      hash = hash64({static_cast<const std::byte*>(bytes), count}, hash);
    };
    for (int n = 0; n < data.CmdListsCount; ++n) {
      const ImDrawList& l = *data.CmdLists[n];
      add(l.VtxBuffer.Data, static_cast<size_t>(l.VtxBuffer.size_in_bytes()));
      add(l.IdxBuffer.Data, static_cast<size_t>(l.IdxBuffer.size_in_bytes()));
      for (const ImDrawCmd& command : l.CmdBuffer) {
        const Texture* texture = table_.find(command.GetTexID());
        const uint64_t words[] = {command.ElemCount, texture != nullptr ? texture->revision : 0};
        add(&command.ClipRect, sizeof command.ClipRect);
        add(words, sizeof words);
      }
    }
    return hash | 1;  // 0 means nothing drawn yet
  }

  void reserve(Frame& frame, uint64_t vertices, uint64_t indices) {
    if (frame.set != VK_NULL_HANDLE && frame.vertices.count() >= vertices && frame.indices.count() >= indices) return;
    frame.vertices = {device_, "user interface vertices", std::max<uint64_t>(vertices * 3 / 2, 8192),
                      gpu::Usage::storage, gpu::Memory::upload};
    frame.indices = {device_, "user interface indices", std::max<uint64_t>(indices * 3 / 2, 16384), gpu::Usage::storage,
                     gpu::Memory::upload};
    if (frame.set == VK_NULL_HANDLE) {
      VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
      info.descriptorPool = pool_;
      info.descriptorSetCount = 1;
      info.pSetLayouts = &set_layout_;
      require(vkAllocateDescriptorSets(device_.handle(), &info, &frame.set), "user interface buffers");
    }
    const VkDescriptorBufferInfo buffers[] = {{frame.vertices.handle(), 0, VK_WHOLE_SIZE},
                                              {frame.indices.handle(), 0, VK_WHOLE_SIZE}};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = frame.set;
    write.descriptorCount = 2;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = buffers;
    vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
  }

  void copy(const ImDrawData& data, Frame& frame) {
    draws_.clear();
    ImDrawVert* vertices = frame.vertices.mapped_rows().data();
    uint32_t* indices = frame.indices.mapped_rows().data();
    uint32_t first_vertex = 0, first_index = 0;
    for (int n = 0; n < data.CmdListsCount; ++n) {
      const ImDrawList& l = *data.CmdLists[n];
      std::memcpy(vertices + first_vertex, l.VtxBuffer.Data, static_cast<size_t>(l.VtxBuffer.size_in_bytes()));
      for (const ImDrawCmd& command : l.CmdBuffer) {
        const uint32_t start = first_index;
        for (uint32_t i = 0; i < command.ElemCount; ++i) {
          const ImDrawIdx index = l.IdxBuffer.Data[command.IdxOffset + i];
          indices[first_index++] = first_vertex + command.VtxOffset + index;
        }
        const auto edge = [](float x, uint32_t most) {
          return static_cast<int32_t>(std::clamp(x, 0.0f, static_cast<float>(most)));
        };
        const ImVec4& r = command.ClipRect;
        const int32_t x0 = edge(r.x, extent_.width), y0 = edge(r.y, extent_.height);
        const int32_t x1 = edge(r.z, extent_.width), y1 = edge(r.w, extent_.height);
        if (command.UserCallback != nullptr || x1 <= x0 || y1 <= y0) continue;
        draws_.push_back({command.GetTexID(),
                          {{x0, y0}, {static_cast<uint32_t>(x1 - x0), static_cast<uint32_t>(y1 - y0)}},
                          start,
                          command.ElemCount});
      }
      first_vertex += static_cast<uint32_t>(l.VtxBuffer.Size);
    }
  }

  gpu::Device& device_;
  VulkanTextures pictures_;
  const Textures& table_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkPipelineLayout pipeline_layout_ = VK_NULL_HANDLE;
  VkRenderPass pass_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
  std::vector<VkImageView> views_;
  std::vector<VkFramebuffer> targets_;
  std::array<Frame, kFrames> frames_;
  size_t frame_ = 0;
  std::vector<Draw> draws_;
  uint64_t hash_ = 0;
};

void VulkanPainter::make_layouts() {
  VkDescriptorSetLayoutBinding bindings[2] = {};
  for (uint32_t i = 0; i < 2; ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_VERTEX_BIT;
  }
  VkDescriptorSetLayoutCreateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set.bindingCount = 2;
  set.pBindings = bindings;
  require(vkCreateDescriptorSetLayout(device_.handle(), &set, nullptr, &set_layout_), "user interface layout");
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2 * kFrames};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = kFrames;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  require(vkCreateDescriptorPool(device_.handle(), &pool, nullptr, &pool_), "user interface buffers");
  const VkDescriptorSetLayout sets[] = {set_layout_, pictures_.layout()};
  const VkPushConstantRange push{VK_SHADER_STAGE_VERTEX_BIT, 0, 8};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 2;
  layout.pSetLayouts = sets;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &push;
  require(vkCreatePipelineLayout(device_.handle(), &layout, nullptr, &pipeline_layout_), "user interface layout");
}

void VulkanPainter::make_render_pass() {
  VkAttachmentDescription image{};
  image.format = VK_FORMAT_B8G8R8A8_UNORM;
  image.samples = VK_SAMPLE_COUNT_1_BIT;
  image.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  image.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  image.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  image.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  image.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  VkSubpassDependency dependency{};
  dependency.srcSubpass = VK_SUBPASS_EXTERNAL;
  dependency.srcStageMask = dependency.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  dependency.dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = 1;
  info.pAttachments = &image;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = 1;
  info.pDependencies = &dependency;
  require(vkCreateRenderPass(device_.handle(), &info, nullptr, &pass_), "user interface pass");
}

void VulkanPainter::make_pipeline() {
  const auto module_of = [&](std::span<const uint32_t> words) {
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule shader = VK_NULL_HANDLE;
    require(vkCreateShaderModule(device_.handle(), &info, nullptr, &shader), "user interface shader");
    return shader;
  };
  VkPipelineShaderStageCreateInfo stages[2] = {};
  for (VkPipelineShaderStageCreateInfo& stage : stages) {
    stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    stage.pName = "main";
  }
  stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
  stages[0].module = module_of(kVertexShader);
  stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  stages[1].module = module_of(kFragmentShader);
  const VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState blend{};
  blend.blendEnable = VK_TRUE;
  blend.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
  blend.dstColorBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  blend.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  blend.colorWriteMask = 0xf;
  VkPipelineColorBlendStateCreateInfo blending{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blending.attachmentCount = 1;
  blending.pAttachments = &blend;
  const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = states;
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.stageCount = 2;
  info.pStages = stages;
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pColorBlendState = &blending;
  info.pDynamicState = &dynamic;
  info.layout = pipeline_layout_;
  info.renderPass = pass_;
  const VkResult made = vkCreateGraphicsPipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
  for (const VkPipelineShaderStageCreateInfo& stage : stages) {
    vkDestroyShaderModule(device_.handle(), stage.module, nullptr);
  }
  require(made, "user interface pipeline");
}

}  // namespace

std::unique_ptr<Painter> make_vulkan_painter(gpu::Device& device, const Textures& textures) {
  return std::make_unique<VulkanPainter>(device, textures);
}

}  // namespace vamp::window
