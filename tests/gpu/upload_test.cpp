// Uploads come after the work submitted before them and before the work submitted after them, whatever way they take.
#include <numeric>

#include "shaders/spirv.h"
#include "tests/gpu/gpu_test.h"

namespace vamp::gpu {
namespace {

constexpr uint32_t kCount = 4096;

class Upload : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    slow = ComputePipeline(*device, {.name = "slow copy",
                                     .spirv = spirv::slow_copy_comp(),
                                     .bindings = {{0, BindingType::storage_buffer}, {1, BindingType::storage_buffer}},
                                     .push_bytes = 0,
                                     .constants = {}});
  }
  void TearDown() override {
    slow = {};
    GpuTest::TearDown();
  }
  uint64_t submit_copy(const TypedBuffer<uint32_t>& from, const TypedBuffer<uint32_t>& to) {
    const DescriptorSet set(*device, slow, {{0, from}, {1, to}});
    CommandList list = device->begin("slow copy");
    list.bind(slow, set);
    list.dispatch(kCount / 64);
    return device->submit(std::move(list));
  }
  static std::vector<uint32_t> rows(uint32_t value, size_t count = kCount) {
    return std::vector<uint32_t>(count, value);
  }

  ComputePipeline slow;
};

TEST_F(Upload, IntoABufferInUseWaitsItsTurn) {
  const TypedBuffer<uint32_t> from(*device, "from", kCount), first(*device, "first", kCount),
      second(*device, "second", kCount);
  device->upload_rows(from, 0, rows(1));
  submit_copy(from, first);
  device->upload_rows(from, 0, rows(2));
  const uint64_t value = submit_copy(from, second);
  EXPECT_EQ(device->readback_rows(first, 0, kCount, value), rows(1));
  EXPECT_EQ(device->readback_rows(second, 0, kCount, value), rows(2));
}

TEST_F(Upload, TheLastOfOverlappingUploadsWins) {
  const TypedBuffer<uint32_t> from(*device, "from", kCount), to(*device, "to", kCount);
  device->upload_rows(from, 0, rows(1));
  submit_copy(from, to);  // from is in use now
  device->upload_rows(from, 0, rows(2));
  device->upload_rows(from, 100, rows(3, 50));
  device->upload_rows(from, 120, rows(4, 10));
  std::vector<uint32_t> expected = rows(2);
  std::fill_n(expected.begin() + 100, 50, 3u);
  std::fill_n(expected.begin() + 120, 10, 4u);
  EXPECT_EQ(device->readback_rows(from, 0, kCount, 0), expected);
  // The buffer is idle again: written directly where that is possible, with the same result.
  device->upload_rows(from, 0, rows(9, 7));
  std::fill_n(expected.begin(), 7, 9u);
  EXPECT_EQ(device->readback_rows(from, 0, kCount, submit_copy(from, to)), expected);
  EXPECT_EQ(device->readback_rows(to, 0, kCount, device->last_submitted()), expected);
}

TEST_F(Upload, LargerThanTheStagingRingArrivesWhole) {
  const uint64_t count = 6 << 20;  // 24 MiB
  const TypedBuffer<uint32_t> from(*device, "from", count), to(*device, "to", kCount);
  submit_copy(from, to);
  std::vector<uint32_t> values(count);
  std::iota(values.begin(), values.end(), 0u);
  EXPECT_EQ(device->upload_rows(from, 0, values), count * 4);
  EXPECT_EQ(device->readback_rows(from, 0, count, 0), values);
}

TEST_F(Upload, ManySmallOnesGoRoundTheRing) {
  const TypedBuffer<uint32_t> from(*device, "from", kCount), to(*device, "to", kCount);
  device->upload_rows(from, 0, rows(0));
  const size_t piece = 999;  // not a divisor of the ring
  for (uint32_t i = 0; i < 3000; ++i) {
    if (i % 100 == 0) submit_copy(from, to);
    device->upload_rows(from, i % 3000, rows(i, piece));
  }
  const auto result = device->readback_rows(from, 0, kCount, 0);
  for (uint32_t i = 0; i < 3000; ++i) ASSERT_EQ(result[i], i);
  for (uint32_t i = 3000; i < 3000 + piece - 1; ++i) ASSERT_EQ(result[i], 2999u);
}

TEST_F(Upload, IsCountedInBytes) {
  const TypedBuffer<uint32_t> from(*device, "from", kCount), to(*device, "to", kCount);
  const uint64_t before = device->bytes_uploaded();
  EXPECT_EQ(device->upload_rows(from, 8, rows(1, 12)), 48u);
  submit_copy(from, to);
  EXPECT_EQ(device->upload_rows(from, 8, rows(1, 12)), 48u);
  EXPECT_EQ(device->upload_rows(from, 0, rows(1, 0)), 0u);
  EXPECT_EQ(device->bytes_uploaded() - before, 96u);
}

TEST_F(Upload, TheMemoryOfADroppedBufferStaysUntilItsCopyIsDone) {
  uint64_t before = 0;
  {
    const TypedBuffer<uint32_t> from(*device, "from", kCount), to(*device, "to", kCount);
    submit_copy(from, to);
    device->upload_rows(from, 0, rows(2));  // takes the staging ring
    device->wait(device->submit(device->begin()));
    before = device->bytes_allocated() - 2 * kCount * 4;
    submit_copy(from, to);
    device->upload_rows(from, 0, rows(3));
  }
  device->wait(device->submit(device->begin()));
  EXPECT_EQ(device->bytes_allocated(), before);
}

TEST_F(Upload, EmptyBuffersMayBeBound) {
  const TypedBuffer<uint32_t> none(*device, "none", 0), to(*device, "to", kCount);
  const DescriptorSet set(*device, slow, {{0, none}, {1, to}});
  EXPECT_EQ(none.count(), 0u);
  EXPECT_EQ(device->upload_rows(none, 0, {}), 0u);
}

}  // namespace
}  // namespace vamp::gpu
