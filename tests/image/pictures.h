#pragma once
// Small pictures and folders for the tests of engine/image.
#include <gtest/gtest.h>

#include <random>

#include "engine/core/files.h"
#include "engine/image/image.h"

namespace vamp::testing {

inline Image noise_image(int width, int height, std::vector<std::string> channels, unsigned seed, float low = 0.0f,
                         float high = 1.0f) {
  Image image(width, height, std::move(channels));
  std::mt19937 random(seed);
  for (float& value : image.pixels)
    value = low + (high - low) * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
  return image;
}

// A folder that goes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "vamp-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) ADD_FAILURE() << "no temporary folder";
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code code;
    fs::remove_all(path_, code);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

inline std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
  return {bytes.begin(), bytes.end()};
}

}  // namespace vamp::testing
