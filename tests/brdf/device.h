#pragma once
// One device with validation for all tests of a suite; every test asserts that validation said nothing.
#include <gtest/gtest.h>

#include "engine/gpu/device.h"
#include "engine/probe/brdf_probe.h"

namespace vamp::test {

class OnTheDevice : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gpu::Device::create({.device = {}, .validate = true});
    ASSERT_TRUE(made) << made.error().message();
    device = std::move(*made);
    probe = std::make_unique<BrdfProbe>(*device);
  }
  static void TearDownTestSuite() {
    probe.reset();
    device.reset();
  }
  void SetUp() override { ASSERT_TRUE(probe); }
  void TearDown() override {
    for (const auto& message : device->validation_messages()) ADD_FAILURE() << message;
  }

  inline static std::unique_ptr<gpu::Device> device;
  inline static std::unique_ptr<BrdfProbe> probe;
};

}  // namespace vamp::test
