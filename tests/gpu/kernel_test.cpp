// Kernels through every kind of binding.
#include <numeric>

#include "engine/gpu/timestamps.h"
#include "shaders/spirv.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/kernels/probe.h"

namespace vamp::gpu {
namespace {

using test::ScalePush;

class Kernel : public GpuTest {
 protected:
  std::vector<float> ramp(size_t count) {
    std::vector<float> values(count);
    std::iota(values.begin(), values.end(), 0.0f);
    return values;
  }
};

TEST_F(Kernel, ScalesThroughStorageBuffers) {
  const uint32_t count = 1000;
  TypedBuffer<float> from(*device, "from", count), to(*device, "to", count);
  EXPECT_EQ(device->upload_rows(from, 0, ramp(count)), count * sizeof(float));
  const ComputePipeline pipeline(*device,
                                 {.name = "scale",
                                  .spirv = spirv::scale_storage_comp(),
                                  .bindings = {{0, BindingType::storage_buffer}, {1, BindingType::storage_buffer}},
                                  .push_bytes = sizeof(ScalePush),
                                  .constants = {{0, 2.5f}}});
  const DescriptorSet set(*device, pipeline, {{0, from}, {1, to}});
  CommandList list = device->begin("scale");
  list.bind(pipeline, set);
  list.push(ScalePush{.shift = 0.25f, .count = count});
  list.dispatch((count + 63) / 64);
  const uint64_t value = device->submit(std::move(list));
  const auto result = device->readback_rows(to, 0, count, value);
  for (uint32_t i = 0; i < count; ++i) ASSERT_EQ(result[i], 2.5f * static_cast<float>(i) + 0.25f) << i;
}

TEST_F(Kernel, ScalesThroughTexelBuffers) {
  const uint32_t count = 1000;
  const TypedBuffer<float> from(*device, "from", count, Usage::uniform_texel);
  const TypedBuffer<float> to(*device, "to", count, Usage::storage_texel);
  device->upload_rows(from, 0, ramp(count));
  const TexelView from_view(*device, from, VK_FORMAT_R32G32B32A32_SFLOAT);
  const TexelView to_view(*device, to, VK_FORMAT_R32G32B32A32_SFLOAT);
  EXPECT_EQ(from_view.texels(), count / 4);
  const ComputePipeline pipeline(*device,
                                 {.name = "scale texels",
                                  .spirv = spirv::scale_texels_comp(),
                                  .bindings = {{0, BindingType::uniform_texel}, {1, BindingType::storage_texel}},
                                  .push_bytes = sizeof(ScalePush),
                                  .constants = {{0, -2.0f}}});
  const DescriptorSet set(*device, pipeline, {{0, from_view}, {1, to_view}});
  CommandList list = device->begin();
  list.bind(pipeline, set);
  list.push(ScalePush{.shift = 1.0f, .count = count / 4});
  list.dispatch(4);
  const auto result = device->readback_rows(to, 0, count, device->submit(std::move(list)));
  for (uint32_t i = 0; i < count; ++i) ASSERT_EQ(result[i], 1.0f - 2.0f * static_cast<float>(i)) << i;
}

TEST_F(Kernel, TakesSpecialisationConstantsOfEveryType) {
  const TypedBuffer<float> to(*device, "to", 4);
  const std::vector<Binding> bindings{{0, BindingType::storage_buffer}};
  const auto run = [&](const std::vector<SpecConstant>& constants) {
    const ComputePipeline pipeline(*device, {.name = "specials",
                                             .spirv = spirv::specials_comp(),
                                             .bindings = bindings,
                                             .push_bytes = 0,
                                             .constants = constants});
    const DescriptorSet set(*device, "specials", bindings, {{0, to}});
    CommandList list = device->begin();
    list.bind(pipeline, set);
    list.dispatch(1);
    return device->readback_rows(to, 0, 4, device->submit(std::move(list)));
  };
  EXPECT_EQ(run({}), (std::vector<float>{1, 2, 3, 0}));
  EXPECT_EQ(run({{0, 10u}, {1, -7}, {2, 0.5f}, {7, true}}), (std::vector<float>{10, -7, 0.5f, 1}));
  EXPECT_EQ(run({{7, true}, {1, 5}}), (std::vector<float>{1, 5, 3, 1}));
}

}  // namespace
}  // namespace vamp::gpu
