#pragma once
// Files that the program reads but does not write, made by OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vamp::testing {

inline std::vector<std::byte> oiio_encoded(const std::string& format, OIIO::ImageSpec spec,
                                           const std::vector<float>& pixels) {
  std::vector<unsigned char> out;
  OIIO::Filesystem::IOVecOutput writer(out);
  OIIO::Filesystem::IOProxy* proxy = &writer;
  spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  const auto output = OIIO::ImageOutput::create(format);
  if (!output || !output->open("memory." + format, spec) || !output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()))
    return {};
  output->close();
  const auto* first = reinterpret_cast<const std::byte*>(out.data());
  return {first, first + out.size()};
}

}  // namespace vamp::testing
