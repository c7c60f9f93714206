#pragma once
// Plots of measurements, and how they come to stand in a page.
#include <string>
#include <vector>

#include "bench/report.h"
#include "engine/image/figure.h"

namespace vamp {

struct Plot {
  std::string name;  // of its file, without an ending
  Figure figure;
};

// Puts the plots beside the page, docs/NAME.md, into docs/NAME/, and the report with links to them into its block.
Status write_page(Report report, const std::vector<Plot>& plots, const std::string& page);

// Colours that are told apart, in the order in which curves take them.
vec3 plot_colour(size_t index);

struct Curve {
  struct Point {
    double x = 0, y = 0;
  };
  std::string name;
  std::vector<Point> points;
};

// Curves over logarithmic axes of whole decades; what is not above 0 is left out.
struct Panel {
  std::string title;
  std::vector<Curve> curves;
};

// Three panels a row, all of the same decades, with the meaning of the axes below.
Figure log_panels(const std::vector<Panel>& panels, const std::string& axes);

}  // namespace vamp
