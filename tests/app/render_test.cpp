// vamp render: pictures, figures, layers, and the same picture again.
#include <gmock/gmock.h>

#include "engine/image/load.h"
#include "engine/image/metadata.h"
#include "engine/material/preset.h"
#include "tests/app/program.h"
#include "tests/material/small_spmm.h"

namespace vamp::test {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class Render : public Program {
 protected:
  Image picture(const std::string& name) const {
    auto image = load_image(folder / name);
    EXPECT_TRUE(image) << (image ? "" : image.error().message());
    return image.value_or(Image(1, 1, {"R", "G", "B"}));
  }
};

TEST_F(Render, WritesAPngAndItsFigures) {
  const Ended ended = render({"-o", "a.png", "--json", "--seed", "7"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, ::testing::Not(HasSubstr("error")));
  const Json json = ended.json();
  EXPECT_EQ(json["samples"], 2);
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["width"], 24);
  EXPECT_EQ(json["height"], 16);
  EXPECT_EQ(json["triangles"], 14);
  EXPECT_EQ(json["complete"], true);
  for (const char* figure : {"seconds", "ms_per_sample", "rays", "mrays_per_s", "gpu_bytes"})
    EXPECT_GT(json[figure].get<double>(), 0) << figure;
  for (const char* text : {"device", "driver", "file"}) EXPECT_FALSE(json[text].get<std::string>().empty()) << text;
  const Image image = picture("a.png");
  EXPECT_EQ(image.width, 24);
  EXPECT_EQ(image.height, 16);
}

TEST_F(Render, AnExrHoldsTheLayersThatWereAskedFor) {
  const std::vector<std::string> view = {"--camera", "eye=0,1.95,0,target=0,0,0,fov=40,up=0,0,-1", "--pixel-centres"};
  std::vector<std::string> arguments = {"-o", "a.exr", "--size", "5x5", "--aov", "depth,normal,uv,part,cluster,ao"};
  arguments.insert(arguments.end(), view.begin(), view.end());
  const Ended ended = render(arguments);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Image image = picture("a.exr");
  EXPECT_THAT(image.channels, UnorderedElementsAre("R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z",
                                                   "uv.U", "uv.V", "part.Y", "cluster.Y", "ao.Y"));
  // The middle pixel looks straight down at the box's top, 1.9 units away.
  EXPECT_NEAR(image.at(2, 2, *image.channel("depth.Z")), 1.9, 1e-5);
  EXPECT_NEAR(image.at(2, 2, *image.channel("normal.Y")), 1, 1e-6);
  EXPECT_EQ(image.at(2, 2, *image.channel("part.Y")), 0);
  EXPECT_EQ(image.at(0, 0, *image.channel("part.Y")), 1);
}

TEST_F(Render, PartsStandWhereTheyAreAskedToAndDoSoAgain) {
  const std::vector<std::string> how = {"-o",
                                        "a.exr",
                                        "--camera",
                                        "eye=0,1.95,0,target=0,0,0,fov=40,up=0,0,-1",
                                        "--size",
                                        "5x5",
                                        "--aov",
                                        "depth,part",
                                        "--move",
                                        "Box=0,0.25,0",
                                        "--turn",
                                        "Box=0,45,0",
                                        "--pixel-centres"};
  const Ended ended = render(how);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Image image = picture("a.exr");
  EXPECT_NEAR(image.at(2, 2, *image.channel("depth.Z")), 1.65, 1e-5);
  EXPECT_EQ(image.at(2, 2, *image.channel("part.Y")), 0);
  ASSERT_EQ(render({"--from", "a.exr", "-o", "b.exr", "--aov", "depth,part"}).code, 0);
  EXPECT_EQ(picture("b.exr").pixels, image.pixels);
}

TEST_F(Render, OptionsStandOverTheScenesOwnLight) {
  ASSERT_EQ(render({"-o", "dark.exr", "--ambient", "0,0,0"}).code, 0);
  const Image dark = picture("dark.exr");
  for (const char* channel : {"R", "G", "B"})
    for (int x = 0; x < dark.width; ++x) EXPECT_EQ(dark.at(x, dark.height / 2, *dark.channel(channel)), 0);

  const char* lamp = "sphere,center=0,1,0,radius=0.1,power=10,color=1,0,0";
  ASSERT_EQ(render({"-o", "red.exr", "--light", lamp, "--samples", "4"}).code, 0);
  const Image red = picture("red.exr");
  float sum[3] = {};
  for (int c = 0; c < 3; ++c)
    for (int x = 0; x < red.width; ++x) sum[c] += red.at(x, red.height / 2, *red.channel(std::string(1, "RGB"[c])));
  EXPECT_GT(sum[0], 0);
  EXPECT_EQ(sum[1], 0);
  EXPECT_EQ(sum[2], 0);
}

TEST_F(Render, OneSeedGivesOnePicture) {
  ASSERT_EQ(render({"-o", "a.exr", "--seed", "1"}).code, 0);
  ASSERT_EQ(render({"-o", "b.exr", "--seed", "1"}).code, 0);
  ASSERT_EQ(render({"-o", "c.exr", "--seed", "2"}).code, 0);
  EXPECT_EQ(bytes_of("a.exr"), bytes_of("b.exr"));
  EXPECT_NE(picture("a.exr").pixels, picture("c.exr").pixels);
}

TEST_F(Render, ASnapshotIsRenderedAgainFromItself) {
  Preset preset;
  preset.name = "Small";
  preset.fit = std::make_shared<Spmm>(small_spmm());
  ASSERT_TRUE(save_preset(preset, folder / "small.vamp"));
  const std::vector<std::string> how = {
      "--material", "Box=small.vamp", "--mirror", "Floor=0.2",   "--seed", "5", "--exposure",
      "1",          "--samples",      "3",        "--ao-radius", "0.5"};
  for (const std::string extension : {".png", ".exr"}) {
    std::vector<std::string> arguments = {"-o", "first" + extension};
    arguments.insert(arguments.end(), how.begin(), how.end());
    const Ended first = render(arguments);
    ASSERT_EQ(first.code, 0) << first.err;
    const Ended again = render({"--from", "first" + extension, "-o", "again" + extension, "--json"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(again.json()["samples"], 3);
    EXPECT_EQ(bytes_of("first" + extension), bytes_of("again" + extension));
  }
  // Other options stand over the job.
  ASSERT_EQ(render({"--from", "first.png", "-o", "large.png", "--size", "30x20"}).code, 0);
  EXPECT_EQ(picture("large.png").width, 30);
}

TEST_F(Render, APresetIsFoundByItsFilesNameAndByTheOneThatItIsShownBy) {
  ASSERT_EQ(render({"-o", "file.exr", "--material", "Box=calf"}).code, 0);
  for (const std::string name : {"CALF", "Full-grain calf, cognac", "full-grain CALF, cognac"}) {
    const Ended ended = render({"-o", "name.exr", "--material", "Box=" + name});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(picture("name.exr").pixels, picture("file.exr").pixels) << name;
  }
}

TEST_F(Render, ASnapshotTellsNoFolderOfThisMachine) {
  ASSERT_EQ(render({"-o", "a.png"}).code, 0);
  const auto metadata = read_metadata(folder / "a.png");
  ASSERT_TRUE(metadata);
  EXPECT_THAT(metadata->at("vamp:job"), ::testing::Not(HasSubstr(folder.string())));
}

TEST_F(Render, AJobWhoseModelHasChangedIsRefused) {
  ASSERT_EQ(render({"-o", "a.png"}).code, 0);
  std::string model = bytes_of("box.glb");
  model.back() = static_cast<char>(model.back() ^ 1);
  ASSERT_TRUE(write_text_atomically(folder / "box.glb", model));
  const Ended ended = render({"--from", "a.png", "-o", "b.png"});
  EXPECT_EQ(ended.code, 3) << ended.err;
  EXPECT_FALSE(fs::exists(folder / "b.png"));
}

TEST_F(Render, TimeAloneEndsTheWork) {
  const Ended ended = render({"-o", "a.png", "--time", "0.05", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_GE(ended.json()["samples"].get<int>(), 1);
  EXPECT_EQ(ended.json()["complete"], true);
}

TEST_F(Render, WhatEndedByItsNoiseIsRenderedAgainFromItself) {
  const Ended first = render({"-o", "a.png", "--size", "130x70", "--noise", "5", "--samples", "512", "--json"});
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_LE(first.json()["noise"].get<double>(), 0.05);
  EXPECT_EQ(first.json()["complete"], true);
  const Ended again = render({"--from", "a.png", "-o", "b.png", "--json"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(first.json()["mean_samples"], again.json()["mean_samples"]);
  EXPECT_EQ(picture("a.png").pixels, picture("b.png").pixels);
}

// Wider than a region: two of them share the time, and must end with the same number of samples.
TEST_F(Render, WhatEndedByItsTimeIsRenderedAgainFromItself) {
  const Ended first = render({"-o", "a.png", "--size", "1030x40", "--time", "0.4", "--json"});
  ASSERT_EQ(first.code, 0) << first.err;
  const Ended again = render({"--from", "a.png", "-o", "b.png", "--json"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(first.json()["samples"], again.json()["samples"]);
  EXPECT_EQ(picture("a.png").pixels, picture("b.png").pixels);
}

TEST_F(Render, AFullDiskEndsInOneLineAndFour) {
  fs::create_symlink("/dev/full", folder / "full.png");
  const Ended ended = render({"-o", "full.png", "--log-level", "warn"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("full.png"));
  EXPECT_EQ(ended.out, "");
}

TEST_F(Render, PngOfSixteenBitsWithAlpha) {
  ASSERT_EQ(render({"-o", "a.png", "--bits", "16", "--transparent"}).code, 0);
  const auto bytes = read_file(folder / "a.png", 1 << 20);
  ASSERT_TRUE(bytes);
  const auto info = image_info(*bytes, "a.png");
  ASSERT_TRUE(info);
  EXPECT_EQ(info->bits, 16);
  EXPECT_EQ(info->channels.size(), 4u);
}

}  // namespace
}  // namespace vamp::test
