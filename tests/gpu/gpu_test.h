#pragma once
// A device with validation for each test, and nothing left over at its end.
#include <gtest/gtest.h>

#include <memory>

#include "engine/gpu/device.h"

namespace vamp::gpu {

class GpuTest : public testing::Test {
 protected:
  void SetUp() override {
    auto made = Device::create({.device = {}, .validate = true, .validate_synchronization = true});
    ASSERT_TRUE(made) << made.error().message();
    device = std::move(*made);
  }
  void TearDown() override {
    if (!device) return;
    EXPECT_EQ(device->validation_count(), 0u);
    for (const auto& message : device->validation_messages()) ADD_FAILURE() << message;
  }

  std::unique_ptr<Device> device;
};

}  // namespace vamp::gpu
