#include "engine/project/job_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vamp {
namespace {

using testing::HasSubstr;

TEST(ParseLight, ReadsARectangleWhoseVectorsAreSeparatedByTheSameCommasAsItsKeys) {
  const auto light = parse_light(
      "rect,center=0,1,0.5,target=0,0,0,size=0.5x0.25,power=20,color=1,0.5,0.25,roll=30,name=key", "--light");
  ASSERT_TRUE(light) << light.error().message();
  EXPECT_EQ(light->type, LightType::rect);
  EXPECT_EQ(light->center, vec3(0, 1, 0.5f));
  EXPECT_EQ(light->target, vec3(0));
  EXPECT_EQ(light->size, vec2(0.5f, 0.25f));
  EXPECT_EQ(light->power, 20);
  EXPECT_EQ(light->color, vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(light->roll_degrees, 30);
  EXPECT_EQ(light->name, "key");
}

TEST(ParseLight, ReadsEveryType) {
  for (const char* text :
       {"disk,center=0,1,0,target=0,0,0,radius=0.2,power=5", "sphere,center=0,1,0,radius=0.1,power=5",
        "point,center=0,1,0,power=5", "spot,center=0,1,0,target=0,0,0,power=5,inner=10,outer=20",
        "directional,center=0,1,0,target=0,0,0,power=1", "rect, center=0, 1, 0, target=0,0,0, size=1x1, power=1e2"}) {
    const auto light = parse_light(text, "--light");
    EXPECT_TRUE(light) << text << ": " << light.error().message();
  }
}

TEST(ParseLight, ReadsHexColoursAsSrgb) {
  const auto light = parse_light("point,center=0,1,0,power=5,color=#ff8000", "--light");
  ASSERT_TRUE(light);
  EXPECT_EQ(light->color.x, 1);
  EXPECT_NEAR(light->color.y, 0.2158605f, 1e-6f);  // IEC 61966-2-1 of 128 / 255
  EXPECT_EQ(light->color.z, 0);
}

struct Wrong {
  const char* text;
  const char* said;
};

TEST(ParseLight, RefusesWhatIsWrongAndSaysWhatWasExpected) {
  for (const Wrong& wrong : {
           Wrong{"", "starts with rect"},
           Wrong{"lamp,center=0,1,0,power=5", "\"lamp\""},
           Wrong{"center=0,1,0,power=5", "starts with rect"},
           Wrong{"rect,target=0,0,0,size=1x1,power=5", "no center"},
           Wrong{"rect,center=0,1,0,size=1x1,power=5", "no target"},
           Wrong{"rect,center=0,1,0,target=0,0,0,power=5", "no size"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1x1", "no power"},
           Wrong{"rect,center=0,1,0,target=0,1,0,size=1x1,power=5", "same point"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=0x1,power=5", "above 0"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1,power=5", "AxB"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1x1x1,power=5", "AxB"},
           Wrong{"rect,center=0,1,target=0,0,0,size=1x1,power=5", "three numbers"},
           Wrong{"rect,center=0,1,0,0,target=0,0,0,size=1x1,power=5", "three numbers"},
           Wrong{"rect,center=0,nan,0,target=0,0,0,size=1x1,power=5", "three numbers"},
           Wrong{"rect,center=0,1e9,0,target=0,0,0,size=1x1,power=5", "1e7"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1x1,power=-5", "watts"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1x1,power=inf", "watts"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1x1,power=5W", "watts"},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1x1,power=5,radius=1", "\"radius\""},
           Wrong{"rect,center=0,1,0,target=0,0,0,size=1x1,power=5,power=6", "twice"},
           Wrong{"rect,0,1,0,center=0,1,0", "key=value"},
           Wrong{"disk,center=0,1,0,target=0,0,0,radius=0,power=5", "a length"},
           Wrong{"sphere,center=0,1,0,target=0,0,0,radius=1,power=5", "\"target\""},
           Wrong{"point,center=0,1,0,power=5,color=1,1", "color"},
           Wrong{"point,center=0,1,0,power=5,color=#12345", "#rrggbb"},
           Wrong{"point,center=0,1,0,power=5,color=#12345g", "#rrggbb"},
           Wrong{"point,center=0,1,0,power=5,color=1,-1,1", "0 or more"},
           Wrong{"point,center=0,1,0,power=5,name=", "a name"},
           Wrong{"spot,center=0,1,0,target=0,0,0,power=5,inner=40,outer=30", "above inner"},
       }) {
    const auto light = parse_light(wrong.text, "--light");
    ASSERT_FALSE(light) << wrong.text;
    EXPECT_EQ(light.error().kind, ErrorKind::usage);
    EXPECT_THAT(light.error().message(), HasSubstr("--light"));
    EXPECT_THAT(light.error().message(), HasSubstr(wrong.said)) << wrong.text;
    EXPECT_EQ(light.error().message().find('\n'), std::string::npos);
  }
}

TEST(ParseLight, KeepsItsErrorToOneLineWhateverWasPasted) {
  const auto light = parse_light(std::string(100000, 'x'), "--light");
  ASSERT_FALSE(light);
  EXPECT_LT(light.error().message().size(), 300u);
}

TEST(ParseCamera, ReadsEyeTargetFovAndUp) {
  const auto camera = parse_camera("eye=0.3,0.2,0.5,target=0,0,0.1,fov=35,up=0,0,1", "--camera");
  ASSERT_TRUE(camera) << camera.error().message();
  EXPECT_EQ(camera->eye, vec3(0.3f, 0.2f, 0.5f));
  EXPECT_EQ(camera->target, vec3(0, 0, 0.1f));
  EXPECT_EQ(camera->fov_degrees, 35);
  EXPECT_EQ(camera->up, vec3(0, 0, 1));
}

TEST(ParseCamera, RefusesWhatIsWrong) {
  for (const Wrong& wrong : {Wrong{"", "key=value"}, Wrong{"eye=0,0,1,target=0,0,0", "no fov"},
                             Wrong{"eye=0,0,1,target=0,0,1,fov=35", "same point"},
                             Wrong{"eye=0,0,1,target=0,0,0,fov=0", "degrees from 1 to 170"},
                             Wrong{"eye=0,0,1,target=0,0,0,fov=180", "degrees"},
                             Wrong{"eye=0,0,1,target=0,0,0,fov=35,up=0,0,0", "a direction"},
                             Wrong{"eye=0,0,1,target=0,0,0,fov=35,roll=3", "\"roll\""}}) {
    const auto camera = parse_camera(wrong.text, "--camera");
    ASSERT_FALSE(camera) << wrong.text;
    EXPECT_EQ(camera.error().kind, ErrorKind::usage);
    EXPECT_THAT(camera.error().message(), HasSubstr(wrong.said)) << wrong.text;
  }
}

TEST(ParseSize, ReadsPixelsAndRefusesTheRest) {
  EXPECT_EQ(parse_size("640x480", "--size").value(), uvec2(640, 480));
  for (const char* text : {"", "640", "640x", "x480", "0x480", "640x480x2", "-1x2", "640.5x480", "20000x10", "axb"})
    EXPECT_FALSE(parse_size(text, "--size")) << text;
}

}  // namespace
}  // namespace vamp
