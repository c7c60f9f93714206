// Pipelines that are made beside the queue, and what keeps the driver from compiling them again.
#include <atomic>
#include <bit>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "engine/gpu/background_pipelines.h"
#include "engine/gpu/driver_cache.h"
#include "engine/gpu/resource.h"
#include "shaders/spirv.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/kernels/probe.h"
#include "tests/material/temporary_folder.h"

namespace vamp::gpu {
namespace {

class Background : public GpuTest {
 protected:
  const std::vector<Binding> bindings = {{0, BindingType::uniform_texel}, {1, BindingType::storage_texel}};
  PipelineDesc scale_by(float factor) const {
    return {.name = "scale",
            .spirv = spirv::scale_texels_comp(),
            .bindings = bindings,
            .push_bytes = sizeof(test::ScalePush),
            .constants = {{0, factor}}};
  }
};

TEST_F(Background, PipelinesDoWhatThoseMadeHereDo) {
  constexpr uint32_t kTexels = 10;
  const TypedBuffer<float> from(*device, "from", 4 * kTexels, Usage::uniform_texel);
  const TypedBuffer<float> to(*device, "to", 4 * kTexels, Usage::storage_texel);
  device->upload_rows(from, 0, std::vector<float>(4 * kTexels, 3.0f));
  const TexelView from_view(*device, from, VK_FORMAT_R32G32B32A32_SFLOAT);
  const TexelView to_view(*device, to, VK_FORMAT_R32G32B32A32_SFLOAT);
  const std::vector<Bound> bound = {{0, from_view}, {1, to_view}};
  const DescriptorSet set(*device, "numbers", bindings, bound);

  std::atomic<int> arrived = 0;
  std::optional<BackgroundPipelines> background;
  background.emplace(*device, [&] { ++arrived; });
  using enum BackgroundPipelines::Urgency;
  background->want(0, scale_by(2), spare);
  background->want(1, scale_by(5), straight);
  background->bound_as(bindings, bound);
  background->raise(0, at_once);
  int taken = 0;
  while (taken < 2) {
    background->wait();
    for (const auto& [number, pipeline] : background->take()) {
      ++taken;
      CommandList list = device->begin("scale");
      list.bind(pipeline, set);
      list.push(test::ScalePush{.shift = 1, .count = kTexels});
      list.dispatch(1);
      const auto result = device->readback_rows(to, 0, 4 * kTexels, device->submit(std::move(list)));
      for (const float x : result) EXPECT_EQ(x, number == 0 ? 7.0f : 16.0f);
    }
  }
  background.reset();  // a pipeline can be taken before the thread that made it says so
  EXPECT_GE(arrived.load(), 1);
}

TEST_F(Background, WhatIsNotBegunCanBeDropped) {
  BackgroundPipelines background(*device, {});
  // Nothing says what will be bound, so that on lavapipe none is begun.
  for (uint64_t i = 0; i < 20; ++i)
    background.want(i, scale_by(static_cast<float>(i)), BackgroundPipelines::Urgency::soon);
  const size_t dropped = background.drop_wanted().size();
  EXPECT_EQ(dropped, device->info().is_lavapipe && !driver_caches().empty() ? 20u : dropped);
  EXPECT_TRUE(background.drop_wanted().empty());
}

TEST_F(Background, IsOfNoUseWhereTheDriverCompilesOnTheQueueAndKeepsNothing) {
  const char* const before = std::getenv("MESA_SHADER_CACHE_DISABLE");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  EXPECT_TRUE(driver_caches().empty());
  EXPECT_EQ(BackgroundPipelines::useful(*device), !device->info().is_lavapipe);
  before != nullptr ? ::setenv("MESA_SHADER_CACHE_DISABLE", kept.c_str(), 1) : ::unsetenv("MESA_SHADER_CACHE_DISABLE");
}

TEST(DriverCaches, AreSeenToGrowWhereverADriverKeepsItsKernels) {
  const vamp::test::TemporaryFolder base;
  const char* const before = std::getenv("MESA_SHADER_CACHE_DIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("MESA_SHADER_CACHE_DIR", base.path().c_str(), 1);
  EXPECT_TRUE(driver_caches().empty());
  for (const char* folder : {"mesa_shader_cache/00", "mesa_shader_cache_db/part0"}) {
    fs::create_directories(base.path() / folder);
    const std::vector<fs::path> caches = driver_caches();
    const fs::file_time_type last = last_change(caches);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::ofstream(base.path() / folder / "kernel") << "bits";
    EXPECT_GT(last_change(caches), last) << folder;
  }
  EXPECT_EQ(driver_caches().size(), 2u);
  before != nullptr ? ::setenv("MESA_SHADER_CACHE_DIR", kept.c_str(), 1) : ::unsetenv("MESA_SHADER_CACHE_DIR");
}

// lavapipe compiles anew for sizes that are a power of two, and for views whose bits 8 to 15 of the size are 0.
TEST_F(Background, TexelBuffersOfAnySizeAreAlikeToTheDriver) {
  for (const uint64_t bytes : {0u, 1u, 16u, 255u, 256u, 257u, 272u, 511u, 512u, 1024u, 4096u, 65520u, 65536u, 65552u,
                               65792u, 131072u, 1048576u, 1048592u, 16777216u}) {
    const Buffer buffer(*device, {.name = "rows", .bytes = bytes, .usage = Usage::uniform_texel});
    EXPECT_EQ(buffer.bytes(), bytes);
    const uint64_t there = buffer.state()->bytes;
    EXPECT_GE(there, bytes);
    EXPECT_LE(there, bytes + 1024);
    EXPECT_FALSE(std::has_single_bit(there)) << bytes;
    EXPECT_NE(there >> 8 & 255, 0u) << bytes;
    const TexelView view(*device, buffer, VK_FORMAT_R32G32B32A32_SFLOAT);
    EXPECT_EQ(view.texels(), bytes / 16);
  }
}

}  // namespace
}  // namespace vamp::gpu
