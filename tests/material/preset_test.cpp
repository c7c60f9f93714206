#include "engine/material/preset.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/brdf/registry.h"
#include "engine/core/files.h"
#include "engine/core/json.h"
#include "tests/material/small_spmm.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_fit(const Spmm& a, const Spmm& b) {
  return a.width == b.width && a.height == b.height && a.mm_per_texel == b.mm_per_texel &&
         a.dictionary == b.dictionary && a.clusters == b.clusters && same_bytes(a.texels, b.texels) &&
         same_bytes(a.entries, b.entries) && a.residual.terms == b.residual.terms &&
         a.residual.directions == b.residual.directions && same_bytes(a.residual.records, b.residual.records);
}

Preset small_preset() {
  Preset preset;
  preset.name = "Käsebrot \"test\"";
  preset.tags = {"leather", "brown"};
  preset.provenance = "made by a test";
  preset.licence = "CC0-1.0";
  preset.fit = std::make_shared<Spmm>(test::small_spmm());
  BasisEdit edit;
  edit.gain = {0.1f, 1.7f, 1};
  edit.lobe = default_lobe(Model::oren_nayar);
  edit.lobe->params[1] = 0.123456f;
  edit.normal = test::tilted(33, 123);
  edit.psi = -0.7654321f;
  edit.lock = true;
  preset.edits.set({0, 1}, edit);
  BasisEdit mute;
  mute.mute = true;
  preset.edits.set({2, 4}, mute);
  preset.edits.cluster_names[1] = "deep crease";
  preset.edits.residual_terms = 2;
  preset.edits.residual_strength = 0.75f;
  preset.edits.residual_policy = ResidualPolicy::fade;
  preset.thumbnail_png = {std::byte{1}, std::byte{2}, std::byte{3}};
  return preset;
}

std::vector<std::byte> bytes_of(const fs::path& path) { return read_file(path, 1 << 26).value(); }

class PresetForms : public testing::TestWithParam<const char*> {};

TEST_P(PresetForms, ComesBackAsItWas) {
  const test::TemporaryFolder folder;
  const Preset preset = small_preset();
  const fs::path path = folder / GetParam();
  ASSERT_TRUE(save_preset(preset, path));
  const auto loaded = load_preset(path);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->name, preset.name);
  EXPECT_EQ(loaded->tags, preset.tags);
  EXPECT_EQ(loaded->provenance, preset.provenance);
  EXPECT_EQ(loaded->licence, preset.licence);
  EXPECT_EQ(loaded->edits, preset.edits);
  EXPECT_EQ(loaded->thumbnail_png, preset.thumbnail_png);
  EXPECT_TRUE(same_fit(*loaded->fit, *preset.fit));
  const auto info = load_preset_info(path);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->name, preset.name);
  EXPECT_EQ(info->size_mm, preset.fit->size_mm());
  EXPECT_EQ(info->thumbnail_png, preset.thumbnail_png);
}

TEST_P(PresetForms, SavingWhatWasLoadedGivesTheSameBytes) {
  const test::TemporaryFolder folder;
  const fs::path first = folder / (std::string("a_") + GetParam()), second = folder / (std::string("b_") + GetParam());
  ASSERT_TRUE(save_preset(small_preset(), first));
  ASSERT_TRUE(save_preset(load_preset(first).value(), second));
  if (fs::is_directory(first))
    for (const char* name : {"material.json", "tables.bin", "thumbnail.png"})
      EXPECT_EQ(bytes_of(first / name), bytes_of(second / name)) << name;
  else
    EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST_P(PresetForms, ReplacesAnOldOneAndLeavesNothingBehind) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / GetParam();
  Preset preset = small_preset();
  ASSERT_TRUE(save_preset(preset, path));
  preset.name = "second";
  preset.thumbnail_png.clear();
  ASSERT_TRUE(save_preset(preset, path));
  const auto loaded = load_preset(path);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->name, "second");
  EXPECT_TRUE(loaded->thumbnail_png.empty());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST_P(PresetForms, AMaterialWithoutResidualOrThumbnailServes) {
  const test::TemporaryFolder folder;
  Preset preset = small_preset();
  auto fit = test::small_spmm();
  fit.residual = {};
  preset.fit = std::make_shared<Spmm>(fit);
  preset.thumbnail_png.clear();
  ASSERT_TRUE(save_preset(preset, folder / GetParam()));
  const auto loaded = load_preset(folder / GetParam());
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_TRUE(same_fit(*loaded->fit, fit));
}

TEST_P(PresetForms, AFullDiskLeavesTheOldOneWhole) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / GetParam();
  ASSERT_TRUE(save_preset(small_preset(), path));
  // A limit on file sizes stands in for a full disk: writing ends in an error part of the way.
  const auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  rlimit small = old_limit;
  small.rlim_cur = 20000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  Preset changed = small_preset();
  changed.name = "never written";
  const Status status = save_preset(changed, path);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  ::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::io);
  EXPECT_EQ(status.error().file, path.string());
  const auto loaded = load_preset(path);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->name, small_preset().name);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST_P(PresetForms, UnknownMembersAreKept) {
  const test::TemporaryFolder folder;
  Preset preset = small_preset();
  preset.unknown_json = R"({"extras": {"colour_card": [1, 2.5]}, "name": "not this one"})";
  ASSERT_TRUE(save_preset(preset, folder / GetParam()));
  const auto loaded = load_preset(folder / GetParam());
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->name, preset.name);
  const auto unknown = parse_json(loaded->unknown_json, "f");
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->at("extras").at("colour_card").at(1), 2.5);
  EXPECT_EQ(unknown->size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Both, PresetForms, testing::Values("calf", "calf.vamp"),
                         [](const auto& form) { return std::string(form.index == 0 ? "Folder" : "Zip"); });

TEST(Preset, AFolderWithOtherFilesIsNeverReplaced) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_text_atomically(folder / "thesis.txt", "years of work"));
  const Status status = save_preset(small_preset(), folder.path());
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message().find("thesis.txt"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "thesis.txt"));
}

TEST(Preset, WhatIsNotValidIsNotSaved) {
  const test::TemporaryFolder folder;
  Preset preset = small_preset();
  BasisEdit edit;
  edit.gain = {std::nanf(""), 1, 1};
  preset.edits.set({0, 0}, edit);
  EXPECT_FALSE(save_preset(preset, folder / "a.vamp"));
  preset = small_preset();
  preset.edits.set({99, 0}, {.mute = true});
  EXPECT_FALSE(save_preset(preset, folder / "a.vamp"));
  preset = small_preset();
  auto fit = test::small_spmm();
  fit.entries[0].green_blue = 0x7c00;
  preset.fit = std::make_shared<Spmm>(fit);
  EXPECT_FALSE(save_preset(preset, folder / "a.vamp"));
  // What could be written and never be read again.
  preset = small_preset();
  preset.name = std::string(kMaxPresetName + 1, 'a');
  EXPECT_FALSE(save_preset(preset, folder / "a.vamp"));
  preset = small_preset();
  preset.provenance = std::string(5000, 'a');
  EXPECT_FALSE(save_preset(preset, folder / "a.vamp"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Preset, FilesSayDegrees) {
  const test::TemporaryFolder folder;
  Preset preset = small_preset();
  auto fit = test::small_spmm();
  fit.dictionary[2].psi = 0.785398163f;
  preset.fit = std::make_shared<Spmm>(fit);
  ASSERT_TRUE(save_preset(preset, folder / "p"));
  const auto json = parse_json(read_text(folder / "p/material.json", 1 << 20).value(), "f").value();
  EXPECT_EQ(json.at("basis").at(2).at("psi"), 45);
  EXPECT_EQ(json.at("basis").at(1).at("params").at("sigma"), 20);
}

}  // namespace
}  // namespace vamp
