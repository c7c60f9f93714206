#include "tools/shoe/shoe.h"

#include "tools/shoe/hardware.h"
#include "tools/shoe/laces.h"
#include "tools/shoe/sole.h"
#include "tools/shoe/stitches.h"
#include "tools/shoe/studio.h"
#include "tools/shoe/upper.h"

namespace vamp::shoe {
namespace {

Mesh make_stitching(const Upper& upper, const Sole& sole, const Last& last) {
  Mesh all;
  const auto sew = [&](const Panel& panel) {
    for (const Curve& seam : panel.seams) all.append(stitch_row(seam, panel, last, {}));
  };
  sew(upper.toe_cap);
  sew(upper.counter);
  sew(upper.tongue);
  for (const Panel& quarter : upper.quarter) sew(quarter);
  all.append(stitch_row(sole.welt_seam, {.pitch = 4.2, .length = 3.4, .radius = 0.5}));
  return all;
}

}  // namespace

Scene make_shoe_scene() {
  const Last last;
  const Upper upper = cut_upper(last);
  const Sole sole = make_sole(last);
  const Laces laces = make_laces(upper, last);
  Mesh quarters = build(upper.quarter[0], last);
  quarters.append(build(upper.quarter[1], last));

  const Vec3 cognac(0.250, 0.085, 0.028), dark(0.120, 0.040, 0.016), cord(0.62, 0.55, 0.43);
  Scene scene;
  scene.parts = {
      {"Vamp", cognac, 0.42, 0.0, build(upper.vamp, last)},
      {"Toe cap", cognac * 0.92, 0.36, 0.0, build(upper.toe_cap, last)},
      {"Quarter", cognac, 0.42, 0.0, std::move(quarters)},
      {"Heel counter", dark, 0.40, 0.0, build(upper.counter, last)},
      {"Tongue", cognac * 0.85, 0.48, 0.0, build(upper.tongue, last)},
      {"Collar", dark, 0.50, 0.0, make_collar(upper, last)},
      {"Lining", {0.46, 0.33, 0.20}, 0.75, 0.0, make_lining(upper, last)},
      {"Insole", {0.42, 0.29, 0.17}, 0.70, 0.0, sole.insole},
      {"Pull tab", dark, 0.45, 0.0, make_pull_tab(upper, last)},
      {"Eyelets", {0.72, 0.50, 0.22}, 0.28, 1.0, make_eyelets(upper, last)},
      {"Laces", cord * 0.35, 0.80, 0.0, laces.cord},
      {"Lace tips", {0.05, 0.03, 0.02}, 0.30, 0.0, laces.tips},
      {"Stitching", {0.66, 0.56, 0.40}, 0.70, 0.0, make_stitching(upper, sole, last)},
      {"Welt", {0.20, 0.085, 0.035}, 0.50, 0.0, sole.welt},
      {"Midsole", {0.66, 0.60, 0.50}, 0.65, 0.0, sole.midsole},
      {"Outsole", {0.045, 0.028, 0.020}, 0.60, 0.0, sole.outsole},
      {"Heel block", {0.085, 0.040, 0.022}, 0.45, 0.0, sole.heel},
      {"Top piece", {0.025, 0.022, 0.020}, 0.75, 0.0, sole.top_piece},
  };
  for (Part& part : scene.parts) {
    part.mesh.settle_uv_scale();
    // The middle of the shoe's length stands at the origin.
    for (Vec3& p : part.mesh.positions) p.x -= 150.0;
  }
  add_studio(scene);
  return scene;
}

}  // namespace vamp::shoe
