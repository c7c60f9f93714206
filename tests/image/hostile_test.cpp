// Damaged and hostile files, and machines that cannot write: one clear error, never a crash, a hang or a grey picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>
#include <random>

#include "engine/image/load.h"
#include "engine/image/metadata.h"
#include "engine/image/save.h"
#include "tests/image/encoders.h"
#include "tests/image/pictures.h"

namespace vamp {
namespace {

using testing::bytes_of;
using ::testing::HasSubstr;
using testing::noise_image;

std::vector<std::byte> valid(const std::string& format) {
  const Image image = noise_image(24, 24, {"R", "G", "B"}, 5);
  if (format == "png") return *encode_png(image);
  if (format == "exr") return *encode_exr(image);
  return testing::oiio_encoded(format, OIIO::ImageSpec(24, 24, 3, OIIO::TypeDesc::FLOAT), image.pixels);
}

class Hostile : public ::testing::TestWithParam<const char*> {};

TEST_P(Hostile, TheSoundFileIsReadWhateverItsName) {
  const auto image = decode_image(valid(GetParam()), "wrong.name");
  ASSERT_TRUE(image) << image.error().message();
}

TEST_P(Hostile, EveryTruncationIsAnError) {
  const auto whole = valid(GetParam());
  const size_t step = std::max<size_t>(1, whole.size() / 300);
  for (size_t size = 0; size < whole.size(); size += step) {
    const auto image = decode_image(std::span(whole).first(size), "cut");
    ASSERT_FALSE(image) << size << " of " << whole.size();
    EXPECT_EQ(image.error().kind, ErrorKind::bad_input);
    EXPECT_EQ(image.error().message().find('\n'), std::string::npos);
    EXPECT_THAT(image.error().message(), HasSubstr("cut"));
  }
}

TEST_P(Hostile, DamagedBytesNeverCrash) {
  const auto whole = valid(GetParam());
  std::mt19937 random(11);
  for (int i = 0; i < 400; ++i) {
    auto damaged = whole;
    const size_t reach = i % 2 == 0 ? damaged.size() : std::min<size_t>(damaged.size(), 400);  // headers more often
    for (int k = 0; k < 1 + i % 8; ++k) damaged[random() % reach] = static_cast<std::byte>(random());
    const auto image = decode_image(damaged, "damaged");
    if (!image) {
      EXPECT_EQ(image.error().kind, ErrorKind::bad_input);
    } else {
      EXPECT_FALSE(first_not_finite(*image));
    }
    (void)read_metadata(damaged, "damaged");
  }
}

TEST_P(Hostile, OneFlippedBitOfAPngIsNoticed) {
  if (std::string(GetParam()) != "png") return;
  const auto whole = valid("png");
  for (size_t at = 0; at < whole.size(); at += 3) {
    auto damaged = whole;
    damaged[at] ^= std::byte{4};
    EXPECT_FALSE(decode_image(damaged, "damaged")) << at;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Hostile, ::testing::Values("png", "jpeg", "exr", "hdr"));

TEST(Signature, OtherFormatsAreRefused) {
  const std::string tga = std::string("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\30\0\1\2\3", 21);
  for (const std::string& content :
       {std::string(), std::string("8BPS\0\1", 6), std::string("GIF89a...."), std::string("II*\0........", 12), tga,
        std::string("<svg/>"), std::string(100, '\0')}) {
    const auto image = decode_image(bytes_of(content), "picture.png");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::bad_input);
    EXPECT_THAT(image.error().message(), HasSubstr("PNG, JPEG, OpenEXR or Radiance HDR"));
  }
}

TEST(Limits, HugeSizesInHeadersAreRefusedBeforeMemoryIsSpent) {
  const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\nabcd";
  const auto huge_hdr = decode_image(bytes_of(hdr), "huge.hdr");
  ASSERT_FALSE(huge_hdr);
  EXPECT_EQ(huge_hdr.error().kind, ErrorKind::bad_input);

  auto exr = valid("exr");
  const std::string_view text(reinterpret_cast<const char*>(exr.data()), exr.size());
  const size_t window = text.find(std::string_view("dataWindow\0box2i\0", 17)) + 17 + 4;
  for (size_t i = 8; i < 16; ++i) exr[window + i] = static_cast<std::byte>(i % 4 == 3 ? 0x3f : 0xff);
  const auto huge_exr = decode_image(exr, "huge.exr");
  ASSERT_FALSE(huge_exr);
  EXPECT_EQ(huge_exr.error().kind, ErrorKind::bad_input);

  ImageLimits small;
  small.side = 23;
  for (const char* format : {"png", "jpeg", "exr", "hdr"}) {
    const auto image = decode_image(valid(format), "x", ColourSpace::srgb, small);
    ASSERT_FALSE(image) << format;
    EXPECT_EQ(image.error().message(), "x: size: expected from 1 x 1 to 23 x 23 pixels, found 24 x 24");
  }
  small = {};
  small.bytes = 24 * 24 * 3 * 4 - 1;
  EXPECT_FALSE(decode_image(valid("exr"), "x", ColourSpace::srgb, small));
  small.bytes += 1;
  EXPECT_TRUE(decode_image(valid("exr"), "x", ColourSpace::srgb, small));
}

// A decoder that goes by a value's own length would read the rest of the file as other attributes than were checked.
TEST(Exr, AttributesOfAnotherLengthThanTheirValueAreRefused) {
  for (const std::string_view attribute :
       {std::string_view("channels\0chlist", 15), {"dataWindow\0box2i", 16}, {"pixelAspectRatio\0float", 22}}) {
    auto exr = valid("exr");
    const std::string_view text(reinterpret_cast<const char*>(exr.data()), exr.size());
    const size_t length = text.find(attribute) + attribute.size() + 1;
    ASSERT_LT(length, exr.size());
    ASSERT_TRUE(decode_image(exr, "x.exr"));
    exr[length] = static_cast<std::byte>(std::to_integer<int>(exr[length]) + 1);
    exr.insert(exr.begin() + static_cast<std::ptrdiff_t>(length) + 4, std::byte{0});
    const auto image = decode_image(exr, "x.exr");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::bad_input);
    EXPECT_THAT(image.error().message(), HasSubstr(std::string(attribute.substr(0, attribute.find('\0')))));
  }
}

TEST(NotFinite, InfinityAndNanInAnExrAreRefusedWithTheirPlace) {
  for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    Image image = noise_image(8, 8, {"R", "G", "B"}, 1);
    image.at(6, 3, 2) = bad;
    const auto bytes = testing::oiio_encoded("openexr", OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::FLOAT), image.pixels);
    const auto loaded = decode_image(bytes, "sky.exr");
    ASSERT_FALSE(loaded);
    EXPECT_THAT(loaded.error().message(), HasSubstr("sky.exr: pixel (6, 3), channel B: expected finite numbers"));
    EXPECT_FALSE(encode_exr(image));
  }
}

TEST(Load, MissingFilesAndFoldersAreBadInput) {
  EXPECT_EQ(load_image("/nonexistent/a.png").error().kind, ErrorKind::bad_input);
  EXPECT_EQ(load_image("/").error().kind, ErrorKind::bad_input);
}

TEST(Save, AnOldFileStaysWholeWhenTheDiskIsFull) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.png";
  ASSERT_TRUE(save_png(path, Image(4, 4, {"Y"})));
  const auto before = read_file(path, 1 << 20);
  // A file size limit fails writes as a full disk does.
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit tiny{512, old.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &tiny);
  const Status png = save_png(path, noise_image(64, 64, {"R", "G", "B"}, 1));
  const Status exr = save_exr(path, noise_image(64, 64, {"R", "G", "B"}, 1));
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(png);
  EXPECT_EQ(png.error().kind, ErrorKind::io);
  EXPECT_EQ(png.error().file, path.string());
  EXPECT_EQ(exr.error().kind, ErrorKind::io);
  EXPECT_EQ(*read_file(path, 1 << 20), *before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(Save, FoldersThatAreMissingOrNoFoldersAreIoErrors) {
  const Image image(4, 4, {"Y"});
  const Status missing = save_png("/nonexistent/folder/a.png", image);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::io);
  EXPECT_EQ(save_png("/proc/a.png", image).error().kind, ErrorKind::io);
  const testing::TemporaryFolder folder;
  EXPECT_EQ(save_png(folder.path(), image).error().kind, ErrorKind::io);
}

TEST(Save, ADeviceThatIsFullIsAnIoErrorAndStaysADevice) {
  const Status status = save_png("/dev/full", Image(4, 4, {"Y"}));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::io);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

}  // namespace
}  // namespace vamp
