#pragma once
// The texture as a picture under some pairs of directions, from a measurement and from what represents it.
#include <vector>

#include "engine/fit/columns.h"
#include "engine/fit/rows.h"

namespace vamp::fit {

// Ten pairs whose directions lie within 72 degrees of the normal, the same for the same directions; none where the
// texture is smaller than MSSIM's window at two texels a pixel. Different texels may be set from different threads.
class Pictures {
 public:
  Pictures(const Pairs& pairs, int width, int height, size_t representations);

  size_t count() const { return chosen_.size(); }
  // A texel's values, [channel][pair].
  void set_truth(size_t texel, const float* values) { set_in(truth_, texel, values); }
  void set(size_t representation, size_t texel, const float* values) { set_in(seen_[representation], texel, values); }

  // Means over the pictures as a display shows them (the 99.5th percentile of the truth at 1, sRGB): PSNR in dB and
  // MSSIM of luminance, at one texel a pixel and at two.
  void compare(size_t representation, double& psnr, double& mssim, double& half_psnr, double& half_mssim) const;

 private:
  void set_in(std::vector<float>& pictures, size_t texel, const float* values);
  size_t pairs_;
  int width_, height_;
  std::vector<size_t> chosen_;
  std::vector<float> truth_;  // [picture][texel][channel]
  std::vector<std::vector<float>> seen_;
};

}  // namespace vamp::fit
