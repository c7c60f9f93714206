#pragma once
// Sequences of edits at random moments, and the picture that a fresh render gives in the end.
#include <cstdint>
#include <random>
#include <vector>

#include "engine/render/renderer.h"
#include "tests/render/render_test.h"

namespace vamp::test {

// Two rich materials, a lamp and ambient, small enough to be rendered a thousand times.
Project two_materials();

class EditedPicture : public RenderTest {
 protected:
  static constexpr int kWidth = 72, kHeight = 70;

  void show(Renderer& renderer, const Project& project);
  // All tiles to the same number of samples.
  std::vector<float> finish(Renderer& renderer, uint32_t samples);
  std::vector<float> fresh(const Project& project, uint32_t samples);

  // Edits, selects, refines and shades again in random order, then compares with a fresh render of what came out:
  // byte for byte, or to 1e-5 of the sum of magnitudes once sums of weights have answered an edit.
  struct Sequence {
    uint64_t history = 0;  // bytes for stored hits
    float mirror = 0;      // of the floor
    bool weights = false;  // rows are selected now and then, and their sums gathered
    bool moves = false;    // parts are moved, turned, hidden and shown now and then
    uint32_t seed = 0;
  };
  void run(const Sequence& sequence);
  uint64_t recombined = 0;  // edits answered from sums so far
  uint64_t trees = 0;       // made anew because of moves so far

  Change last;

 private:
  // Kept from one sequence to the next: their kernels are compiled once.
  std::unique_ptr<Renderer> edited_, fresh_;
  void settle(Renderer& renderer);
};

bool same_bytes(const std::vector<float>& a, const std::vector<float>& b);
// Largest difference of two pictures, each pixel's in relation to what light it deals with: what it shows in both, what
// it showed in `before`, and a hundredth of the mean.
double largest_difference(const std::vector<float>& a, const std::vector<float>& b, const std::vector<float>& before);

}  // namespace vamp::test
