#pragma once
#include <cstdint>

namespace vamp {
namespace gpu {
class Device;
}
namespace test {

// That nothing computed of `count` cases of any bits (fuzz.h) is NaN, infinite, or negative where the model forbids it:
// values of the models and of the lobe code, densities, draws.
void expect_numbers_on_the_cpu(uint64_t count, uint32_t seed);
void expect_numbers_on_the_device(gpu::Device& device, uint64_t count, uint32_t seed);

}  // namespace test
}  // namespace vamp
