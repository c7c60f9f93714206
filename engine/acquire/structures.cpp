// The names, and the settings that make a material of a kind.
#include "engine/acquire/air_mesh.h"
#include "engine/acquire/corduroy.h"
#include "engine/acquire/emboss.h"
#include "engine/acquire/felt.h"
#include "engine/acquire/knit.h"
#include "engine/acquire/leather.h"
#include "engine/acquire/perforated.h"
#include "engine/acquire/suede.h"
#include "engine/acquire/weave.h"

namespace vamp::acquire {
namespace {

using Made = std::unique_ptr<Structure>;

template <class Kind>
Made plain() {
  return std::make_unique<Kind>();
}

Made wool_twill() {
  auto cloth = std::make_unique<Weave>();
  cloth->name = "wool-twill";
  cloth->ends = cloth->picks = 24;
  cloth->over = cloth->under = 2;
  cloth->warp = vec3(0.07f, 0.072f, 0.08f);
  cloth->weft = vec3(0.20f, 0.195f, 0.19f);
  cloth->second = vec3(0.42f, 0.40f, 0.38f);
  cloth->blend = 0.35f;
  cloth->thickness = 0.7f;
  cloth->hairs = 7;
  cloth->turns = 0.8f;
  cloth->coat = 0.04f;
  cloth->across = 0.6f;
  cloth->slub = 0.1f;
  return cloth;
}

Made denim() {
  auto cloth = std::make_unique<Weave>();
  cloth->name = "denim";
  cloth->ends = 28;
  cloth->picks = 20;
  cloth->over = 3;
  cloth->under = 1;
  cloth->warp = vec3(0.025f, 0.05f, 0.145f);
  cloth->weft = vec3(0.45f, 0.44f, 0.41f);
  cloth->second = vec3(0.20f, 0.27f, 0.42f);
  cloth->blend = 0.3f;
  cloth->crimp = 0.68f;
  cloth->slub = 0.13f;
  cloth->turns = 1.1f;
  cloth->hairs = 2.5f;
  cloth->coat = 0.03f;
  return cloth;
}

Made canvas() {
  auto cloth = std::make_unique<Weave>();
  cloth->name = "canvas";
  cloth->ends = 16;
  cloth->picks = 14;
  cloth->warp = vec3(0.60f, 0.53f, 0.40f);
  cloth->weft = vec3(0.64f, 0.57f, 0.44f);
  cloth->second = vec3(0.42f, 0.33f, 0.21f);
  cloth->blend = 0.3f;
  cloth->cover = 0.96f;
  cloth->slub = 0.12f;
  cloth->hairs = 1.5f;
  cloth->coat = 0.03f;
  cloth->backing = vec3(0.12f, 0.1f, 0.07f);
  return cloth;
}

Made plain_weave() {
  auto cloth = std::make_unique<Weave>();
  cloth->name = "plain";
  return cloth;
}

Made twill() {
  auto cloth = std::make_unique<Weave>();
  cloth->name = "twill";
  cloth->over = cloth->under = 2;
  return cloth;
}

Made calf() {
  auto leather = std::make_unique<Leather>();
  leather->name = "calf";
  leather->plates = 20;
  leather->plate_height = 0.075f;
  leather->wrinkles = 0.018f;
  leather->pores = 0.18f;
  leather->pore_depth = 0.05f;
  leather->roughness = 0.25f;
  return leather;
}

Made patent() {
  auto leather = std::make_unique<Leather>();
  leather->name = "patent";
  leather->plates = 5;
  leather->plate_height = 0.012f;
  leather->crease_width = 1;
  leather->wrinkles = 0;
  leather->pores = 0;
  leather->mottling = 0.04f;
  leather->colour = vec3(0.02f, 0.02f, 0.022f);
  leather->crease_colour = vec3(0.012f, 0.012f, 0.014f);
  leather->roughness = 0.08f;
  leather->f0 = 0.06f;
  return leather;
}

Made nubuck() {
  auto nap = std::make_unique<Suede>();
  nap->name = "nubuck";
  nap->density = 380;
  nap->length = 0.11f;
  nap->radius = 0.02f;
  nap->lean = 0.93f;
  nap->relief = 0.6f;
  nap->ruffle = 0.8f;
  nap->ground = 0.035f;
  nap->colour = vec3(0.52f, 0.36f, 0.185f);
  nap->root_colour = vec3(0.46f, 0.31f, 0.155f);
  nap->mottling = 0.14f;
  return nap;
}

Made crocodile() {
  auto leather = std::make_unique<Emboss>();
  leather->name = "crocodile";
  return leather;
}

constexpr StructureRow kRows[] = {
    {"calf", "Grained calf leather, lightly finished", calf},
    {"patent", "Patent leather, black", patent},
    {"nubuck", "Nubuck: buffed grain with a short nap", nubuck},
    {"suede", "Suede: a longer nap, brushed and ruffled", plain<Suede>},
    {"crocodile", "Leather embossed with crocodile scales, glazed", crocodile},
    {"perforated", "White leather with staggered holes over a dark lining", plain<Perforated>},
    {"wool-twill", "2/2 twill of grey melange wool", wool_twill},
    {"denim", "3/1 twill, indigo warp over white weft", denim},
    {"canvas", "Plain weave of thick raw cotton", canvas},
    {"corduroy", "Corduroy: ribs of pile", plain<Corduroy>},
    {"felt", "Wool felt", plain<Felt>},
    {"air-mesh", "Air mesh: a knitted face with holes over a dark back", plain<AirMesh>},
    {"plain", "Plain weave, grey", plain_weave},
    {"twill", "2/2 twill, grey", twill},
    {"knit", "Plain jersey", plain<Knit>},
    {"leather", "Leather with a coarse grain, creases and pores", plain<Leather>},
    {"emboss", "The crocodile's kind, for patterns of one's own", plain<Emboss>},
};

}  // namespace

std::span<const StructureRow> structures() { return kRows; }

}  // namespace vamp::acquire
