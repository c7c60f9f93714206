// Damaged and hostile files of every format: one clear error or a sound BTF, never a crash, a hang, or memory on the
// file's word.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>

#include "engine/btf/btf_summary.h"
#include "engine/btf/factored_btf.h"
#include "engine/btf/image_names.h"
#include "engine/btf/light_list.h"
#include "engine/btf/load_btf.h"
#include "engine/btf/ptm.h"
#include "engine/image/save.h"
#include "tests/btf/bonn_files.h"
#include "tests/btf/tiny_files.h"
#include "tests/hostile/mutated.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

using test::Content;

// tests/hostile has the patience for more.
constexpr int kMutations = 300;

// One way of having a BTF on the disk, and the file of it that is damaged.
struct Case {
  const char* name;
  void (*write)(const fs::path& folder);
  const char* damaged;
  const char* loaded;
  bool has_checksum;  // of all that is not a value
};

const Case kCases[] = {
    {"Bdi", test::write_tiny_bdi, "a.btf", "a.btf", true},
    {"Dfmf", test::write_tiny_dfmf, "a.btf", "a.btf", true},
    {"Fmf", test::write_tiny_fmf, "a.btf", "a.btf", true},
    {"ForeignBdi", test::write_tiny_foreign_bdi, "a.btf", "a.btf", false},
    {"ForeignDfmf", test::write_tiny_foreign_dfmf, "a.btf", "a.btf", false},
    {"Pictures", test::write_tiny_pictures, "tl000_pl000_tv000_pv000.png", ".", false},
    {"Lights", test::write_tiny_lights, "a.lp", "a.lp", false},
    {"Map", test::write_tiny_map, "a.ptm", "a.ptm", false},
};

class HostileBtf : public ::testing::TestWithParam<Case> {
 protected:
  HostileBtf() {
    GetParam().write(folder_.path());
    content_ = read_file(damaged_path(), 1 << 24).value();
    summary_ = summary_of(loaded_path()).value();
  }
  fs::path damaged_path() const { return folder_ / GetParam().damaged; }
  fs::path loaded_path() const { return folder_ / GetParam().loaded; }

  // Not atomically: thousands of files need not reach the disk.
  void write(std::span<const std::byte> bytes) const {
    std::ofstream stream(damaged_path(), std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  void expect_one_clear_line(const Error& error) const {
    EXPECT_EQ(error.kind, ErrorKind::bad_input) << error.message();
    EXPECT_EQ(error.message().find('\n'), std::string::npos);
    EXPECT_THAT(error.message(), ::testing::StartsWith(folder_.path().string()));
    EXPECT_FALSE(error.expected.empty());
  }

  test::TemporaryFolder folder_;
  Content content_;
  BtfSummary summary_;
};

TEST_P(HostileBtf, EveryTruncationIsRefused) {
  const size_t step = std::max<size_t>(1, content_.size() / 200);
  for (size_t size = 0; size < content_.size(); size += step) {
    write(std::span(content_).first(size));
    const auto loaded = load_btf(loaded_path());
    // The last digits of the last number of a list are no loss that anyone could see.
    if (loaded && GetParam().damaged == std::string("a.lp")) {
      EXPECT_LT(glm::length(loaded->info().lights.directions.back() - summary_.info.lights.directions.back()), 1e-2);
      continue;
    }
    ASSERT_FALSE(loaded) << size << " of " << content_.size();
    expect_one_clear_line(loaded.error());
  }
}

TEST_P(HostileBtf, DamageEndsInAnErrorOrInASoundBtf) {
  std::mt19937 random(17);
  int refused = 0;
  double slowest = 0;
  for (int i = 0; i < kMutations; ++i) {
    const Content bytes = test::mutated(content_, random);
    if (bytes == content_) continue;
    write(bytes);
    const auto started = std::chrono::steady_clock::now();
    const auto loaded = load_btf(loaded_path());
    const auto described = summary_of(loaded_path());
    slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count());
    EXPECT_TRUE(described || !loaded) << i;
    if (!loaded) {
      ++refused;
      expect_one_clear_line(loaded.error());
      continue;
    }
    const BtfInfo &found = loaded->info(), &sound = summary_.info;
    if (GetParam().has_checksum) {
      // Nothing but values may differ.
      EXPECT_EQ(found.name, sound.name);
      EXPECT_EQ(found.provenance, sound.provenance);
      EXPECT_EQ(found.synthetic, sound.synthetic);
      EXPECT_EQ(found.mm_per_texel, sound.mm_per_texel);
      EXPECT_EQ(found.views.directions, sound.views.directions);
      EXPECT_EQ(found.lights.directions, sound.lights.directions);
      EXPECT_EQ(found.width, sound.width);
      EXPECT_EQ(found.height, sound.height);
    }
    // A list whose count and end are damaged so that they agree is a shorter list.
    const size_t lights = GetParam().damaged == std::string("a.lp") ? found.lights.size() : sound.lights.size();
    EXPECT_LE(lights, sound.lights.size());
    EXPECT_EQ(found.texel_count() * found.values_per_texel(), sound.texel_count() * sound.views.size() * lights * 3);
    EXPECT_TRUE(check_finite(*loaded, "values"));
    for (const auto* set : {&found.views, &found.lights})
      for (const dvec3& w : set->directions) EXPECT_TRUE(std::abs(glm::length(w) - 1) < 1e-6 && w.z >= 0);
  }
  RecordProperty("refused", refused);
  std::printf("%s: %d of %d refused, the slowest took %.3f s\n", GetParam().name, refused, kMutations, slowest);
}

INSTANTIATE_TEST_SUITE_P(Formats, HostileBtf, ::testing::ValuesIn(kCases),
                         [](const auto& test) { return test.param.name; });

// Headers that promise much: nothing may be allocated before the file is known to hold it.
TEST(HostileBtf, NothingIsAllocatedOnTheFilesWord) {
  const test::TemporaryFolder folder;
  test::write_tiny_dfmf(folder.path());
  const Content sound = read_file(folder / "a.btf", 1 << 20).value();
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &old), 0);
#if !defined(__SANITIZE_ADDRESS__)
  rlimit tight = old;
  tight.rlim_cur = rlim_t{1} << 30;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
#endif
  for (size_t at = 0; at + 4 <= sound.size(); ++at) {
    Content bytes = sound;
    const uint32_t huge = at % 2 == 0 ? 0x3fffffffu : 0xffffffffu;
    std::memcpy(bytes.data() + at, &huge, sizeof(huge));
    EXPECT_FALSE(read_factored_btf(bytes, "huge.btf")) << at;
  }
  setrlimit(RLIMIT_AS, &old);
}

TEST(HostileBtf, ABtfOfOthersHasNoChecksumAndIsRead) {
  const test::TemporaryFolder folder;
  test::write_foreign_bdi(folder / "bdi.btf");
  test::write_foreign_dfmf(folder / "dfmf.btf");
  for (const char* name : {"bdi.btf", "dfmf.btf"}) {
    const auto btf = load_btf(folder / name);
    ASSERT_TRUE(btf) << btf.error().message();
    EXPECT_EQ(btf->info().provenance, "dome; camera; LED");
    EXPECT_FLOAT_EQ(btf->info().mm_per_texel, 0.1f);
  }
}

}  // namespace
}  // namespace vamp
