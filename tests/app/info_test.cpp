#include <gmock/gmock.h>

#include "engine/image/save.h"
#include "engine/project/project_file.h"
#include "tests/app/program.h"
#include "tests/material/small_spmm.h"

namespace vamp::test {
namespace {

class Info : public Program {
 protected:
  Json info(const std::string& name) {
    const Ended ended = run({"info", name, "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    const Ended text = run({"info", name});
    EXPECT_EQ(text.code, 0);
    EXPECT_THAT(text.out, ::testing::HasSubstr("kind: "));
    return ended.json();
  }
  Preset small_preset() const {
    Preset preset;
    preset.name = "Small";
    preset.tags = {"test"};
    preset.fit = std::make_shared<Spmm>(small_spmm());
    return preset;
  }
};

TEST_F(Info, OfAModel) {
  const Json json = info(box_on_floor());
  EXPECT_EQ(json["kind"], "model");
  EXPECT_EQ(json["triangles"], 14);
  ASSERT_EQ(json["parts"].size(), 2u);
  EXPECT_EQ(json["parts"][0]["name"], "Box");
  EXPECT_EQ(json["parts"][0]["triangles"], 12);
  // A face of 100 mm takes the whole of the texture.
  EXPECT_NEAR(json["parts"][0]["mm_per_uv"].get<double>(), 100, 1e-3);
  EXPECT_NEAR(json["parts"][0]["area_mm2"].get<double>(), 60000, 1);
  EXPECT_EQ(json["lights"].size(), 0u);
}

TEST_F(Info, OfAPreset) {
  const Preset preset = small_preset();
  const Spmm& fit = *preset.fit;
  for (const char* name : {"small.vamp", "small"}) {
    ASSERT_TRUE(save_preset(preset, folder / name));
    const Json json = info(name);
    EXPECT_EQ(json["kind"], "preset");
    EXPECT_EQ(json["name"], "Small");
    EXPECT_EQ(json["texels"], Json({fit.width, fit.height}));
    ASSERT_EQ(json["clusters"].size(), fit.clusters.size());
    size_t texels = 0;
    for (const Json& cluster : json["clusters"]) texels += cluster["texels"].get<size_t>();
    EXPECT_EQ(texels, fit.texels.size());
    ASSERT_EQ(json["bases"].size(), fit.dictionary.size());
    EXPECT_EQ(json["bases"][0]["name"], fit.dictionary[0].name);
    EXPECT_EQ(json["residual"]["terms"], fit.residual.terms);
    EXPECT_EQ(json["residual"]["directions"], fit.residual.directions.size());
    EXPECT_GT(json["bytes_on_gpu"].get<size_t>(), 16 * fit.texels.size());
  }
}

TEST_F(Info, OfAProject) {
  box_on_floor();
  ASSERT_TRUE(save_preset(small_preset(), folder / "small.vamp"));
  auto project = open_scene(folder / "box.glb");
  ASSERT_TRUE(project);
  assign_preset(*project, 0, small_preset(), (folder / "small.vamp").string());
  ASSERT_TRUE(save_project(*project, folder / "box.vampproj"));
  const Json json = info("box.vampproj");
  EXPECT_EQ(json["kind"], "project");
  EXPECT_EQ(json["model"], "box.glb");
  EXPECT_EQ(json["parts"][0]["material"], "Small");
  EXPECT_TRUE(json["parts"][1]["preset"].is_null());
  EXPECT_EQ(json["lights"].size(), project->lights.size());
}

TEST_F(Info, OfAPicture) {
  ASSERT_TRUE(save_png(folder / "a.png", Image(4, 3, {"R", "G", "B"}), {.bits = 16}));
  const Json json = info("a.png");
  EXPECT_EQ(json["kind"], "picture");
  EXPECT_EQ(json["format"], "PNG");
  EXPECT_EQ(json["width"], 4);
  EXPECT_EQ(json["height"], 3);
  EXPECT_EQ(json["bits"], 16);
  EXPECT_TRUE(json["job"].is_null());
}

}  // namespace
}  // namespace vamp::test
