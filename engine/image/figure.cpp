#include "engine/image/figure.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace vamp {
namespace {

constexpr int kFiner = 3;  // pixels a side under each pixel of a picture

std::string hex(vec3 colour) {
  const auto code = [](float value) { return static_cast<int>(std::lround(255 * std::clamp(value, 0.0f, 1.0f))); };
  return fmt::format("#{:02x}{:02x}{:02x}", code(colour.r), code(colour.g), code(colour.b));
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

void paint(Image& image, int x, int y, vec3 colour) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  for (int c = 0; c < 3; ++c) image.at(x, y, static_cast<size_t>(c)) = colour[c];
}

void paint_segment(Image& image, vec2 a, vec2 b, float width, vec3 colour) {
  const float radius = width / 2;
  const vec2 low = glm::min(a, b) - radius, high = glm::max(a, b) + radius, along = b - a;
  const float length2 = glm::dot(along, along);
  for (int y = static_cast<int>(std::floor(low.y)); y <= static_cast<int>(std::ceil(high.y)); ++y) {
    for (int x = static_cast<int>(std::floor(low.x)); x <= static_cast<int>(std::ceil(high.x)); ++x) {
      const vec2 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f) : 0;
      if (glm::distance(p, a + t * along) <= radius) paint(image, x, y, colour);
    }
  }
}

}  // namespace

void Figure::line(std::vector<vec2> points, vec3 colour, float width) {
  lines_.push_back({std::move(points), colour, width});
}

void Figure::area(vec2 corner, vec2 size, vec3 colour) { areas_.push_back({corner, size, colour}); }

void Figure::words(vec2 at, std::string text, float size, Anchor anchor, vec3 colour) {
  words_.push_back({at, std::move(text), size, anchor, colour});
}

std::string Figure::svg() const {
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n<g shape-rendering=\"crispEdges\">\n",
      width_, height_);
  for (const Area& a : areas_)
    text += fmt::format("<rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" fill=\"{}\"/>\n", a.corner.x,
                        a.corner.y, a.size.x, a.size.y, hex(a.colour));
  text += "</g>\n";
  for (const Line& l : lines_) {
    text += "<polyline points=\"";
    for (const vec2 p : l.points) text += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
    text += fmt::format("\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" stroke-linejoin=\"round\"/>\n",
                        hex(l.colour), l.width);
  }
  constexpr const char* kAnchors[] = {"start", "middle", "end"};
  for (const Words& w : words_)
    text += fmt::format(
        "<text x=\"{:g}\" y=\"{:g}\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"{:g}\" text-anchor=\"{}\" "
        "dominant-baseline=\"central\" fill=\"{}\">{}</text>\n",
        w.at.x, w.at.y, w.size, kAnchors[static_cast<int>(w.anchor)], hex(w.colour), escaped(w.text));
  return text + "</svg>\n";
}

Result<Image> Figure::picture() const {
  constexpr float kScale = kFiner;
  Image fine(width_ * kFiner, height_ * kFiner, {"R", "G", "B"});
  std::fill(fine.pixels.begin(), fine.pixels.end(), 1.0f);
  for (const Area& a : areas_) {
    const vec2 low = kScale * a.corner, high = kScale * (a.corner + a.size);
    for (int y = static_cast<int>(std::lround(low.y)); y < std::lround(high.y); ++y)
      for (int x = static_cast<int>(std::lround(low.x)); x < std::lround(high.x); ++x) paint(fine, x, y, a.colour);
  }
  for (const Line& l : lines_)
    for (size_t i = 1; i < l.points.size(); ++i)
      paint_segment(fine, kScale * l.points[i - 1], kScale * l.points[i], kScale * l.width, l.colour);

  namespace algo = OIIO::ImageBufAlgo;
  OIIO::ImageBuf canvas(OIIO::ImageSpec(fine.width, fine.height, 3, OIIO::TypeDesc::FLOAT), fine.pixels.data());
  constexpr algo::TextAlignX kAnchors[] = {algo::TextAlignX::Left, algo::TextAlignX::Center, algo::TextAlignX::Right};
  for (const Words& w : words_) {
    const float colour[] = {w.colour.r, w.colour.g, w.colour.b};
    if (!algo::render_text(canvas, static_cast<int>(kScale * w.at.x), static_cast<int>(kScale * w.at.y), w.text,
                           static_cast<int>(kScale * w.size), "DejaVuSans", colour,
                           kAnchors[static_cast<int>(w.anchor)], algo::TextAlignY::Center, 0, {}, 1))
      return fail(ErrorKind::failed, "", "", "words cannot be drawn: " + canvas.geterror());
  }
  return downsampled(fine, width_, height_);
}

}  // namespace vamp
