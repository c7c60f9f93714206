#include "engine/project/project_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <random>

#include "engine/core/files.h"
#include "engine/project/job.h"
#include "engine/project/known_files.h"
#include "engine/project/quantity_json.h"
#include "tests/project/small_project.h"

namespace vamp {
namespace {

using test::TemporaryHome;
using testing::HasSubstr;

// A folder with "shoe.glb", "materials/calf.vamp" and a project that uses both, with a little of everything changed.
class ProjectFile : public testing::Test {
 protected:
  ProjectFile() {
    fs::create_directories(folder_ / "materials");
    test::write_model(folder_ / "shoe.glb");
    const Preset preset = test::small_preset("calf");
    EXPECT_TRUE(save_preset(preset, folder_ / "materials" / "calf.vamp"));
    auto opened = open_scene(folder_ / "shoe.glb");
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().message());
    project_ = std::move(*opened);
    const Preset loaded = load_preset(folder_ / "materials" / "calf.vamp").value();
    assign_preset(project_, 0, loaded, (folder_ / "materials" / "calf.vamp").string());
    change_everything();
  }

  void change_everything() {
    MaterialInstance& calf = project_.materials.back();
    BasisEdit edit;
    edit.gain = {1.1f, 0.3f, 1 / 3.0f};
    edit.psi = 0.1234567f;
    edit.lobe = calf.fit->dictionary[1].lobe;
    edit.lobe->params[1] = 0.31415927f;
    calf.edits.set({1, 1}, edit);
    calf.edits.cluster_names[1] = "crease";
    project_.parts[0].mirror_f0 = 0.04f;
    project_.parts[0].texture_rotation = 0.7f;
    project_.parts[1].visible = false;
    project_.parts[2].place = {{0.01f, -1 / 3.0f, 0.0375f}, {0.1f, -2.3f, 1 / 7.0f}};
    project_.lights[0].roll_degrees = 12.3f;
    project_.lights.push_back({"lamp", LightType::sphere, false, {0.1f, 1 / 3.0f, -2}, {}, 0, {1, 1}, 0.037f, 7.7f});
    project_.ambient = {0.1f, 0.2f, 0.3f};
    project_.environment.rotation = 1.1f;
    project_.cameras.push_back({"toe", project_.camera});
    project_.camera.eye.x += 0.1f;
    project_.settings.seed = 4000000000u;
    project_.settings.ao_radius = 0.123f;
    project_.settings.tap = TexelTap::four;
    project_.settings.noise_goal = 0.03f;
    project_.display = {-1.5f, ToneMap::none};
  }

  // Equal but for the identity of the tables.
  static void expect_same(const Project& a, const Project& b) {
    Project other = b;
    other.scene = a.scene;
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (size_t i = 0; i < a.materials.size(); ++i) {
      EXPECT_EQ(a.materials[i].fit->texels.size(), b.materials[i].fit->texels.size());
      EXPECT_EQ(a.materials[i].edits, b.materials[i].edits);
      other.materials[i].fit = a.materials[i].fit;
    }
    EXPECT_EQ(a.lights, b.lights);
    EXPECT_EQ(a.parts, b.parts);
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_TRUE(a == other);
  }

  // Saves, changes the text, loads: what is said.
  std::string load_after(const std::function<void(Json&)>& spoil) {
    EXPECT_TRUE(save_project(project_, file_));
    Json json = parse_json(read_text(file_, 1 << 20).value(), "").value();
    spoil(json);
    EXPECT_TRUE(write_text_atomically(file_, print_json(json)));
    const auto loaded = load_project(file_);
    if (loaded) return "";
    EXPECT_EQ(loaded.error().kind, ErrorKind::bad_input);
    return loaded.error().message();
  }

  TemporaryHome home_;
  fs::path folder_ = home_.path() / "work";
  fs::path file_ = folder_ / "shoe.vampproj";
  Project project_;
};

TEST_F(ProjectFile, ReadsBackWhatWasWrittenBitForBit) {
  ASSERT_TRUE(save_project(project_, file_));
  const auto loaded = load_project(file_);
  ASSERT_TRUE(loaded) << loaded.error().message();
  expect_same(project_, *loaded);
}

TEST_F(ProjectFile, WritesTheSameBytesAfterLoading) {
  ASSERT_TRUE(save_project(project_, file_));
  const std::string first = read_text(file_, 1 << 20).value();
  ASSERT_TRUE(save_project(load_project(file_).value(), file_));
  EXPECT_EQ(read_text(file_, 1 << 20).value(), first);
}

TEST_F(ProjectFile, NamesFilesRelativeToItselfSoThatTheFolderCanMove) {
  ASSERT_TRUE(save_project(project_, file_));
  EXPECT_THAT(read_text(file_, 1 << 20).value(), testing::Not(HasSubstr(folder_.string())));
  fs::rename(folder_, home_.path() / "moved");
  const auto loaded = load_project(home_.path() / "moved" / "shoe.vampproj");
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->model, home_.path() / "moved" / "shoe.glb");
}

TEST_F(ProjectFile, SavesNothingWhenAFileLiesOutsideAndNamesIt) {
  fs::create_directories(home_.path() / "elsewhere");
  const fs::path file = home_.path() / "elsewhere" / "shoe.vampproj";
  const Status status = save_project(project_, file);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message(), HasSubstr("shoe.glb"));
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(outside_files(project_, file).size(), 2u);
}

TEST_F(ProjectFile, CollectsWhatLiesOutside) {
  fs::create_directories(home_.path() / "elsewhere");
  const fs::path file = home_.path() / "elsewhere" / "shoe.vampproj";
  const auto collected = collect_files(project_, file);
  ASSERT_TRUE(collected) << collected.error().message();
  EXPECT_TRUE(outside_files(*collected, file).empty());
  ASSERT_TRUE(save_project(*collected, file));
  fs::remove_all(folder_);
  const auto loaded = load_project(file);
  ASSERT_TRUE(loaded) << loaded.error().message();
  expect_same(*collected, *loaded);
}

TEST_F(ProjectFile, FindsPresetsOfTheUsersLibraryFromAnyFolder) {
  fs::create_directories(preset_library_dir());
  fs::rename(folder_ / "materials" / "calf.vamp", preset_library_dir() / "calf.vamp");
  project_.materials.back().preset = make_reference(preset_library_dir() / "calf.vamp");
  EXPECT_EQ(project_.materials.back().preset, "library:calf.vamp");
  ASSERT_TRUE(save_project(project_, file_));
  const auto loaded = load_project(file_);
  ASSERT_TRUE(loaded) << loaded.error().message();
  expect_same(project_, *loaded);
}

TEST_F(ProjectFile, SaysWhichPartNeedsAMissingPreset) {
  ASSERT_TRUE(save_project(project_, file_));
  fs::remove(folder_ / "materials" / "calf.vamp");
  const auto loaded = load_project(file_);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message(), HasSubstr("calf.vamp"));
  EXPECT_THAT(loaded.error().message(), HasSubstr("\"vamp\""));
}

TEST_F(ProjectFile, TakesAPresetThatHasChangedAndKeepsTheEditsOverIt) {
  ASSERT_TRUE(save_project(project_, file_));
  ASSERT_TRUE(save_preset(test::small_preset("calf", 0.75f), folder_ / "materials" / "calf.vamp"));
  const auto loaded = load_project(file_);
  ASSERT_TRUE(loaded) << loaded.error().message();
  const MaterialInstance &before = project_.materials.back(), &after = loaded->materials.back();
  EXPECT_EQ(after.edits, before.edits);
  EXPECT_EQ(after.fit->entries[0].basis_red, test::small_fit(0.75f)->entries[0].basis_red);
  EXPECT_NE(after.checksum, before.checksum);
  // What is saved again opens without a word.
  ASSERT_TRUE(save_project(*loaded, file_));
  EXPECT_EQ(load_project(file_).value().materials.back().checksum, after.checksum);
}

TEST_F(ProjectFile, LeavesOutTheEditsOfFunctionsThatAChangedPresetHasNoLonger) {
  ASSERT_TRUE(save_project(project_, file_));
  Preset fewer = test::small_preset("calf");
  auto fit = std::make_shared<Spmm>(*fewer.fit);
  for (auto& entry : fit->entries) entry.basis_red &= 0xffff0000u;
  fit->dictionary.resize(1);
  fewer.fit = fit;
  ASSERT_TRUE(save_preset(fewer, folder_ / "materials" / "calf.vamp"));
  const auto loaded = load_project(file_);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_TRUE(loaded->materials.back().edits.bases.empty());
  EXPECT_EQ(loaded->materials.back().edits.cluster_names.at(1), "crease");
}

TEST_F(ProjectFile, RefusesAPresetThatIsDamaged) {
  ASSERT_TRUE(save_project(project_, file_));
  const fs::path preset = folder_ / "materials" / "calf.vamp";
  std::string bytes = read_text(preset, 1 << 24).value();
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  ASSERT_TRUE(write_text_atomically(preset, bytes));
  const auto loaded = load_project(file_);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message(), HasSubstr("calf.vamp"));
}

TEST_F(ProjectFile, JobOfAPresetThatHasChangedIsRefused) {
  const std::string text = job_to_text({project_, 64, 64, 1}, folder_).value();
  ASSERT_TRUE(job_from_text(text, folder_, "picture.png"));
  ASSERT_TRUE(save_preset(test::small_preset("calf", 0.75f), folder_ / "materials" / "calf.vamp"));
  const auto job = job_from_text(text, folder_, "picture.png");
  ASSERT_FALSE(job);
  EXPECT_THAT(job.error().message(), HasSubstr("another fit"));
}

TEST_F(ProjectFile, TakesAModelThatHasLostAndGainedParts) {
  ASSERT_TRUE(save_project(project_, file_));
  Json json = parse_json(read_text(file_, 1 << 20).value(), "").value();
  json["parts"][1]["name"] = "heel";
  ASSERT_TRUE(write_text_atomically(file_, print_json(json)));
  const auto loaded = load_project(file_);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_TRUE(loaded->parts[1].visible);  // the part "sole" is new to the document
  EXPECT_EQ(loaded->parts[0].mirror_f0, 0.04f);
}

TEST_F(ProjectFile, RefusesHostileDocuments) {
  const std::vector<std::pair<const char*, std::function<void(Json&)>>> wrongs = {
      {"format", [](Json& j) { j["format"] = "something"; }},
      {"schema_version", [](Json& j) { j["schema_version"] = "2.0"; }},
      {"schema_version", [](Json& j) { j["schema_version"] = "one"; }},
      {"model.file", [](Json& j) { j["model"]["file"] = "../../etc/passwd"; }},
      {"model.file", [](Json& j) { j["model"]["file"] = "/etc/passwd"; }},
      {"model.file", [](Json& j) { j["model"]["file"] = "file:///etc/passwd"; }},
      {"model.file", [](Json& j) { j["model"]["file"] = ""; }},
      {"model.file", [](Json& j) { j["model"]["file"] = "shipped:../../etc/passwd"; }},
      {"model.file", [](Json& j) { j["model"]["file"] = "library:../../etc/passwd"; }},
      {"model.mm_per_unit", [](Json& j) { j["model"]["mm_per_unit"] = 0; }},
      {"missing.glb", [](Json& j) { j["model"]["file"] = "missing.glb"; }},
      {"materials[2].preset", [](Json& j) { j["materials"][2]["preset"] = "/etc/passwd"; }},
      {"materials", [](Json& j) { j.erase("materials"); }},
      {"parts[0].material", [](Json& j) { j["parts"][0]["material"] = 3; }},
      {"parts[0].material", [](Json& j) { j["parts"][0]["material"] = -1; }},
      {"parts[0].mirror_f0", [](Json& j) { j["parts"][0]["mirror_f0"] = 2; }},
      {"parts[1].offset",
       [](Json& j) {
         j["parts"][1]["offset"] = {0, 1e300, 0};
       }},
      {"parts[1].offset",
       [](Json& j) {
         j["parts"][1]["offset"] = {0, 0};
       }},
      {"parts[1].turn", [](Json& j) { j["parts"][1]["turn"] = "upside down"; }},
      {"lights[0].type", [](Json& j) { j["lights"][0]["type"] = "laser"; }},
      {"lights[0].center",
       [](Json& j) {
         j["lights"][0]["center"] = {1, 2};
       }},
      {"lights[0].power", [](Json& j) { j["lights"][0]["power"] = "20"; }},
      {"lights",
       [](Json& j) {
         j["lights"] = Json::array({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17});
       }},
      {"lights", [](Json& j) { j["lights"] = "many"; }},
      {"camera.fov", [](Json& j) { j["camera"]["fov"] = 0; }},
      {"render.seed", [](Json& j) { j["render"]["seed"] = -1; }},
      {"render.texel_tap", [](Json& j) { j["render"]["texel_tap"] = "nine"; }},
      {"environment.file",
       [](Json& j) {
         j["environment"]["file"] = "../sky.hdr";
         j["environment"]["checksum"] = "";
       }},
      {"cluster 7", [](Json& j) { j["materials"][2]["edits"]["bases"][0]["cluster"] = 7; }},
      {"gain",
       [](Json& j) {
         j["materials"][2]["edits"]["bases"][0]["gain"] = {1, -1, 1};
       }},
  };
  for (const auto& [said, spoil] : wrongs) {
    const std::string message = load_after(spoil);
    EXPECT_THAT(message, HasSubstr(said));
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST_F(ProjectFile, OfTheFirstSchemaHasItsPartsWhereTheModelHasThem) {
  ASSERT_TRUE(save_project(project_, file_));
  Json json = parse_json(read_text(file_, 1 << 20).value(), "").value();
  json["schema_version"] = "1.0";
  for (Json& part : json["parts"]) {
    part.erase("offset");
    part.erase("turn");
  }
  ASSERT_TRUE(write_text_atomically(file_, print_json(json)));
  const auto loaded = load_project(file_);
  ASSERT_TRUE(loaded) << loaded.error().message();
  for (const PartState& part : loaded->parts) EXPECT_EQ(part.place, Placement{});
}

TEST_F(ProjectFile, TellsPlacesInMillimetresAndDegrees) {
  project_.parts[2].place = {{0.01f, 0, -0.0375f}, {0, 0.523598776f, 0}};
  ASSERT_TRUE(save_project(project_, file_));
  const Json json = parse_json(read_text(file_, 1 << 20).value(), "").value();
  EXPECT_EQ(json["parts"][2]["offset"], Json::array({10, 0, -37.5}));
  EXPECT_EQ(json["parts"][2]["turn"], Json::array({0, 30, 0}));
}

TEST_F(ProjectFile, RefusesLinksThatLeaveTheFolder) {
  ASSERT_TRUE(save_project(project_, file_));
  fs::rename(folder_ / "shoe.glb", home_.path() / "shoe.glb");
  fs::create_symlink(home_.path() / "shoe.glb", folder_ / "shoe.glb");
  EXPECT_FALSE(load_project(file_));
}

TEST_F(ProjectFile, RefusesTextThatIsNoProject) {
  for (const std::string& text : {std::string(), std::string("{"), std::string("[]"), std::string("null"),
                                  std::string("{\"format\": \"vamp-project\"}"), std::string(100000, '[')}) {
    ASSERT_TRUE(write_text_atomically(file_, text));
    const auto loaded = load_project(file_);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().kind, ErrorKind::bad_input);
  }
}

TEST_F(ProjectFile, SurvivesEveryTruncation) {
  ASSERT_TRUE(save_project(project_, file_));
  const std::string whole = read_text(file_, 1 << 20).value();
  for (size_t length = 0; length + 2 < whole.size(); length += 97) {
    ASSERT_TRUE(write_text_atomically(file_, whole.substr(0, length)));
    EXPECT_FALSE(load_project(file_)) << length;
  }
}

TEST_F(ProjectFile, OpensModelsAndProjectsAndNothingElse) {
  EXPECT_TRUE(open_scene(folder_ / "shoe.glb"));
  for (const char* name : {"shoe.obj", "shoe", "missing.glb", "missing.vampproj"}) {
    const auto opened = open_scene(folder_ / name);
    ASSERT_FALSE(opened) << name;
    EXPECT_EQ(opened.error().kind, ErrorKind::bad_input);
    EXPECT_THAT(opened.error().message(), HasSubstr(name));
  }
}

TEST_F(ProjectFile, JobOfASnapshotMadeElsewhereFindsItsFilesAndTellsNoFolder) {
  const Job job{.project = project_,
                .width = 640,
                .height = 480,
                .samples = 64,
                .noise_goal = 0.02f,
                .device = "llvmpipe",
                .driver = "Mesa"};
  fs::create_directories(home_.path() / "pictures");
  const auto text = job_to_text(job, home_.path() / "pictures");
  ASSERT_TRUE(text) << text.error().message();
  EXPECT_THAT(*text, testing::Not(HasSubstr(home_.path().string())));
  const auto back = job_from_text(*text, home_.path() / "pictures", "picture.png");
  ASSERT_TRUE(back) << back.error().message();
  expect_same(project_, back->project);
  EXPECT_EQ(back->width, 640u);
  EXPECT_EQ(back->samples, 64u);
  EXPECT_EQ(back->noise_goal, 0.02f);
}

TEST_F(ProjectFile, JobOfAModelThatHasChangedIsRefused) {
  const std::string text = job_to_text({project_, 64, 64, 1}, folder_).value();
  fs::remove(folder_ / "shoe.glb");
  EXPECT_FALSE(job_from_text(text, folder_, "picture.png"));
  test::write_model(folder_ / "other.glb");
  ASSERT_TRUE(write_text_atomically(folder_ / "shoe.glb", read_text(folder_ / "other.glb", 1 << 20).value() + "    "));
  EXPECT_FALSE(job_from_text(text, folder_, "picture.png"));
}

TEST(KnownFiles, AreFoundByTheirContentUntilTheyAreGone) {
  const TemporaryHome home;
  const fs::path file = home.path() / "a.txt";
  ASSERT_TRUE(write_text_atomically(file, "content"));
  const std::string sum = file_checksum(file).value();
  EXPECT_FALSE(known_file(sum));
  remember_file(sum, file);
  EXPECT_EQ(known_file(sum), file);
  fs::remove(file);
  EXPECT_FALSE(known_file(sum));
  ASSERT_TRUE(write_text_atomically(state_dir() / "known_files.json", "{damaged"));
  EXPECT_FALSE(known_file(sum));
}

// Every float that the program can hold comes back from a file in mm or degrees.
TEST(Quantity, ReadsBackAsTheSameFloat) {
  std::mt19937 random(20120701);
  for (int i = 0; i < 20000; ++i) {
    const float value = i == 0 ? -0.0f : std::bit_cast<float>(static_cast<uint32_t>(random()));
    if (!(std::abs(value) < 1e30f && (value == 0 || std::abs(value) > 1e-30f))) continue;
    for (const double factor : {1.0, 1000.0, 25.4, kDegreesPerRadian, 1.0 / 3.0}) {
      const Json json = parse_json(print_json(json_quantity(value, factor)), "").value();
      const JsonReader reader(json, "");
      const float back = quantity_from(reader, factor, -1e30f, 1e30f);
      ASSERT_TRUE(reader.status());
      ASSERT_EQ(std::bit_cast<uint32_t>(back), std::bit_cast<uint32_t>(value)) << value << " times " << factor;
    }
  }
}

TEST(Quantity, IsWrittenInFewDigits) {
  EXPECT_EQ(print_json(json_quantity(0.1f, 1000)), "100\n");
  EXPECT_EQ(print_json(json_quantity(0.0375f, 1000)), "37.5\n");
  EXPECT_EQ(print_json(json_quantity(0.523598776f, kDegreesPerRadian)), "30\n");
}

}  // namespace
}  // namespace vamp
