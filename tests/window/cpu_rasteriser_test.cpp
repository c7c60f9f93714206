// The CPU rasteriser against answers worked out by hand.
#include "app/window/cpu_rasteriser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace vamp::window {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kWidth = 200;
constexpr int kHeight = 130;

// One draw list under the tests' control, drawn into a canvas of 200 x 130.
class RasterTest : public testing::Test {
 protected:
  RasterTest() : context_(ImGui::CreateContext()), list_(ImGui::GetDrawListSharedData()), raster_(textures_) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(kWidth, kHeight);
    textures_.add_fonts(*io.Fonts);
    ImGui::NewFrame();  // sets up the shared data: white pixel, curve tolerances
    pixels_.assign(kWidth * kHeight, 0x12345678);
    begin();
  }
  ~RasterTest() override {
    ImGui::EndFrame();
    ImGui::DestroyContext(context_);
  }

  void begin() {
    list_._ResetForNewFrame();
    list_.PushClipRect(ImVec2(0, 0), ImVec2(kWidth, kHeight));
    list_.PushTextureID(ImGui::GetIO().Fonts->TexID);
  }
  std::vector<PixelRect> draw() {
    ImDrawList* lists[] = {&list_};
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = lists;
    data.CmdListsCount = 1;
    data.DisplaySize = ImVec2(kWidth, kHeight);
    data.FramebufferScale = ImVec2(1, 1);
    const auto changed = raster_.draw(data, {pixels_.data(), kWidth, kHeight, kWidth});
    return {changed.begin(), changed.end()};
  }
  uint32_t at(int x, int y) const { return pixels_[static_cast<size_t>(y * kWidth + x)]; }
  int count(uint32_t colour) const { return static_cast<int>(std::count(pixels_.begin(), pixels_.end(), colour)); }

  ImGuiContext* context_;
  Textures textures_;
  ImDrawList list_;
  CpuRasteriser raster_;
  std::vector<uint32_t> pixels_;
};

TEST_F(RasterTest, AnEmptyFrameShowsTheBackground) {
  raster_.set_background(0x202224);
  EXPECT_THAT(draw(), testing::SizeIs(3));  // three rows of tiles
  EXPECT_EQ(count(0xff202224), kWidth * kHeight);
}

TEST_F(RasterTest, AFilledRectangleCoversExactlyItsPixels) {
  list_.AddRectFilled(ImVec2(10, 20), ImVec2(90, 71), IM_COL32(255, 128, 1, 255));
  draw();
  EXPECT_EQ(count(0xffff8001), 80 * 51);
  EXPECT_EQ(at(10, 20), 0xffff8001u);
  EXPECT_EQ(at(89, 70), 0xffff8001u);
  EXPECT_EQ(at(9, 20), 0xff000000u);
  EXPECT_EQ(at(90, 70), 0xff000000u);
  EXPECT_EQ(at(89, 71), 0xff000000u);
}

TEST_F(RasterTest, APixelIsCoveredWhenItsCentreIsInside) {
  list_.AddRectFilled(ImVec2(10.4f, 20.6f), ImVec2(12.4f, 21.6f), IM_COL32_WHITE);
  draw();
  EXPECT_EQ(count(0xffffffff), 2);
  EXPECT_EQ(at(10, 21), 0xffffffffu);
  EXPECT_EQ(at(11, 21), 0xffffffffu);
}

TEST_F(RasterTest, HalfTransparentColoursBlend) {
  raster_.set_background(0x0000ff);
  list_.AddRectFilled(ImVec2(0, 0), ImVec2(kWidth, kHeight), IM_COL32(255, 100, 0, 51));  // one fifth
  draw();
  // round(255 * 0.2), round(100 * 0.2), round(255 * 0.8)
  EXPECT_EQ(count(0xff000000u | 51 << 16 | 20 << 8 | 204), kWidth * kHeight);
}

TEST_F(RasterTest, TheClipRectangleCuts) {
  list_.PushClipRect(ImVec2(50, 50), ImVec2(60, 55));
  list_.AddRectFilled(ImVec2(0, 0), ImVec2(kWidth, kHeight), IM_COL32_WHITE);
  list_.AddTriangleFilled(ImVec2(0, 0), ImVec2(kWidth, 0), ImVec2(0, kHeight), IM_COL32_WHITE);
  list_.PopClipRect();
  draw();
  EXPECT_EQ(count(0xffffffff), 50);
}

TEST_F(RasterTest, TrianglesThatShareAnEdgeTouchEachPixelOnce) {
  // A fan of half-transparent triangles around an odd centre must blend every inner pixel exactly once.
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(0.0f, 1.0f);
  for (int round = 0; round < 20; ++round) {
    begin();
    raster_.set_background(static_cast<uint32_t>(round));
    const ImVec2 centre(80 + 40 * place(random), 40 + 40 * place(random));
    const ImVec2 corners[] = {ImVec2(0, 0), ImVec2(kWidth, 0), ImVec2(kWidth, kHeight), ImVec2(0, kHeight)};
    list_.Flags = 0;  // no anti-aliasing fringe
    for (int i = 0; i < 4; ++i) {
      list_.AddTriangleFilled(centre, corners[i], corners[(i + 1) % 4], IM_COL32(255, 255, 255, 255 * 2 / 5));
    }
    draw();
    EXPECT_EQ(count(at(0, 0)), kWidth * kHeight);
    EXPECT_EQ(at(0, 0) >> 16 & 0xff, 102u);
  }
}

TEST_F(RasterTest, ATriangleCoversHalfOfItsRectangle) {
  list_.Flags = 0;
  list_.AddTriangleFilled(ImVec2(0, 0), ImVec2(64, 0), ImVec2(0, 64), IM_COL32_WHITE);
  draw();
  // Centres on the slanted edge belong to neither a top nor a left edge: 63 + 62 + ... + 0.
  EXPECT_EQ(count(0xffffffff), 64 * 63 / 2);
}

TEST_F(RasterTest, ColoursRunLinearlyOverAGradient) {
  list_.AddRectFilledMultiColor(ImVec2(0, 0), ImVec2(128, 16), IM_COL32(0, 0, 0, 255), IM_COL32(255, 0, 0, 255),
                                IM_COL32(255, 0, 0, 255), IM_COL32(0, 0, 0, 255));
  draw();
  for (int x = 0; x < 128; ++x) {
    EXPECT_NEAR(at(x, 5) >> 16 & 0xff, (static_cast<float>(x) + 0.5f) / 128 * 255, 1.01f) << x;
  }
}

TEST_F(RasterTest, APictureAtItsOwnSizeIsCopiedBitForBit) {
  std::vector<uint8_t> rgba;
  for (int i = 0; i < 5 * 3; ++i) {
    for (const int c : {i, 100 + i, 200 + i, 255}) rgba.push_back(static_cast<uint8_t>(c));
  }
  const ImTextureID id = textures_.add(5, 3, PixelFormat::rgba8, rgba);
  list_.AddImage(id, ImVec2(61, 62), ImVec2(66, 65));
  draw();
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const auto i = static_cast<uint32_t>(y * 5 + x);
      EXPECT_EQ(at(61 + x, 62 + y), 0xff000000u | i << 16 | (100 + i) << 8 | (200 + i)) << x << "," << y;
    }
  }
  EXPECT_EQ(at(66, 62), 0xff000000u);
}

TEST_F(RasterTest, AnEnlargedPictureIsInterpolated) {
  const uint8_t rgba[] = {0, 0, 0, 255, 255, 255, 255, 255};
  const ImTextureID id = textures_.add(2, 1, PixelFormat::rgba8, rgba);
  list_.AddImage(id, ImVec2(0, 0), ImVec2(40, 10));
  draw();
  EXPECT_EQ(at(0, 5), 0xff000000u);  // clamped to the edge
  EXPECT_EQ(at(39, 5), 0xffffffffu);
  EXPECT_NEAR(at(19, 5) & 0xff, 255 * (19.5 / 20 - 0.5), 2.0);  // texel coordinate 0.975 between centres .5 and 1.5
}

TEST_F(RasterTest, TransparentTexelsLetTheGroundShow) {
  const uint8_t rgba[] = {255, 255, 255, 0, 255, 255, 255, 51};
  const ImTextureID id = textures_.add(2, 1, PixelFormat::rgba8, rgba);
  list_.AddImage(id, ImVec2(3, 3), ImVec2(5, 4));
  draw();
  EXPECT_EQ(at(3, 3), 0xff000000u);
  EXPECT_EQ(at(4, 3), 0xff333333u);
}

TEST_F(RasterTest, AnOutsidePictureIsShownFromItsOwnMemory) {
  std::vector<uint32_t> picture(100 * 50, 0x00112233);  // the renderer's buffer need not set alpha
  const ImTextureID id = textures_.add_external();
  textures_.set_external(id, 100, 50, PixelFormat::bgra8, reinterpret_cast<const uint8_t*>(picture.data()), 400);
  list_.AddImage(id, ImVec2(20, 10), ImVec2(120, 60));
  draw();
  EXPECT_EQ(at(20, 10) & 0xffffff, 0x112233u);
  EXPECT_THAT(draw(), IsEmpty());
  picture[0] = 0x00aabbcc;
  textures_.touch(id);
  EXPECT_THAT(draw(), testing::Not(IsEmpty()));
  EXPECT_EQ(at(20, 10) & 0xffffff, 0xaabbccu);
}

TEST_F(RasterTest, OnlyTilesThatChangedAreDrawnAgain) {
  const auto frame = [&](float x) {
    begin();
    list_.AddRectFilled(ImVec2(0, 0), ImVec2(kWidth, kHeight), IM_COL32(30, 30, 30, 255));
    list_.AddRectFilled(ImVec2(x, 70), ImVec2(x + 10, 80), IM_COL32_WHITE);
    return draw();
  };
  frame(70);
  EXPECT_THAT(frame(70), IsEmpty());
  EXPECT_THAT(frame(75), ElementsAre(PixelRect{64, 64, 128, 128}));
  EXPECT_THAT(frame(125), ElementsAre(PixelRect{64, 64, 192, 128}));
  EXPECT_EQ(count(0xffffffff), 100);
  raster_.forget();
  EXPECT_THAT(frame(125), testing::SizeIs(3));
}

TEST_F(RasterTest, WhatIsHiddenBelowAnOpaqueRectangleDoesNotCount) {
  const auto frame = [&](ImU32 below) {
    begin();
    list_.AddRectFilled(ImVec2(10, 10), ImVec2(20, 20), below);
    list_.AddRectFilled(ImVec2(0, 0), ImVec2(kWidth, kHeight), IM_COL32(30, 30, 30, 255));
    return draw();
  };
  frame(IM_COL32_WHITE);
  EXPECT_THAT(frame(IM_COL32_BLACK), IsEmpty());
}

TEST_F(RasterTest, PartialDrawingsEqualWholeOnes) {
  std::mt19937 random(3);
  const auto number = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
  std::vector<uint32_t> shapes(40);
  const auto frame = [&] {
    begin();
    for (const uint32_t seed : shapes) {
      std::mt19937 shape(seed);
      const auto value = [&](int limit) { return static_cast<float>(shape() % static_cast<unsigned>(limit)) * 0.37f; };
      const ImU32 colour = static_cast<ImU32>(shape());
      const ImVec2 a(value(500), value(350));
      const ImVec2 b(a.x + value(150), a.y + value(150));
      switch (seed % 3) {
        case 0:
          list_.AddRectFilled(a, b, colour, value(20));
          break;
        case 1:
          list_.AddCircle(a, 2 + value(80), colour, 0, 1.5f);
          break;
        default:
          list_.AddText(a, colour, "Vamp");
          break;
      }
    }
  };
  for (int round = 0; round < 30; ++round) {
    shapes[static_cast<size_t>(number(40))] = static_cast<uint32_t>(random());
    frame();
    draw();
    const std::vector<uint32_t> partial = pixels_;
    raster_.forget();
    draw();
    ASSERT_EQ(partial, pixels_) << "round " << round;
  }
}

TEST_F(RasterTest, RemovedPicturesAreSkippedAndTheirNamesStayDead) {
  const uint8_t white[] = {255, 255, 255, 255};
  const ImTextureID id = textures_.add(1, 1, PixelFormat::rgba8, white);
  textures_.remove(id);
  const ImTextureID other = textures_.add(1, 1, PixelFormat::rgba8, white);
  EXPECT_NE(id, other);
  list_.AddImage(id, ImVec2(0, 0), ImVec2(50, 50));
  draw();
  EXPECT_EQ(count(0xffffffff), 0);
}

}  // namespace
}  // namespace vamp::window
