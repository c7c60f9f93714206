#pragma once
// Random numbers that are the same on every machine: a stream for each path, and a hash for each place.
#include <bit>
#include <cstdint>

namespace vamp::acquire {

// SplitMix64's finaliser (Steele et al. 2014, "Fast splittable pseudorandom number generators").
constexpr uint64_t mix_bits(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

constexpr uint64_t hash_bits(uint64_t a, uint64_t b, uint64_t c = 0, uint64_t d = 0) {
  uint64_t z = mix_bits(a + 0x9e3779b97f4a7c15ull);
  z = mix_bits(z ^ (b + 0xc2b2ae3d27d4eb4full));
  z = mix_bits(z ^ (c + 0x165667b19e3779f9ull));
  return mix_bits(z ^ (d + 0x27d4eb2f165667c5ull));
}

class Random {
 public:
  explicit Random(uint64_t key) : state_(key) {}
  // In [0, 1): 24 bits.
  float next() { return static_cast<float>(bits() >> 40) * 0x1p-24f; }
  uint64_t bits() { return mix_bits(state_ += 0x9e3779b97f4a7c15ull); }

 private:
  uint64_t state_;
};

}  // namespace vamp::acquire
