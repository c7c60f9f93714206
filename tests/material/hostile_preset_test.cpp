// Presets that are damaged or meant to harm: every one ends in one clear line, none in a crash or a surprise.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "engine/core/files.h"
#include "engine/core/hash.h"
#include "engine/core/json.h"
#include "engine/material/preset.h"
#include "engine/material/preset_zip.h"
#include "tests/material/small_spmm.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

class HostilePreset : public testing::Test {
 protected:
  HostilePreset() {
    Preset preset;
    preset.name = "small";
    preset.fit = std::make_shared<Spmm>(test::small_spmm());
    EXPECT_TRUE(save_preset(preset, folder_ / "good"));
    EXPECT_TRUE(save_preset(preset, folder_ / "good.vamp"));
    json_ = read_text(folder_ / "good/material.json", 1 << 24).value();
    tables_ = read_file(folder_ / "good/tables.bin", 1 << 24).value();
    zip_ = read_file(folder_ / "good.vamp", 1 << 24).value();
  }

  static std::vector<std::byte> bytes(std::string_view text) {
    const auto span = std::as_bytes(std::span(text.data(), text.size()));
    return {span.begin(), span.end()};
  }

  // Both forms of a preset with these two members; returns the error of the folder, checks that the zip says the same.
  Error load_with(const std::string& json, const std::vector<std::byte>& tables) {
    EXPECT_TRUE(write_text_atomically(folder_ / "good/material.json", json));
    EXPECT_TRUE(write_file_atomically(folder_ / "good/tables.bin", tables));
    const auto from_folder = load_preset(folder_ / "good");
    const std::vector<ZipMember> members = {{"material.json", bytes(json)}, {"tables.bin", tables}};
    EXPECT_TRUE(write_file_atomically(folder_ / "good.vamp", write_zip(members, "t").value()));
    const auto from_zip = load_preset(folder_ / "good.vamp");
    EXPECT_FALSE(from_folder);
    EXPECT_FALSE(from_zip);
    if (from_folder || from_zip) return {};
    EXPECT_EQ(from_folder.error().place, from_zip.error().place);
    EXPECT_EQ(from_folder.error().kind, ErrorKind::bad_input);
    EXPECT_EQ(from_folder.error().message().find('\n'), std::string::npos);
    return from_folder.error();
  }

  Error load_zip(const std::vector<std::byte>& zip) {
    EXPECT_TRUE(write_file_atomically(folder_ / "bad.vamp", zip));
    const auto loaded = load_preset(folder_ / "bad.vamp");
    EXPECT_FALSE(loaded);
    if (loaded) return {};
    EXPECT_EQ(loaded.error().kind, ErrorKind::bad_input);
    return loaded.error();
  }

  // material.json changed by `change`.
  std::string changed(const std::function<void(Json&)>& change) {
    Json json = parse_json(json_, "t").value();
    change(json);
    return json.dump();
  }

  // material.json that vouches for these tables, so that the checks behind the checksum are reached.
  std::string vouching(const std::vector<std::byte>& tables) {
    return changed([&](Json& json) {
      json["tables"]["bytes"] = tables.size();
      json["tables"]["xxh3_128"] = checksum(tables);
    });
  }

  test::TemporaryFolder folder_;
  std::string json_;
  std::vector<std::byte> tables_, zip_;
};

TEST_F(HostilePreset, MissingAndForeignFilesAreToldApart) {
  EXPECT_FALSE(load_preset(folder_ / "nothing.vamp"));
  ASSERT_TRUE(write_text_atomically(folder_ / "text.vamp", "I am no zip"));
  EXPECT_FALSE(load_preset(folder_ / "text.vamp"));
  fs::create_directory(folder_ / "empty");
  const auto empty = load_preset(folder_ / "empty");
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().kind, ErrorKind::bad_input);
  EXPECT_FALSE(load_preset_info(folder_ / "empty"));
}

TEST_F(HostilePreset, JsonThatIsWrongIsRefusedWithItsPlace) {
  struct Case {
    const char* place;
    std::function<void(Json&)> change;
  };
  const std::vector<Case> cases = {
      {"format", [](Json& j) { j["format"] = "gltf"; }},
      {"schema_version", [](Json& j) { j["schema_version"] = "2.0.0"; }},
      {"schema_version", [](Json& j) { j["schema_version"] = "1.x"; }},
      {"name", [](Json& j) { j.erase("name"); }},
      {"texels.width", [](Json& j) { j["texels"]["width"] = 1 << 30; }},
      {"texels.mm", [](Json& j) { j["texels"]["mm"] = -1; }},
      {"basis[1].model", [](Json& j) { j["basis"][1]["model"] = "phong3000"; }},
      {"basis[1].variant", [](Json& j) { j["basis"][1]["variant"] = "other"; }},
      {"basis[1].params.sigma", [](Json& j) { j["basis"][1]["params"]["sigma"] = 91; }},
      {"basis[1].params.gloss", [](Json& j) { j["basis"][1]["params"]["gloss"] = 1; }},
      {"basis[1].params.sigma", [](Json& j) { j["basis"][1]["params"]["sigma"] = "wide"; }},
      {"basis[2].normal",
       [](Json& j) {
         j["basis"][2]["normal"] = {0, 0, -1};
       }},
      {"basis[2].normal",
       [](Json& j) {
         j["basis"][2]["normal"] = {0.1, 0, 0};
       }},
      {"basis[2].psi", [](Json& j) { j["basis"][2]["psi"] = 1e30; }},
      {"clusters", [](Json& j) { j["clusters"] = Json::array(); }},
      {"residual.terms", [](Json& j) { j["residual"]["terms"] = 5; }},
      {"residual.directions", [](Json& j) { j["residual"]["directions"] = 5000; }},
      {"edits.bases[0].gain[0]",
       [](Json& j) {
         j["edits"]["bases"] = {{{"cluster", 0}, {"basis", 0}, {"gain", {-1, 1, 1}}}};
       }},
      {"edits.bases[0].cluster",
       [](Json& j) {
         j["edits"]["bases"] = {{{"cluster", -1}, {"basis", 0}}};
       }},
      {"edits of cluster 7, basis 0",
       [](Json& j) {
         j["edits"]["bases"] = {{{"cluster", 7}, {"basis", 0}, {"mute", true}}};
       }},
      {"edits.cluster_names.x", [](Json& j) { j["edits"]["cluster_names"]["x"] = "a"; }},
      {"edits.residual.policy", [](Json& j) { j["edits"]["residual"]["policy"] = "maybe"; }},
      {"edits.residual.strength", [](Json& j) { j["edits"]["residual"]["strength"] = 3; }},
      {"tables.uri", [](Json& j) { j["tables"]["uri"] = "../../../etc/passwd"; }},
  };
  for (const Case& c : cases) {
    const Error error = load_with(changed(c.change), tables_);
    EXPECT_EQ(error.place, c.place) << error.message();
  }
  load_with("", tables_);
  load_with("{", tables_);
  load_with(std::string(100000, '['), tables_);
  load_with(R"({"format": "vamp-material", "format": "vamp-material"})", tables_);
  load_with(json_.substr(0, json_.size() / 2), tables_);
}

TEST_F(HostilePreset, TablesThatWereChangedAreRefused) {
  for (size_t i = 0; i < tables_.size(); i += 1 + tables_.size() / 40) {
    auto damaged = tables_;
    damaged[i] ^= std::byte{4};
    EXPECT_EQ(load_with(json_, damaged).place, "tables.bin");
    // With a checksum that was made to fit, the table file's own checksums still stand, but for unused gaps.
    const auto loaded = [&] {
      EXPECT_TRUE(write_text_atomically(folder_ / "good/material.json", vouching(damaged)));
      EXPECT_TRUE(write_file_atomically(folder_ / "good/tables.bin", damaged));
      return load_preset(folder_ / "good");
    }();
    if (i < 224) {
      EXPECT_FALSE(loaded) << i;
    }
  }
  for (const size_t size : {size_t{0}, size_t{31}, size_t{223}, tables_.size() - 1}) {
    auto cut = tables_;
    cut.resize(size);
    EXPECT_EQ(load_with(json_, cut).place, "tables.bin");
    load_with(vouching(cut), cut);
  }
}

TEST_F(HostilePreset, ANanInTheTablesIsRefusedWithItsPlace) {
  // What save_preset refuses to write, written by hand: header, section table, sections, all checksums right.
  auto tables = tables_;
  const auto u64 = [&](size_t at) {
    uint64_t value = 0;
    std::memcpy(&value, tables.data() + at, 8);
    return value;
  };
  const size_t section = 32 + 3 * 48;  // residual
  const uint64_t offset = u64(section + 24), size = u64(section + 32);
  const uint16_t nan = 0x7e01;
  std::memcpy(tables.data() + offset + 32 * 100, &nan, 2);
  const uint64_t sum = hash64(std::span(tables).subspan(offset, size));
  std::memcpy(tables.data() + section + 40, &sum, 8);
  const uint64_t table_sum = hash64(std::span(tables).subspan(32, 4 * 48));
  std::memcpy(tables.data() + 24, &table_sum, 8);
  const Error error = load_with(vouching(tables), tables);
  EXPECT_EQ(error.place, "residual of cluster 0, view 1, light 19") << error.message();
}

TEST_F(HostilePreset, ZipsWithPathsInTheirNamesAreRefused) {
  for (const char* name : {"../material.json", "/etc/passwd", "folder/tables.bin", "..\\x", "c:x", ".."}) {
    const std::vector<ZipMember> members = {
        {"material.json", bytes(json_)}, {"tables.bin", tables_}, {name, bytes("x")}};
    EXPECT_EQ(load_zip(write_zip(members, "t").value()).place, "member names") << name;
  }
}

TEST_F(HostilePreset, ZipsWithMissingMembersAreRefused) {
  EXPECT_EQ(load_zip(write_zip(std::vector<ZipMember>{{"tables.bin", tables_}}, "t").value()).place, "material.json");
  EXPECT_EQ(load_zip(write_zip(std::vector<ZipMember>{{"material.json", bytes(json_)}}, "t").value()).place,
            "tables.bin");
}

TEST_F(HostilePreset, DamagedZipsAreRefused) {
  // Anywhere: headers, deflated data, checksums, central directory.
  int refused = 0, tried = 0;
  for (size_t i = 0; i < zip_.size(); i += 1 + zip_.size() / 200) {
    auto damaged = zip_;
    damaged[i] ^= std::byte{0x55};
    ASSERT_TRUE(write_file_atomically(folder_ / "bad.vamp", damaged));
    const auto loaded = load_preset(folder_ / "bad.vamp");
    ++tried;
    refused += loaded ? 0 : 1;
  }
  EXPECT_GE(refused, tried - 3);  // dates and attributes are nobody's business
  for (size_t size = 0; size < zip_.size(); size += 1 + zip_.size() / 50) {
    auto cut = zip_;
    cut.resize(size);
    load_zip(cut);
  }
}

TEST_F(HostilePreset, AZipThatDeclaresAHugeMemberCostsNoMemory) {
  // The uncompressed sizes of the first member, in its local header (22) and in the central directory (24).
  auto huge = zip_;
  const uint32_t size = 0xfffffff0u;
  std::memcpy(huge.data() + 22, &size, 4);
  for (size_t i = 0; i + 46 < huge.size(); ++i)
    if (std::memcmp(huge.data() + i, "PK\x01\x02", 4) == 0) {
      std::memcpy(huge.data() + i + 24, &size, 4);
      break;
    }
  const Error error = load_zip(huge);
  EXPECT_NE(error.message().find("at most"), std::string::npos) << error.message();
}

TEST_F(HostilePreset, ABombOfZerosStopsAtTheLimitOfItsMember) {
  std::vector<ZipMember> members = {{"material.json", std::vector<std::byte>(size_t{65} << 20)},
                                    {"tables.bin", tables_}};
  EXPECT_EQ(load_zip(write_zip(members, "t").value()).place, "material.json");
}

TEST_F(HostilePreset, LinksThatLeaveTheFolderAreNotFollowed) {
  fs::rename(folder_ / "good/tables.bin", folder_ / "outside.bin");
  fs::create_symlink(folder_ / "outside.bin", folder_ / "good/tables.bin");
  EXPECT_FALSE(load_preset(folder_ / "good"));
}

TEST_F(HostilePreset, ALaterMinorVersionIsReadAnEarlierProgramKeepsWhatItKnows) {
  ASSERT_TRUE(
      write_text_atomically(folder_ / "good/material.json", changed([](Json& j) { j["schema_version"] = "1.7.0"; })));
  EXPECT_TRUE(load_preset(folder_ / "good"));
}

}  // namespace
}  // namespace vamp
