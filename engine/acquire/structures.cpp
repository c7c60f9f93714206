// The names, and the settings that make a material of a kind.
#include "engine/acquire/leather.h"
#include "engine/acquire/weave.h"

namespace vamp {
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
  cloth->ends = 24;
  cloth->picks = 16;
  cloth->over = 3;
  cloth->under = 1;
  cloth->warp = vec3(0.025f, 0.05f, 0.145f);
  cloth->weft = vec3(0.56f, 0.55f, 0.51f);
  cloth->second = vec3(0.20f, 0.27f, 0.42f);
  cloth->blend = 0.45f;
  cloth->crimp = 0.62f;
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

constexpr StructureRow kRows[] = {
    {"leather", "Grained leather with creases and pores, lightly finished", plain<Leather>},
    {"plain", "Plain weave", plain<Weave>},
    {"wool-twill", "2/2 twill of grey melange wool", wool_twill},
    {"denim", "3/1 twill, indigo warp over white weft", denim},
    {"canvas", "Plain weave of thick raw cotton", canvas},
};

}  // namespace

std::span<const StructureRow> structures() { return kRows; }

}  // namespace vamp
