#include <gmock/gmock.h>

#include "engine/image/save.h"
#include "tests/app/program.h"

namespace vamp::test {
namespace {

class Compare : public Program {
 protected:
  // 16 x 12 pixels of one grey.
  Image grey(float value) const {
    Image image(16, 12, {"R", "G", "B"});
    for (float& each : image.pixels) each = value;
    return image;
  }
};

TEST_F(Compare, EqualPicturesAreEqual) {
  ASSERT_TRUE(save_exr(folder / "a.exr", grey(0.5f)));
  ASSERT_TRUE(save_exr(folder / "b.exr", grey(0.5f)));
  const Ended ended = run({"compare", "a.exr", "b.exr", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.json()["equal"], true);
  EXPECT_EQ(ended.json()["rmse"], 0);
  EXPECT_NEAR(ended.json()["mssim"].get<double>(), 1, 1e-12);
  EXPECT_THAT(run({"compare", "a.exr", "b.exr"}).out, ::testing::HasSubstr("equal"));
}

TEST_F(Compare, TheErrorIsAgainstTheSecondPicture) {
  ASSERT_TRUE(save_exr(folder / "a.exr", grey(0.75f)));
  ASSERT_TRUE(save_exr(folder / "b.exr", grey(0.5f)));
  const Json json = run({"compare", "a.exr", "b.exr", "--json", "--exposure", "-1"}).json();
  EXPECT_EQ(json["equal"], false);
  EXPECT_NEAR(json["rmse"].get<double>(), 0.25, 1e-7);
  EXPECT_NEAR(json["relmse"].get<double>(), 0.0625 / 0.26, 1e-7);
  EXPECT_EQ(json["exposure"], -1);
}

TEST_F(Compare, PicturesOfDifferentSizeOrKindAreRefused) {
  ASSERT_TRUE(save_exr(folder / "a.exr", grey(0.5f)));
  ASSERT_TRUE(save_exr(folder / "b.exr", Image(8, 8, {"R", "G", "B"})));
  ASSERT_TRUE(save_png(folder / "a.png", grey(0.5f)));
  EXPECT_EQ(run({"compare", "a.exr", "b.exr"}).code, 3);
  EXPECT_EQ(run({"compare", "a.exr", "a.png"}).code, 3);
  EXPECT_EQ(run({"compare", "a.exr", "a.exr", "--exposure", "bright"}).code, 2);
}

}  // namespace
}  // namespace vamp::test
