// The structs shared by kernels and C++ lie the same way in memory on both sides.
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "shaders/spirv.h"
#include "tests/gpu/kernels/probe.h"
#include "tests/gpu/spirv_reflection.h"

namespace vamp::test {
namespace {

TEST(SpirvReflection, FindsTheOffsetsThatScalarLayoutGives) {
  const auto probe = reflect_struct(spirv::probe_comp(), "Probe");
  ASSERT_TRUE(probe) << probe.error().message();
  const std::map<std::string, uint32_t> expected{{"first", offsetof(Probe, first)}, {"normal", offsetof(Probe, normal)},
                                                 {"index", offsetof(Probe, index)}, {"uv", offsetof(Probe, uv)},
                                                 {"slots", offsetof(Probe, slots)}, {"last", offsetof(Probe, last)}};
  EXPECT_EQ(probe->offsets, expected);
  EXPECT_EQ(probe->stride, sizeof(Probe));
}

TEST(SpirvReflection, ReadsPushConstants) {
  const auto push = reflect_struct(spirv::scale_storage_comp(), "ScalePush");
  ASSERT_TRUE(push) << push.error().message();
  const std::map<std::string, uint32_t> expected{{"shift", 0}, {"count", 4}};
  EXPECT_EQ(push->offsets, expected);
}

TEST(SpirvReflection, SaysWhatIsMissing) {
  EXPECT_FALSE(reflect_struct(spirv::probe_comp(), "Unknown"));
  const std::vector<uint32_t> garbage(100, 7u);
  EXPECT_FALSE(reflect_struct(garbage, "Probe"));
  const auto whole = spirv::probe_comp();
  for (size_t length = 0; length < whole.size(); ++length) {
    const auto cut = reflect_struct(whole.first(length), "Probe");
    if (cut) {
      EXPECT_LE(cut->offsets.size(), 6u);
    }
  }
}

}  // namespace
}  // namespace vamp::test
