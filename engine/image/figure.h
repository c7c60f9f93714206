#pragma once
// A drawing of lines, areas and words, as SVG or as a picture.
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/vec.h"
#include "engine/image/image.h"

namespace vamp {

enum class Anchor { left, middle, right };

// Lengths in pixels from the upper left corner; colours as a display takes them, 0 to 1.
class Figure {
 public:
  Figure(int width, int height) : width_(width), height_(height) {}

  void line(std::vector<vec2> points, vec3 colour, float width = 1);
  void area(vec2 corner, vec2 size, vec3 colour);
  // `at` is the anchor on the words' middle line.
  void words(vec2 at, std::string text, float size, Anchor anchor, vec3 colour = vec3(0.2f));

  std::string svg() const;
  // Anti-aliased, three channels. Fails where no font is installed.
  Result<Image> picture() const;

 private:
  struct Line {
    std::vector<vec2> points;
    vec3 colour;
    float width;
  };
  struct Area {
    vec2 corner, size;
    vec3 colour;
  };
  struct Words {
    vec2 at;
    std::string text;
    float size;
    Anchor anchor;
    vec3 colour;
  };
  int width_, height_;
  std::vector<Area> areas_;  // drawn in this order
  std::vector<Line> lines_;
  std::vector<Words> words_;
};

}  // namespace vamp
