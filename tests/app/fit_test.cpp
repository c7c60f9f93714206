// vamp acquire, fit and evaluate: what they leave behind, and how they end.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "engine/material/preset.h"
#include "engine/material/reflectance.h"
#include "tests/app/program.h"

namespace vamp::test {
namespace {

using ::testing::HasSubstr;

class FitProgram : public Program {
 protected:
  void acquire(const std::string& file) {
    const Ended ended = run({"acquire", "--meso", "calf", "--size", "8", "--spp", "1", "-o", file});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  void expect(const std::vector<std::string>& arguments, int code, const std::string& message) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(message));
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  }
};

TEST_F(FitProgram, AMeasurementBecomesAPresetAndIsJudged) {
  acquire("calf.btf");
  EXPECT_FALSE(fs::exists(folder / "calf.btf.part"));
  const Ended fitted = run({"fit", "calf.btf", "-o", "calf.vamp", "--clusters", "2", "--representatives", "2", "--name",
                            "My calf", "--tags", "leather,brown", "--json"});
  ASSERT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_LE(fitted.json()["bases"].get<int>(), 32);

  const auto preset = load_preset(folder / "calf.vamp");
  ASSERT_TRUE(preset) << preset.error().message();
  EXPECT_EQ(preset->name, "My calf");
  EXPECT_THAT(preset->tags, ::testing::ElementsAre("synthetic", "leather", "brown"));
  EXPECT_THAT(preset->provenance, HasSubstr("Synthetic"));
  EXPECT_THAT(preset->provenance, HasSubstr("relative RMSE"));
  EXPECT_FLOAT_EQ(preset->fit->size_mm().x, 12);
  EXPECT_FALSE(preset->thumbnail_png.empty());

  const Ended judged = run({"evaluate", "calf.vamp", "calf.btf", "--ranks", "2", "--json"});
  ASSERT_EQ(judged.code, 0) << judged.err;
  const Json rows = judged.json()["representations"];
  EXPECT_EQ(rows[0]["name"], "functions");
  EXPECT_EQ(rows.back()["name"], "srf");
  for (const Json& row : rows) EXPECT_LT(row["relative_rmse"].get<double>(), 1.0) << row["name"];
}

TEST_F(FitProgram, APresetIsRecolouredIntoAnother) {
  acquire("calf.btf");
  ASSERT_EQ(run({"fit", "calf.btf", "-o", "calf.vamp", "--clusters", "2", "--representatives", "2"}).code, 0);
  const Ended ended = run({"recolour", "calf.vamp", "--from", "0.33,0.128,0.044", "--to", "0.045,0.08,0.26", "-o",
                           "navy.vamp", "--name", "Navy", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.json()["name"], "Navy");
  const Preset brown = load_preset(folder / "calf.vamp").value(), navy = load_preset(folder / "navy.vamp").value();
  EXPECT_THAT(navy.provenance, HasSubstr("Recoloured"));
  EXPECT_NE(navy.thumbnail_png, brown.thumbnail_png);
  const auto light = [](const Preset& preset) {
    dvec3 sum(0);
    for (const dvec3& weight : fit_sums(*preset.fit).weights) sum += weight;
    return sum;
  };
  EXPECT_GT(light(brown).x, light(brown).z);
  EXPECT_LT(light(navy).x, light(navy).z);
  // Most of a calf's light is its leather's, and what it came to is said.
  EXPECT_GT(ended.json()["share_of_light"].get<double>(), 0.5);
  EXPECT_LT(ended.json()["share_of_light"].get<double>(), 1.0);
  EXPECT_GT(ended.json()["share_of_texels"].get<double>(), 0.9);
  EXPECT_LT(ended.json()["untold"].get<double>(), 0.5);
  const Ended told = run({"recolour", "calf.vamp", "--from", "white", "--to", "black", "-o", "bare.vamp"});
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("of the light, in"));
  EXPECT_THAT(told.out, HasSubstr("bare.vamp: \"calf, black for white\""));
  EXPECT_EQ(load_preset(folder / "bare.vamp").value().name, "calf, black for white");
  expect({"recolour", "calf.vamp", "--from", "black", "--to", "white", "-o", "x.vamp"}, 2, "--from");
  expect({"recolour", "calf.vamp", "--from", "brown", "--to", "white", "-o", "x.vamp"}, 2, "white or black");
  expect({"recolour", "calf.vamp", "--from", "0,0,1", "--to", "white", "-o", "x.vamp"}, 2, "--from");
  expect({"recolour", "calf.vamp", "--from", "white", "--to", "black", "-o", "x.png"}, 2, "ends with .vamp");
  expect({"recolour", "calf.vamp", "--from", "white", "--to", "black", "-o", "nowhere/x.vamp"}, 4, "nowhere");
  expect({"recolour", "none.vamp", "--from", "white", "--to", "black", "-o", "x.vamp"}, 3, "none.vamp");
  EXPECT_FALSE(fs::exists(folder / "x.vamp") || fs::exists(folder / "x.png"));
}

TEST_F(FitProgram, TheLightKindSaysWhatStoringItCosts) {
  acquire("calf.btf");
  const Ended fitted = run({"fit", "calf.btf", "-o", "srf.vamp", "--kind", "srf", "--clusters", "1", "--json"});
  ASSERT_EQ(fitted.code, 0) << fitted.err;
  const Json errors = fitted.json()["relative_rmse"];
  EXPECT_LT(errors["exact"].get<double>(), 1.0);
  EXPECT_NEAR(errors["stored"].get<double>(), errors["exact"].get<double>(), 0.05);
  EXPECT_EQ(load_preset(folder / "srf.vamp").value().fit->dictionary.size(), 1u);
}

TEST_F(FitProgram, WrongWordsFilesAndPlacesAreOneLineEach) {
  expect({"acquire", "--meso", "calff", "-o", "x.btf"}, 2, "--meso");
  expect({"acquire", "--meso", "calf", "--set", "plates=1000", "-o", "x.btf"}, 2, "plates");
  expect({"acquire", "--meso", "calf", "-o", "x.png"}, 2, ".btf");
  expect({"acquire", "--meso", "calf", "--size", "4", "--spp", "1", "-o", "nowhere/x.btf"}, 4, "nowhere");
  expect({"fit", "none.btf", "-o", "x.vamp"}, 3, "none.btf");
  ASSERT_TRUE(write_text_atomically(folder / "damaged.btf", "!BDIF06R2!damaged").has_value());
  expect({"fit", "damaged.btf", "-o", "x.vamp"}, 3, "damaged.btf");
  expect({"fit", "none.btf", "-o", "nowhere/x.vamp"}, 4, "nowhere");
  expect({"fit", "none.btf", "-o", "x.vamp", "--clusters", "0"}, 2, "--clusters");
  expect({"fit", "none.btf", "-o", "x.png"}, 2, "ends with .vamp");
  expect({"fit", "none.btf", "-o", "x.vamp", "--name", std::string(257, 'x')}, 2, "--name");
  acquire("calf.btf");
  expect({"evaluate", "none.vamp", "calf.btf"}, 3, "none.vamp");
  expect({"evaluate", "presets/calf.vamp", "calf.btf"}, 3, "presets/calf.vamp");
  EXPECT_FALSE(fs::exists(folder / "x.vamp"));
}

TEST_F(FitProgram, AStoppedFitLeavesNothingAndAStoppedMeasurementGoesOn) {
  const std::vector<std::string> words = {"acquire", "--meso", "calf", "--size", "48", "--spp", "4", "-o", "a.btf"};
  const pid_t process = start(words);
  while (!fs::exists(folder / "a.btf.part")) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_EQ(::kill(process, SIGINT), 0);
  EXPECT_EQ(finish(process).code, 130);
  EXPECT_FALSE(fs::exists(folder / "a.btf"));
  ASSERT_EQ(run(words).code, 0);
  EXPECT_TRUE(fs::exists(folder / "a.btf"));

  const pid_t fit = start({"fit", "a.btf", "-o", "a.vamp"});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ASSERT_EQ(::kill(fit, SIGINT), 0);
  const Ended ended = finish(fit);
  EXPECT_EQ(ended.code, 130) << ended.err;
  for (const auto& entry : fs::directory_iterator(folder))
    EXPECT_THAT(entry.path().filename().string(), ::testing::Not(::testing::StartsWith("a.vamp")));
}

}  // namespace
}  // namespace vamp::test
