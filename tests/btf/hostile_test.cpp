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
#include "tests/btf/small_btf.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

using Content = std::vector<std::byte>;

// VAMP_MUTATIONS asks for more than the default run has time for.
int mutation_count() {
  const char* wanted = std::getenv("VAMP_MUTATIONS");
  return wanted == nullptr ? 300 : std::atoi(wanted);
}

// 2 x 2 texels, 2 views, 3 lights.
BtfInfo tiny_info() {
  BtfInfo info;
  info.width = info.height = 2;
  info.views = named_direction_set({direction_of({0, 0}), direction_of({0.9, 2})});
  info.lights = named_direction_set({direction_of({0, 0}), direction_of({0.5, 1}), direction_of({1.1, 4})});
  info.name = "tiny";
  info.provenance = "a test";
  info.mm_per_texel = 0.5f;
  info.synthetic = true;
  return info;
}

FactoredBtf tiny_factors(bool decorrelated, ColourModel model, int scalar_bytes) {
  FactoredBtf btf;
  btf.info = tiny_info();
  btf.decorrelated = decorrelated;
  btf.colour.model = model;
  for (size_t set = 0; set < (decorrelated ? 3u : 1u); ++set) {
    Factors f;
    f.rows = decorrelated ? 6 : 18;
    f.columns = 4;
    f.components = 2;
    f.scalar_bytes = scalar_bytes;
    f.s = {2, 1};
    for (size_t i = 0; i < size_t{f.rows} * 2; ++i) f.u.push_back(0.25f + static_cast<float>(i % 5) / 8);
    for (size_t i = 0; i < size_t{f.columns} * 2; ++i) f.sxv.push_back(0.5f + static_cast<float>(i % 3) / 4);
    btf.factors.push_back(std::move(f));
  }
  return btf;
}

// One way of having a BTF on the disk, and the file of it that is damaged.
struct Case {
  const char* name;
  void (*write)(const fs::path& folder);
  const char* damaged;
  const char* loaded;
  bool has_checksum;  // of all that is not a value
};

void write_bdi(const fs::path& folder) {
  Btf btf = Btf::create(folder / "a.btf", tiny_info()).value();
  for (size_t t = 0; t < 4; ++t)
    for (Half& value : btf.writable_texel(t)) value = half_from_float(0.25f * static_cast<float>(t + 1));
}
void write_dfmf(const fs::path& folder) {
  ASSERT_TRUE(write_factored_btf(folder / "a.btf", tiny_factors(true, ColourModel::log_y_uv_by_y, 2)));
}
void write_fmf(const fs::path& folder) {
  ASSERT_TRUE(write_factored_btf(folder / "a.btf", tiny_factors(false, ColourModel::log_rgb, 4)));
}
void write_pictures(const fs::path& folder) {
  Image picture(4, 4, {"R", "G", "B"});
  std::ranges::fill(picture.pixels, 0.5f);
  const BtfInfo info = tiny_info();
  for (const dvec3& view : info.views.directions)
    for (const dvec3& light : info.lights.directions)
      ASSERT_TRUE(save_png(folder / (image_name(light, view) + ".png"), picture));
}
void write_lights(const fs::path& folder) {
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) names.push_back("p" + std::to_string(i) + ".png");
  for (const std::string& name : names) ASSERT_TRUE(save_png(folder / name, Image(4, 4, {"R", "G", "B"})));
  ASSERT_TRUE(write_light_list(folder / "a.lp", names, tiny_info().lights));
}
void write_map(const fs::path& folder) {
  Ptm ptm;
  ptm.width = ptm.height = 3;
  ptm.scale.fill(1.5f);
  ptm.bias.fill(100);
  ptm.coefficients.assign(54, 140);
  ptm.colours.assign(27, 200);
  ASSERT_TRUE(write_ptm(folder / "a.ptm", ptm));
}

const Case kCases[] = {
    {"Bdi", write_bdi, "a.btf", "a.btf", true},
    {"Dfmf", write_dfmf, "a.btf", "a.btf", true},
    {"Fmf", write_fmf, "a.btf", "a.btf", true},
    {"ForeignBdi", [](const fs::path& folder) { test::write_foreign_bdi(folder / "a.btf"); }, "a.btf", "a.btf", false},
    {"ForeignDfmf", [](const fs::path& folder) { test::write_foreign_dfmf(folder / "a.btf"); }, "a.btf", "a.btf",
     false},
    {"Pictures", write_pictures, "tl000_pl000_tv000_pv000.png", ".", false},
    {"Lights", write_lights, "a.lp", "a.lp", false},
    {"Map", write_map, "a.ptm", "a.ptm", false},
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

  // A few bytes changed, cut out, doubled, or numbers put where sizes may stand.
  Content damaged(std::mt19937& random) const {
    constexpr uint32_t kNumbers[] = {0,          1,          2,          255,        65535,     65536,
                                     0x7fffffff, 0x80000000, 0xffffffff, 0x7f800000, 0x7fc00000};
    Content result = content_;
    const size_t rounds = 1 + random() % 3;
    for (size_t i = 0; i < rounds && result.size() > 8; ++i) {
      const size_t at = random() % (result.size() - 4);
      const size_t length = 1 + random() % 16;
      const auto here = result.begin() + static_cast<std::ptrdiff_t>(at);
      const auto end = result.begin() + static_cast<std::ptrdiff_t>(std::min(at + length, result.size()));
      switch (random() % 6) {
        case 0:
          result[at] ^= static_cast<std::byte>(1u << random() % 8);
          break;
        case 1:
          result[at] = static_cast<std::byte>(random());
          break;
        case 2: {
          const uint32_t number = kNumbers[random() % std::size(kNumbers)];
          std::memcpy(&*here, &number, sizeof(number));
          break;
        }
        case 3:
          result.erase(here, end);
          break;
        case 4: {
          const Content copy(here, end);
          result.insert(here, copy.begin(), copy.end());
          break;
        }
        default:
          result.resize(at);
      }
    }
    return result;
  }

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
  const int count = mutation_count();
  for (int i = 0; i < count; ++i) {
    const Content bytes = damaged(random);
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
  std::printf("%s: %d of %d refused, the slowest took %.3f s\n", GetParam().name, refused, count, slowest);
}

INSTANTIATE_TEST_SUITE_P(Formats, HostileBtf, ::testing::ValuesIn(kCases),
                         [](const auto& test) { return test.param.name; });

// Headers that promise much: nothing may be allocated before the file is known to hold it.
TEST(HostileBtf, NothingIsAllocatedOnTheFilesWord) {
  const test::TemporaryFolder folder;
  write_dfmf(folder.path());
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
