#pragma once
// One device with validation for a test program; every test asserts that validation said nothing.
#include <gtest/gtest.h>

#include "engine/gpu/device.h"
#include "engine/render/still.h"
#include "tests/render/scenes.h"

namespace vamp {

class RenderTest : public testing::Test {
 protected:
  void SetUp() override {
    auto made = gpu::Device::create({.device = {}, .validate = true});
    ASSERT_TRUE(made) << made.error().message();
    device = std::move(*made);
  }
  void TearDown() override {
    if (!device) return;
    for (const auto& message : device->validation_messages()) ADD_FAILURE() << message;
  }

  Still render(const Project& project, int width, int height, uint32_t samples, std::vector<Layer> layers = {}) {
    auto still =
        render_still(*device, std::make_shared<const Project>(project),
                     {.width = width, .height = height, .samples = samples, .layers = std::move(layers)}, nullptr);
    EXPECT_TRUE(still) << still.error().message();
    return still ? std::move(*still) : Still{};
  }

  std::unique_ptr<gpu::Device> device;
};

// Mean of a channel over the middle quarter of a picture.
inline double middle_mean(const Image& image, size_t channel) {
  double sum = 0;
  int count = 0;
  for (int y = image.height * 3 / 8; y < image.height * 5 / 8; ++y)
    for (int x = image.width * 3 / 8; x < image.width * 5 / 8; ++x, ++count)
      sum += static_cast<double>(image.at(x, y, channel));
  return sum / count;
}

}  // namespace vamp
