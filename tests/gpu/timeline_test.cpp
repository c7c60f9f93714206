// The order of work on the queue, and how long things live.
#include <atomic>
#include <thread>

#include "engine/gpu/timestamps.h"
#include "shaders/spirv.h"
#include "tests/gpu/gpu_test.h"

namespace vamp::gpu {
namespace {

constexpr uint32_t kCount = 4096;

class Timeline : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    increment = ComputePipeline(*device, {.name = "increment",
                                          .spirv = spirv::increment_comp(),
                                          .bindings = {{0, BindingType::storage_buffer}},
                                          .push_bytes = 0,
                                          .constants = {}});
    slow = ComputePipeline(*device, {.name = "slow copy",
                                     .spirv = spirv::slow_copy_comp(),
                                     .bindings = {{0, BindingType::storage_buffer}, {1, BindingType::storage_buffer}},
                                     .push_bytes = 0,
                                     .constants = {}});
  }
  void TearDown() override {
    increment = {};
    slow = {};
    GpuTest::TearDown();
  }
  static uint32_t after(uint32_t x, int times) {
    for (int i = 0; i < times; ++i) x = 3 * x + 1;
    return x;
  }
  uint64_t submit_increment(const DescriptorSet& set) {
    CommandList list = device->begin("increment");
    list.bind(increment, set);
    list.dispatch(kCount / 64);
    return device->submit(std::move(list));
  }

  ComputePipeline increment, slow;
};

TEST_F(Timeline, ValuesCountUpAndListsSeeWhatEarlierListsWrote) {
  const TypedBuffer<uint32_t> values(*device, "values", kCount);
  device->upload_rows(values, 0, std::vector<uint32_t>(kCount, 5));
  const DescriptorSet set(*device, increment, {{0, values}});
  const uint64_t before = device->last_submitted();
  for (uint64_t i = 1; i <= 16; ++i) EXPECT_EQ(submit_increment(set), before + i);
  EXPECT_TRUE(device->wait(before + 16));
  for (uint64_t i = 0; i <= 16; ++i) EXPECT_TRUE(device->done(before + i));
  EXPECT_EQ(device->readback_rows(values, 0, kCount, before + 16), std::vector<uint32_t>(kCount, after(5, 16)));
}

TEST_F(Timeline, ABarrierOrdersTheCommandsOfOneList) {
  const TypedBuffer<uint32_t> values(*device, "values", kCount), copy(*device, "copy", kCount);
  const DescriptorSet set(*device, increment, {{0, values}});
  CommandList list = device->begin();
  list.fill(values, 2);
  list.bind(increment, set);
  for (int i = 0; i < 3; ++i) {
    list.barrier();
    list.dispatch(kCount / 64);
  }
  list.barrier(Stage::compute, Stage::transfer);
  list.copy(values, 0, copy, 0, kCount * 4);
  EXPECT_EQ(device->readback_rows(copy, 0, kCount, device->submit(std::move(list))),
            std::vector<uint32_t>(kCount, after(2, 3)));
}

TEST_F(Timeline, IndirectDispatchesReadTheirCounts) {
  const TypedBuffer<uint32_t> values(*device, "values", kCount);
  const TypedBuffer<uint32_t> groups(*device, "groups", 3, Usage::indirect | Usage::storage);
  device->upload_rows(groups, 0, std::vector<uint32_t>{2, 1, 1});
  const DescriptorSet set(*device, increment, {{0, values}});
  CommandList list = device->begin();
  list.fill(values, 0);
  list.barrier();
  list.bind(increment, set);
  list.dispatch_indirect(groups);
  std::vector<uint32_t> expected(kCount, 0);
  std::fill_n(expected.begin(), 128, 1u);
  EXPECT_EQ(device->readback_rows(values, 0, kCount, device->submit(std::move(list))), expected);
}

TEST_F(Timeline, AListThatIsDroppedDoesNothing) {
  const TypedBuffer<uint32_t> values(*device, "values", kCount);
  device->upload_rows(values, 0, std::vector<uint32_t>(kCount, 1));
  const DescriptorSet set(*device, increment, {{0, values}});
  {
    CommandList list = device->begin();
    list.bind(increment, set);
    list.dispatch(kCount / 64);
  }
  EXPECT_EQ(device->readback_rows(values, 0, kCount, submit_increment(set)), std::vector<uint32_t>(kCount, 4));
}

TEST_F(Timeline, HandlesMayGoWhileTheDeviceWorks) {
  const uint64_t before = device->bytes_allocated();
  TypedBuffer<uint32_t> to(*device, "to", kCount);
  const uint64_t with_to = device->bytes_allocated();
  uint64_t value = 0;
  bool retired = false;
  {
    const TypedBuffer<uint32_t> from(*device, "from", kCount);
    device->upload_rows(from, 0, std::vector<uint32_t>(kCount, 77));
    const DescriptorSet set(*device, slow, {{0, from}, {1, to}});
    CommandList list = device->begin();
    list.bind(slow, set);
    list.dispatch(kCount / 64);
    value = device->submit(std::move(list));
    device->retire([&, value] { retired = device->done(value); });
  }
  EXPECT_EQ(device->readback_rows(to, 0, kCount, value), std::vector<uint32_t>(kCount, 77));
  EXPECT_TRUE(retired);
  EXPECT_EQ(device->bytes_allocated(), with_to);
  to = {};
  EXPECT_EQ(device->bytes_allocated(), before);
}

TEST_F(Timeline, ThousandCyclesLeaveNoBytesBehind) {
  const uint64_t before = device->bytes_allocated();
  for (uint32_t i = 0; i < 1000; ++i) {
    const TypedBuffer<uint32_t> values(*device, "values", kCount, Usage::storage | Usage::uniform_texel);
    const TexelView view(*device, values, VK_FORMAT_R32_UINT);
    device->upload_rows(values, 0, std::vector<uint32_t>(kCount, i));
    const DescriptorSet set(*device, increment, {{0, values}});
    if (i % 3 == 0) submit_increment(set);
  }
  device->wait(device->last_submitted());
  EXPECT_EQ(device->bytes_allocated(), before);
}

TEST_F(Timeline, SeveralThreadsShareTheQueue) {
  std::atomic<int> wrong = 0;
  const auto work = [&](uint32_t seed) {
    const TypedBuffer<uint32_t> values(*device, "values", kCount);
    const DescriptorSet set(*device, increment, {{0, values}});
    for (uint32_t i = 0; i < 20; ++i) {
      device->upload_rows(values, 0, std::vector<uint32_t>(kCount, seed + i));
      submit_increment(set);
      const uint64_t value = submit_increment(set);
      if (device->readback_rows(values, 0, kCount, value) != std::vector<uint32_t>(kCount, after(seed + i, 2))) ++wrong;
    }
  };
  std::vector<std::thread> threads;
  for (uint32_t i = 0; i < 4; ++i) threads.emplace_back(work, 1000 * i);
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST_F(Timeline, TimestampsMeasureWhatLiesBetween) {
  const TypedBuffer<uint32_t> from(*device, "from", kCount), to(*device, "to", kCount);
  const DescriptorSet set(*device, slow, {{0, from}, {1, to}});
  Timestamps times(*device, 3);
  EXPECT_LT(times.milliseconds(0, 1), 0);
  CommandList list = device->begin();
  list.fill(from, 1);
  list.barrier();
  list.bind(slow, set);
  list.timestamp(times, 0);
  list.dispatch(kCount / 64);
  list.timestamp(times, 1);
  device->wait(device->submit(std::move(list)));
  if (device->info().timestamp_ns > 0) {
    EXPECT_GE(times.milliseconds(0, 1), 0);
  }
  EXPECT_LT(times.milliseconds(0, 2), 0);
}

}  // namespace
}  // namespace vamp::gpu
