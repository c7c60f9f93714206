// Questions and answers on their way to the device and back. What the answers are worth is tested in tests/brdf.
#include "shaders/shared/probe.h"

#include <cstddef>
#include <numbers>

#include "shaders/spirv.h"
#include "tests/brdf/device.h"
#include "tests/gpu/spirv_reflection.h"

namespace vamp {
namespace {

class Probe : public test::OnTheDevice {};

TEST_F(Probe, ManyQuestionsAreAnsweredInTheirOrder) {
  std::vector<BrdfQuestion> many(200001);
  for (size_t i = 0; i < many.size(); ++i) {
    many[i].lobe = {Model::lambert, 0, {static_cast<float>(i)}};
  }
  const std::vector<BrdfValue> values = probe->values(many);
  ASSERT_EQ(values.size(), many.size());
  for (size_t i = 0; i < many.size(); ++i) ASSERT_NEAR(values[i].fcos * std::numbers::pi, i, 1e-6 * i);
  EXPECT_TRUE(probe->values({}).empty());
}

TEST(ProbeRows, LieTheSameWayOnBothSides) {
  const auto question = test::reflect_struct(spirv::brdf_probe_comp(), "Question");
  ASSERT_TRUE(question) << question.error().message();
  EXPECT_EQ(question->stride, sizeof(probe::Question));
  EXPECT_EQ(question->offsets.at("wo"), offsetof(probe::Question, wo));
  EXPECT_EQ(question->offsets.at("p0"), offsetof(probe::Question, p0));
  EXPECT_EQ(question->offsets.at("u0"), offsetof(probe::Question, u0));
  EXPECT_EQ(question->offsets.at("tag"), offsetof(probe::Question, tag));
  const auto answer = test::reflect_struct(spirv::brdf_probe_comp(), "Answer");
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_EQ(answer->stride, sizeof(probe::Answer));
  EXPECT_EQ(answer->offsets.at("valid"), offsetof(probe::Answer, valid));
}

}  // namespace
}  // namespace vamp
