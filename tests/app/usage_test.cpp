// Wrong usage, missing and damaged files: one clear line and the right exit code.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/app/program.h"

namespace vamp::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class Usage : public Program {
 protected:
  void expect(const std::vector<std::string>& arguments, int code, const std::string& message) {
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    SCOPED_TRACE("vamp " + line);
    // Notes about the scene are not what is looked at here.
    std::vector<std::string> quiet = {"--log-level", "warn"};
    quiet.insert(quiet.end(), arguments.begin(), arguments.end());
    const Ended ended = run(quiet);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_THAT(ended.err, StartsWith("vamp: "));
    EXPECT_THAT(ended.err, HasSubstr(message));
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_EQ(ended.out, "");
  }
  // vamp render -o x.png with one more option.
  void expect_refused(const std::string& option, const std::string& value, const std::string& message = "") {
    expect({"render", "-o", "x.png", option, value}, 2, message.empty() ? option : message);
  }
};

TEST_F(Usage, HelpAndVersionAreNoErrors) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                    {"help"},
                                                    {"render", "--help"},
                                                    {"help", "render"},
                                                    {"compare", "--help"},
                                                    {"info", "--help"},
                                                    {"edit", "--help"}}) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.err, "");
    EXPECT_THAT(ended.out, HasSubstr("Usage: vamp"));
  }
  const Ended version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.out, StartsWith("vamp 0."));
  EXPECT_THAT(version.out, HasSubstr("Vulkan headers 1."));
}

TEST_F(Usage, EveryVerbIsInTheHelp) {
  const std::string text = run({"help"}).out;
  for (const char* verb : {"edit", "render", "compare", "info"}) EXPECT_THAT(text, HasSubstr(verb));
}

TEST_F(Usage, UnknownWordsAreRefused) {
  expect({"rendr"}, 2, "rendr");
  expect({"help", "rendr"}, 2, "rendr");
  expect({"--bogus"}, 2, "--bogus");
  expect({"render", "-o", "x.png", "--bogus"}, 2, "--bogus");
  expect({"render", "a.glb", "b.glb", "-o", "x.png"}, 2, "b.glb");
  expect({"compare", "a.png"}, 2, "required");
  expect({"info"}, 2, "required");
  expect({"render"}, 2, "--output");
  expect({"render", "-o", "x.png", "--device"}, 2, "--device");
}

TEST_F(Usage, NumbersAreReadWholeAndInRange) {
  for (const char* bad : {"abc", "-1", "0", "1.5", "0x10", "99999999999"}) expect_refused("--samples", bad);
  for (const char* bad : {"0", "-2", "nan", "1s"}) expect_refused("--time", bad);
  for (const char* bad : {"-1", "4294967296", "x"}) expect_refused("--seed", bad);
  for (const char* bad : {"640", "640x", "0x0", "-1x5", "100000x100000"}) expect_refused("--size", bad);
  for (const char* bad : {"17", "nan", "a"}) expect_refused("--exposure", bad);
  expect_refused("--ao-radius", "-1");
  expect_refused("--environment-intensity", "-1");
  expect_refused("--bits", "12");
}

TEST_F(Usage, PlacesOfPartsAreReadWholeAndInRange) {
  for (const char* option : {"--move", "--turn"})
    for (const char* bad : {"Sole", "Sole=", "=1,2,3", "Sole=1,2", "Sole=1,2,3,4", "Sole=1,2,x", "Sole=1,,3",
                            "Sole=nan,0,0", "Sole=0,0,1e9"})
      expect_refused(option, bad);
  expect_refused("--move", "Heel cap=1,2,3", "one of the parts");
}

TEST_F(Usage, OptionsThatExcludeEachOther) {
  expect({"render", "-o", "x.png", "--samples", "5", "--time", "3"}, 2, "--time");
  expect({"render", "a.glb", "-o", "x.png", "--from", "b.png"}, 2, "--from");
  expect({"render", "-o", "x.png", "--aov", "depth"}, 2, "x.png");
}

TEST_F(Usage, WhatIsWrongWithALightOrACameraIsNamed) {
  expect_refused("--light", "lamp", "--light");
  expect_refused("--light", "rect,center=0,1,0,target=0,0,0,size=1x1", "power");
  expect_refused("--light", "rect,center=0,1,0,target=0,0,0,size=1x1,power=nan", "power");
  expect_refused("--light", "sphere,center=0,1,0,radius=-1,power=1", "radius");
  expect_refused("--light", "disk,center=0,1,0,target=0,0,0,size=1x1,power=1", "size");
  expect_refused("--camera", "eye=0,0,1,target=0,0,0,fov=180", "fov");
  expect_refused("--camera", "eye=0,0,target=0,0,0,fov=30", "eye");
  expect_refused("--ambient", "1,1", "--ambient");
  expect_refused("--ambient", "-1,0,0", "--ambient");
  expect_refused("--aov", "depth,,ao", "--aov");
  expect_refused("--aov", "deep", "deep");
  expect_refused("--tap", "nine", "--tap");
  expect_refused("--material", "Vamp", "PART=VALUE");
  expect_refused("--mirror", "Vamp=2", "--mirror");
}

TEST_F(Usage, PartsAreNamedWhenOneIsNotThere) {
  box_on_floor();
  expect({"render", "box.glb", "-o", "x.png", "--material", "Toe=calf"}, 2, "Box, Floor");
}

TEST_F(Usage, MissingAndDamagedFilesAreBadInput) {
  box_on_floor();
  expect({"render", "none.glb", "-o", "x.png"}, 3, "none.glb");
  expect({"render", "none.vampproj", "-o", "x.png"}, 3, "none.vampproj");
  expect({"render", "box.glb", "-o", "x.png", "--material", "Box=none.vamp"}, 3, "none.vamp");
  expect({"render", "box.glb", "-o", "x.png", "--material", "Box=none"}, 2, "calf (\"Full-grain calf, cognac\")");
  expect({"render", "box.glb", "-o", "x.png", "--environment", "none.hdr"}, 3, "none.hdr");
  expect({"render", "-o", "x.png", "--from", "none.png"}, 3, "none.png");
  expect({"compare", "a.png", "b.png"}, 3, "a.png");
  expect({"info", "none.glb"}, 3, "none.glb");
  expect({"edit", "none.glb"}, 3, "none.glb");
  expect({"none.glb"}, 3, "none.glb");
  expect({"info", "box.txt"}, 3, "box.txt");
  const std::string whole = bytes_of("box.glb");
  ASSERT_TRUE(write_text_atomically(folder / "cut.glb", whole.substr(0, whole.size() / 2)));
  expect({"render", "cut.glb", "-o", "x.png"}, 3, "cut.glb");
  ASSERT_TRUE(write_text_atomically(folder / "no.png", "no picture"));
  expect({"info", "no.png"}, 3, "no.png");
  expect({"render", "-o", "x.png", "--from", "no.png"}, 3, "no.png");
}

TEST_F(Usage, APlaceThatCannotBeWrittenToIsSaidBeforeRendering) {
  fs::create_directory(folder / "taken.png");
  expect({"render", "-o", "none/x.png"}, 4, "none");
  expect({"render", "-o", "taken.png"}, 4, "a folder");
  expect({"render", "-o", "x.bmp"}, 2, ".bmp");
  expect({"render", "-o", "x"}, 2, ".png or .exr");
}

TEST_F(Usage, WithoutADeviceRenderingEndsWithFive) {
  const Ended ended = run({"render", box_on_floor(), "-o", "x.png", "--log-level", "warn"},
                          {{"VK_ICD_FILENAMES", "/none.json"}, {"VK_DRIVER_FILES", "/none.json"}});
  EXPECT_EQ(ended.code, 5) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_FALSE(fs::exists(folder / "x.png"));
  expect({"render", "box.glb", "-o", "x.png", "--device", "no such card"}, 5, "no such card");
}

TEST_F(Usage, DevicesAreListed) {
  const Ended ended = run({"--list-devices"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, StartsWith("0: "));
}

TEST_F(Usage, DevicesAreListedInsteadOfWhatAVerbDoes) {
  for (const bool before : {true, false}) {
    std::vector<std::string> arguments = {"render", box_on_floor(), "-o", "x.png"};
    arguments.insert(before ? arguments.begin() : arguments.end(), "--list-devices");
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.out, StartsWith("0: "));
    EXPECT_FALSE(fs::exists(folder / "x.png"));
  }
}

TEST_F(Usage, AFullDiskUnderStandardOutputIsAnError) {
  box_on_floor();
  output = "/dev/full";
  const Ended ended = run({"info", "box.glb", "--log-level", "warn"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("standard output"));
}

}  // namespace
}  // namespace vamp::test
