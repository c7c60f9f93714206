#include "app/editor/teller.h"

#include <cstdio>

#include "editor/widgets/places.h"
#include "engine/core/json.h"

namespace vamp {

Teller::Teller() { ui::collect_places(); }

void Teller::tell(const ui::PanelContext& context) const {
  const RenderStatus& status = context.status;
  // A finished picture is that of the document only once the renderer has taken the document over.
  const bool settled = status.finished && status.project == context.document.project();
  Json places = Json::object();
  for (const ui::Place& place : ui::take_places())
    places.emplace(place.name, Json{place.low.x, place.low.y, place.high.x, place.high.y});
  const ImGuiIO& io = ImGui::GetIO();
  const Json line{{"frames", ImGui::GetFrameCount()},
                  {"vertices", io.MetricsRenderVertices},
                  {"window", {static_cast<int>(io.DisplaySize.x), static_cast<int>(io.DisplaySize.y)}},
                  {"pictures", context.session != nullptr ? context.session->picture_version() : 0},
                  {"samples", status.samples},
                  {"finished", settled},
                  {"restarted", status.restarted_pixels},
                  {"recombined", status.recombined_pixels},
                  {"weights_ready", status.weights_at_hand},
                  {"part", context.selection.part},
                  {"cluster", context.selection.cluster},
                  {"basis", context.selection.basis},
                  {"places", places}};
  std::puts(line.dump().c_str());
  std::fflush(stdout);
}

}  // namespace vamp
