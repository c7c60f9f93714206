#include "engine/scene/light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace vamp {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

TEST(Light, PowerIsRadianceTimesPiTimesAreaForAreaLights) {
  Light light;
  light.power = 60;
  light.color = vec3(1, 0.5f, 0);
  light.size = vec2(2, 3);
  light.type = LightType::rect;
  EXPECT_FLOAT_EQ(light_radiance(light).x, 60 / (kPi * 6));
  EXPECT_FLOAT_EQ(light_radiance(light).y, 30 / (kPi * 6));
  light.radius = 0.5f;
  light.type = LightType::disk;
  EXPECT_FLOAT_EQ(light_radiance(light).x, 60 / (kPi * kPi * 0.25f));
  light.type = LightType::sphere;
  EXPECT_FLOAT_EQ(light_radiance(light).x, 60 / (kPi * 4 * kPi * 0.25f));
}

TEST(Light, PointsGivePowerOverFourPi) {
  Light light;
  light.type = LightType::point;
  light.power = 4 * kPi;
  EXPECT_FLOAT_EQ(light_intensity(light).x, 1);
  EXPECT_EQ(light_radiance(light), vec3(0));
  light.on = false;
  EXPECT_EQ(light_emission(light), vec3(0));
}

TEST(Light, LumensAreWattsTimes683) {
  EXPECT_FLOAT_EQ(power_from_candela(683), 4 * kPi);
  EXPECT_FLOAT_EQ(candela_from_power(power_from_candela(5)), 5);
  EXPECT_FLOAT_EQ(irradiance_from_lux(1366), 2);
  EXPECT_FLOAT_EQ(lux_from_irradiance(2), 1366);
}

TEST(Light, FramesAreRightHandedAndUIsHorizontal) {
  for (const vec3 target : {vec3(1, 0, 0), vec3(0, -1, 0), vec3(0, 1, 0), vec3(1, -2, 3), vec3(0)})
    for (const float roll : {0.0f, 30.0f, -100.0f}) {
      Light light;
      light.center = vec3(0);
      light.target = target;
      light.roll_degrees = roll;
      const LightFrame f = light_frame(light);
      EXPECT_NEAR(glm::length(glm::cross(f.u, f.v) - f.n), 0, 1e-5f);
      EXPECT_NEAR(glm::length(f.u), 1, 1e-5f);
      if (roll == 0) {
        EXPECT_NEAR(f.u.y, 0, 1e-6f);
      }
    }
}

TEST(Light, RollForAnAxisTurnsUOntoIt) {
  Light light;
  light.center = vec3(1, 2, 3);
  light.target = vec3(0, 0, 1);
  light.roll_degrees = 77;
  const vec3 u = light_frame(light).u;
  light.roll_degrees = 0;
  EXPECT_NEAR(roll_for_u_axis(light, u), 77, 1e-3f);
}

TEST(Light, SpotsFallFromOneAtTheInnerToZeroAtTheOuterCone) {
  Light light;
  light.type = LightType::spot;
  light.inner_degrees = 20;
  light.outer_degrees = 40;
  const SpotFalloff f = spot_falloff(light);
  EXPECT_NEAR(std::cos(20 * kPi / 180) * f.scale + f.offset, 1, 1e-5f);
  EXPECT_NEAR(std::cos(40 * kPi / 180) * f.scale + f.offset, 0, 1e-5f);
}

TEST(Light, NamesReadBack) {
  for (int i = 0; i < kLightTypeCount; ++i) {
    LightType type = LightType::point;
    EXPECT_TRUE(light_type_from_name(name_of(static_cast<LightType>(i)), type));
    EXPECT_EQ(static_cast<int>(type), i);
  }
  LightType type = LightType::disk;
  EXPECT_FALSE(light_type_from_name("laser", type));
  EXPECT_EQ(type, LightType::disk);
}

TEST(Light, ProblemsAreSaid) {
  Light light;
  EXPECT_EQ(light_problem(light), "");
  light.power = -1;
  EXPECT_NE(light_problem(light), "");
  light.power = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(light_problem(light), "");
  light = {};
  light.size.x = 0;
  EXPECT_NE(light_problem(light), "");
}

}  // namespace
}  // namespace vamp
