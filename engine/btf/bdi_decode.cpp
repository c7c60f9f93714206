// BDI files whose values cannot be used where they lie: spectral, without the cosine, or with texels left out.
#include <algorithm>

#include "engine/btf/bdi.h"
#include "engine/btf/sample_colour.h"
#include "engine/core/jobs.h"

namespace vamp {

Status decode(const BdiHeader& header, std::span<const std::byte> bytes, Btf& out, std::string_view file,
              Progress* progress) {
  const BonnHeader& bonn = header.bonn;
  VAMP_TRY(const SampleColour colour, SampleColour::of(bonn.channels, out.info(), bonn.has_cosine, {}, file));
  if (progress != nullptr) progress->stage("Converting values");
  const size_t channels = bonn.channels.size();
  std::vector<Half> stored(header.bytes_per_texel / sizeof(Half));
  std::vector<double> sample(channels);
  std::vector<float> values(out.values_per_texel());
  uint64_t next = 0;
  for (size_t t = 0; t < out.texel_count(); ++t) {
    if (progress != nullptr) progress->fraction(static_cast<float>(t) / static_cast<float>(out.texel_count()));
    if (progress != nullptr && progress->cancelled()) return JobQueue::cancelled_error();
    if (header.mask[t] == std::byte{0}) continue;
    std::memcpy(stored.data(), bytes.data() + header.offset(next++), header.bytes_per_texel);
    for (size_t d = 0; d < stored.size() / channels; ++d) {
      for (size_t c = 0; c < channels; ++c) sample[c] = double{float_from_half(stored[d * channels + c])};
      if (!colour.convert(sample, d % bonn.lights.size(), std::span(values).subspan(3 * d).first<3>()))
        return fail(ErrorKind::bad_input, file, place_of(out.info(), t, d), "a finite value", "none");
    }
    out.write_texel(t, values);
    out.forget(t, 1);
  }
  return {};
}

}  // namespace vamp
