// Measured BTFs and fixed-view measurements.
#include "app/commands/info.h"
#include "engine/btf/btf_summary.h"

namespace vamp {
namespace {

Json directions_info(const DirectionSet& set) { return {{"count", set.size()}, {"set", set.name}}; }

}  // namespace

Result<Json> btf_info(const fs::path& path) {
  VAMP_TRY(const BtfSummary summary, summary_of(path));
  const BtfInfo& info = summary.info;
  Json json;
  json["file"] = path.string();
  json["kind"] = "btf";
  json["format"] = name_of(summary.format);
  json["name"] = info.name;
  json["texels"] = {info.width, info.height};
  json["views"] = directions_info(info.views);
  json["lights"] = directions_info(info.lights);
  json["fixed_view"] = info.fixed_view();
  const bool known = info.mm_per_texel > 0;
  json["mm_per_texel"] = known ? json_number(info.mm_per_texel) : Json();
  json["size_mm"] = known ? Json{json_number(static_cast<float>(info.width) * info.mm_per_texel),
                                 json_number(static_cast<float>(info.height) * info.mm_per_texel)}
                          : Json();
  json["colour_model"] = summary.colour;
  json["channels"] = summary.channels;
  if (!summary.components.empty()) json["components"] = summary.components;
  json["values"] = info.colour == BtfColour::rec709 ? "light reflected under unit irradiance, with the cosine"
                                                    : "logarithm of chroma, signed";
  json["cosine_in_file"] = summary.has_cosine;
  if (summary.rotation_count > 0) json["rotations_not_applied"] = summary.rotation_count;
  json["bytes"] = summary.bytes;
  json["bytes_decoded"] = summary.decoded_bytes;
  json["mapped"] = summary.mapped;
  json["synthetic"] = info.synthetic;
  json["provenance"] = info.provenance;
  json["licence"] = info.licence;
  return json;
}

}  // namespace vamp
