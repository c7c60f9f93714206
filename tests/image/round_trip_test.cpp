#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/half.h"
#include "engine/image/load.h"
#include "engine/image/metadata.h"
#include "engine/image/save.h"
#include "tests/image/encoders.h"
#include "tests/image/pictures.h"

namespace vamp {
namespace {

using testing::noise_image;

// A job of about 100 KB as JSON, with what makes writers stumble: quotes, line ends, another script.
Metadata snapshot_metadata() {
  std::string job = "{\"note\": \"caf\u00e9 \u9774\", \"list\": [";
  for (int i = 0; i < 12000; ++i) job += std::to_string(i) + ", \n";
  job += "0]}";
  return {{"vamp:job", job},
          {"Software", "Vamp"},
          {"Title", "Größe \"42\"\tend"},
          {"Creation Time", "2024-05-06T07:08:09Z"}};
}

class PngBits : public ::testing::TestWithParam<int> {};

TEST_P(PngBits, EveryCodeSurvives) {
  const int bits = GetParam();
  const int count = 1 << bits;
  for (const ColourSpace space : {ColourSpace::srgb, ColourSpace::linear}) {
    Image image(256, count / 256, {"Y"});
    image.pixels = decoding_table(static_cast<size_t>(count), space);
    const auto bytes = encode_png(image, {bits, space, 0, {}});
    ASSERT_TRUE(bytes) << bytes.error().message();
    const auto again = decode_image(*bytes, "x.png", space);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->pixels, image.pixels);
  }
}

TEST_P(PngBits, ChannelsAndAlphaSurvive) {
  const auto top = static_cast<float>((1 << GetParam()) - 1);
  for (const auto& channels :
       std::vector<std::vector<std::string>>{{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}) {
    Image image = noise_image(7, 5, channels, 3);
    for (float& v : image.pixels) v = std::round(v * top) / top;
    image.pixels.back() = 0;  // alpha 0 must not wipe out the colour beside it
    const auto bytes = encode_png(image, {GetParam(), ColourSpace::linear, 0, {}});
    ASSERT_TRUE(bytes);
    const auto again = decode_image(*bytes, "x.png", ColourSpace::linear);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->channels, channels);
    for (size_t i = 0; i < image.pixels.size(); ++i) EXPECT_NEAR(again->pixels[i], image.pixels[i], 1e-7f);
  }
}

TEST_P(PngBits, MetadataSurvive) {
  const Metadata metadata = snapshot_metadata();
  ASSERT_GT(metadata.at("vamp:job").size(), 80000u);
  const auto bytes = encode_png(noise_image(4, 4, {"R", "G", "B"}, 1), {GetParam(), ColourSpace::srgb, 300, metadata});
  ASSERT_TRUE(bytes);
  const auto again = read_metadata(*bytes, "x.png");
  ASSERT_TRUE(again) << again.error().message();
  for (const auto& [key, value] : metadata) EXPECT_EQ(again->at(key), value);
  // 300 dpi are 11811 pixels a metre.
  const auto phys = std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size()).find("pHYs");
  ASSERT_NE(phys, std::string_view::npos);
  EXPECT_EQ(std::to_integer<int>((*bytes)[phys + 6]) << 8 | std::to_integer<int>((*bytes)[phys + 7]), 11811);
  EXPECT_TRUE(decode_image(*bytes, "x.png"));
}

INSTANTIATE_TEST_SUITE_P(Bits, PngBits, ::testing::Values(8, 16));

TEST(Png, OutOfRangeIsCutOffAndNanRefused) {
  Image image(3, 1, {"Y"});
  image.pixels = {-1, 2, 0.5f};
  const auto again = decode_image(*encode_png(image), "x.png");
  EXPECT_EQ(again->pixels[0], 0.0f);
  EXPECT_EQ(again->pixels[1], 1.0f);
  image.pixels[2] = std::numeric_limits<float>::quiet_NaN();
  const auto refused = encode_png(image);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "pixel (2, 0), channel Y");
}

TEST(Png, CodesAreWrittenAsTheyAre) {
  const std::vector<uint8_t> codes = {0, 1, 2, 253, 254, 255};
  const auto image = decode_image(*encode_png_codes(2, 1, 3, codes), "x.png", ColourSpace::linear);
  ASSERT_TRUE(image);
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(std::lround(image->pixels[i] * 255.0f), codes[i]);
}

TEST(Exr, FloatsSurviveBitForBitInNamedLayers) {
  Image image = noise_image(33, 17, {"R", "G", "B", "A"}, 1, -2.0f, 1000.0f);
  add_layer(image, noise_image(33, 17, {"Z"}, 2, 0, 1e6f), "depth");
  add_layer(image, noise_image(33, 17, {"R", "G", "B"}, 3), "light.key");
  add_layer(image, noise_image(33, 17, {"X", "Y", "Z"}, 4, -1, 1), "normal");
  const auto bytes = encode_exr(image);
  ASSERT_TRUE(bytes) << bytes.error().message();
  const auto again = decode_image(*bytes, "x.exr");
  ASSERT_TRUE(again) << again.error().message();
  ASSERT_EQ(again->channels.size(), image.channels.size());
  EXPECT_EQ(select_channels(*again, image.channels).pixels, image.pixels);
}

TEST(Exr, HalfRoundsColoursAndKeepsData) {
  Image image = noise_image(9, 4, {"R", "G", "B"}, 1, 0, 10);
  image.pixels[0] = 1e6f;
  add_layer(image, noise_image(9, 4, {"Z"}, 2, 0, 1e6f), "depth");
  const auto again = decode_image(*encode_exr(image, {true, {}}), "x.exr");
  ASSERT_TRUE(again) << again.error().message();
  const Image ordered = select_channels(*again, image.channels);
  EXPECT_EQ(ordered.pixels[0], kHalfMax);
  for (size_t i = 1; i < image.pixels.size(); ++i)
    EXPECT_EQ(ordered.pixels[i], i % 4 == 3 ? image.pixels[i] : float_from_half(half_from_float(image.pixels[i])));
}

TEST(Exr, MetadataSurvive) {
  Metadata metadata = snapshot_metadata();
  metadata["owner"] = "the designer";
  metadata["comments"] = "first try";
  metadata["capDate"] = "2024:05:06 07:08:09";
  const auto bytes = encode_exr(noise_image(4, 4, {"R", "G", "B"}, 1), {false, metadata});
  ASSERT_TRUE(bytes) << bytes.error().message();
  const auto again = read_metadata(*bytes, "x.exr");
  ASSERT_TRUE(again) << again.error().message();
  for (const auto& [key, value] : metadata) {
    ASSERT_TRUE(again->contains(key)) << key;
    EXPECT_EQ(again->at(key), value) << key;
  }
}

TEST(Exr, ThePictureAloneDecidesTheBytes) {
  const Image image = noise_image(4, 4, {"R", "G", "B"}, 1);
  const auto texts = read_metadata(*encode_exr(image), "x.exr");
  ASSERT_TRUE(texts);
  for (const auto& [key, value] : *texts)
    EXPECT_TRUE(value.empty() || key == "oiio:ColorSpace") << key << ": " << value;
}

TEST(Exr, ForeignChromaticitiesAreConverted) {
  // White of BT.2020 is the white of Rec.709; its red is not.
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
  const float rec2020[] = {0.708f, 0.292f, 0.17f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.329f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), rec2020);
  const auto image = decode_image(testing::oiio_encoded("openexr", spec, {1, 1, 1, 1, 0, 0}), "x.exr");
  ASSERT_TRUE(image) << image.error().message();
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(image->pixels[c], 1.0f, 1e-4f);
  EXPECT_NEAR(image->pixels[3], 1.6605f, 1e-3f);
  EXPECT_NEAR(image->pixels[4], -0.1246f, 1e-3f);
}

TEST(Exr, TiledFilesAreRead) {
  OIIO::ImageSpec spec(40, 20, 3, OIIO::TypeDesc::HALF);
  spec.tile_width = spec.tile_height = 16;
  const Image image = noise_image(40, 20, {"R", "G", "B"}, 1);
  const auto again = decode_image(testing::oiio_encoded("openexr", spec, image.pixels), "x.exr");
  ASSERT_TRUE(again) << again.error().message();
  for (size_t i = 0; i < image.pixels.size(); ++i) EXPECT_NEAR(again->pixels[i], image.pixels[i], 1e-3f);
}

TEST(Hdr, RadianceSurvivesToItsPrecision) {
  const Image image = noise_image(40, 20, {"R", "G", "B"}, 1, 0.5f, 100.0f);
  const auto bytes = testing::oiio_encoded("hdr", OIIO::ImageSpec(40, 20, 3, OIIO::TypeDesc::FLOAT), image.pixels);
  const auto again = decode_image(bytes, "x.hdr");
  ASSERT_TRUE(again) << again.error().message();
  // Eight bits of the largest of the three.
  for (size_t i = 0; i < image.pixels.size(); ++i) EXPECT_NEAR(again->pixels[i], image.pixels[i], 0.5f);
  EXPECT_EQ(read_metadata(bytes, "x.hdr")->size(), 0u);
}

TEST(Jpeg, ColoursAreDecodedFromSrgb) {
  const std::vector<float> grey(16 * 16 * 3, 128.0f / 255.0f);
  const auto bytes = testing::oiio_encoded("jpeg", OIIO::ImageSpec(16, 16, 3, OIIO::TypeDesc::UINT8), grey);
  const auto image = decode_image(bytes, "x.jpg");
  ASSERT_TRUE(image) << image.error().message();
  EXPECT_EQ(image->channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_NEAR(image->at(5, 5, 1), 0.2158605f, 0.004f);
  EXPECT_NEAR(decode_image(bytes, "x.jpg", ColourSpace::linear)->at(5, 5, 1), 128.0f / 255.0f, 0.01f);
}

TEST(ImageInfo, SaysWhatIsInTheFile) {
  const auto info = image_info(*encode_png(Image(5, 3, {"R", "G", "B"}), {16, ColourSpace::srgb, 0, {}}), "x.png");
  ASSERT_TRUE(info);
  EXPECT_EQ(info->format, ImageFormat::png);
  EXPECT_EQ(info->width, 5);
  EXPECT_EQ(info->height, 3);
  EXPECT_EQ(info->bits, 16);
}

}  // namespace
}  // namespace vamp
