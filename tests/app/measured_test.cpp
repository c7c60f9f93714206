// vamp info and vamp convert on measured BTFs.
#include <gmock/gmock.h>

#include "engine/btf/btf.h"
#include "engine/btf/factored_btf.h"
#include "engine/image/save.h"
#include "tests/app/program.h"
#include "tests/btf/small_btf.h"

namespace vamp::test {
namespace {

using ::testing::HasSubstr;

class Measured : public Program {
 protected:
  Measured() {
    BtfInfo info = small_info();
    info.name = "felt";
    info.licence = "CC0";
    info.synthetic = true;
    Btf btf = Btf::create(folder / "felt.btf", info).value();
    fill(btf);
  }
  Json json_of(const std::vector<std::string>& arguments) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.json();
  }
};

TEST_F(Measured, InfoSaysSizesDirectionsAndOrigin) {
  const Json json = json_of({"info", "felt.btf", "--json"});
  EXPECT_EQ(json["kind"], "btf");
  EXPECT_EQ(json["format"], "Bonn BDI");
  EXPECT_EQ(json["name"], "felt");
  EXPECT_EQ(json["texels"], Json({5, 3}));
  EXPECT_EQ(json["views"]["count"], 81);
  EXPECT_EQ(json["views"]["set"], "ubo81");
  EXPECT_EQ(json["lights"]["count"], 4);
  EXPECT_EQ(json["mm_per_texel"], 0.25);
  EXPECT_EQ(json["size_mm"], Json({1.25, 0.75}));
  EXPECT_EQ(json["bytes_decoded"], 5 * 3 * 81 * 4 * 3 * 2);
  EXPECT_EQ(json["licence"], "CC0");
  EXPECT_EQ(json["synthetic"], true);
  EXPECT_THAT(run({"info", "felt.btf"}).out, HasSubstr("views: count 81, set ubo81"));
}

TEST_F(Measured, PicturesAndBackKeepEveryValue) {
  json_of({"convert", "felt.btf", "pictures", "--json"});
  const Json folder_json = json_of({"info", "pictures", "--json"});
  EXPECT_EQ(folder_json["format"], "folder of pictures");
  EXPECT_EQ(folder_json["views"]["count"], 81);
  const Json json = json_of({"convert", "pictures", "again.btf", "--mm-per-texel", "0.25", "--json"});
  EXPECT_EQ(json["format"], "Bonn BDI");
  EXPECT_EQ(json["mm_per_texel"], 0.25);
  const Btf again = Btf::open(folder / "again.btf").value();
  for (size_t t = 0; t < 15; ++t)
    for (size_t l = 0; l < 4; ++l) EXPECT_EQ(again.at(t, 40, l, 1), value_at(t, 40, l, 1));
}

TEST_F(Measured, APartKeepsItsPlace) {
  const Json json = json_of({"convert", "felt.btf", "part.btf", "--part", "1,2,3,1", "--json"});
  EXPECT_EQ(json["texels"], Json({3, 1}));
  EXPECT_EQ(json["name"], "felt");
  EXPECT_EQ(Btf::open(folder / "part.btf").value().at(2, 7, 3, 0), value_at(13, 7, 3, 0));
}

TEST_F(Measured, WhatCannotBeIsOneLineAndLeavesNothing) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"convert", "felt.btf", "felt.btf"}, "felt.btf: another file than the one that is read"},
      {{"convert", "felt.btf", "a.ptm"}, "expected one, for a polynomial texture map, found 81"},
      {{"convert", "felt.btf", "a.jpg"}, "expected a .btf, a .ptm or a folder to write, found \".jpg\""},
      {{"convert", "felt.btf", "a.btf", "--part", "0,0,6,1"}, "expected a part of 5 x 3"},
      {{"convert", "felt.btf", "a.btf", "--factors"}, "expected an FMF or DFMF file, found !BDIF06R2!"},
      {{"convert", "nothing.btf", "a.btf"}, "nothing there"},
      {{"info", "."}, "tl000_pl000_tv000_pv000"},
  };
  for (const auto& [arguments, message] : cases) {
    const Ended ended = run(arguments);
    EXPECT_NE(ended.code, 0);
    EXPECT_THAT(ended.err, HasSubstr(message));
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "a.btf"));
    EXPECT_FALSE(fs::exists(folder / "a.btf.part"));
  }
}

}  // namespace
}  // namespace vamp::test
