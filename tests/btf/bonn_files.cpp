#include "tests/btf/bonn_files.h"

#include <gtest/gtest.h>

#include "engine/btf/cursor.h"
#include "engine/core/files.h"
#include "engine/core/half.h"

namespace vamp::test {
namespace {

void description(ByteWriter& file, uint32_t version, std::string_view xml) {
  const size_t size = 4 + 4 + 240 + 4 + 12 + 4 + (version > 2 ? 4 + xml.size() : 0);
  file.number(static_cast<uint32_t>(size));
  file.number(version);
  for (const char* text : {"dome", "camera", "LED"}) file.text(text, 80);
  file.number(10.0f);
  for (int i = 0; i < 3; ++i) file.number(1.0f);
  file.number(uint32_t{0});  // no cosine
  if (version <= 2) return;
  file.number(static_cast<uint32_t>(xml.size()));
  file.text(xml);
}

void sampling(ByteWriter& file) {
  file.number(uint32_t{2});
  for (int view = 0; view < 2; ++view) {
    file.number(0.9f * static_cast<float>(view));
    file.number(0.0f);
    file.number(uint32_t{3});
    for (int light = 0; light < 3; ++light) {
      file.number(0.5f * static_cast<float>(light));
      file.number(1.0f);
    }
  }
  file.number(uint32_t{2});  // width
  file.number(uint32_t{2});  // height
}

void identity(ByteWriter& file) {
  file.number(uint32_t{1});
  for (const float element : {1, 0, 0, 0, 1, 0, 0, 0, 1}) file.number(element);
}

}  // namespace

void write_foreign_bdi(const std::filesystem::path& path) {
  ByteWriter file;
  file.text("!BDIF06R2!");
  description(file, 2, "");
  sampling(file);
  file.number(uint32_t{1});  // rows per chunk
  file.number(uint8_t{2});   // sparse, uncompressed
  for (const uint8_t stored : {1, 0, 1, 1}) file.number(stored);
  identity(file);
  // Chunks hold stored texels, two each but the last.
  const int stored[] = {0, 2, 3};
  for (int i = 0; i < 3; ++i) {
    if (i % 2 == 0) file.number(static_cast<uint32_t>((i == 0 ? 2 : 1) * 18 * 2));
    for (int view = 0; view < 2; ++view)
      for (int light = 0; light < 3; ++light)
        for (int channel = 0; channel < 3; ++channel)
          file.number(half_from_float(static_cast<float>(stored[i]) + static_cast<float>(view) / 2 +
                                      static_cast<float>(light) / 4 + static_cast<float>(channel) / 8));
  }
  EXPECT_TRUE(write_file_atomically(path, file.bytes()));
}

void write_foreign_dfmf(const std::filesystem::path& path) {
  ByteWriter file;
  file.text("!DFMF08FCR");
  description(file, 3, "<measurement/>");
  sampling(file);
  identity(file);
  file.number(uint32_t{1});  // components
  file.number(int32_t{0});   // RGB
  for (int i = 0; i < 12; ++i) file.number(0.0f);
  for (int channel = 0; channel < 3; ++channel) {
    file.number(uint8_t{8});
    for (const uint32_t size : {1u, 6u, 4u}) file.number(size);
    file.number(1.0);
    for (int direction = 0; direction < 6; ++direction) file.number(1 + (direction % 3) / 8.0);
    for (int texel = 0; texel < 4; ++texel) file.number(texel + 1.0);
  }
  EXPECT_TRUE(write_file_atomically(path, file.bytes()));
}

}  // namespace vamp::test
