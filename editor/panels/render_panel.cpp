#include "editor/panels/render_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"
#include "engine/project/limits.h"

namespace vamp::ui {

std::string bytes_text(uint64_t bytes) {
  if (bytes < 1024) return fmt::format("{} bytes", bytes);
  double value = static_cast<double>(bytes);
  const char* unit = "";
  for (const char* next : {"KiB", "MiB", "GiB"}) {
    if (value < 1024) break;
    value /= 1024;
    unit = next;
  }
  return fmt::format("{:.3g} {}", value, unit);
}

std::string count_text(uint64_t count) {
  std::string text = std::to_string(count);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<size_t>(at), ",");
  return text;
}

void RenderPanel::draw(PanelContext& context) {
  gap(-6);
  section("Renderer");
  gap(4);
  draw_status(context);
  ImGui::BeginDisabled(context.session == nullptr);
  const char* const label = context.paused ? "Resume" : "Pause";
  const bool pressed = tool_button(label, context.paused, true, "Holds the renderer; the document can still be edited");
  if (pressed && context.run) context.run("render.pause");
  ImGui::EndDisabled();
  gap(2);
  draw_settings(context);
  draw_display(context);
}

void RenderPanel::draw_status(PanelContext& context) const {
  const RenderStatus& status = context.status;
  if (!status.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme().error);
    ImGui::TextWrapped("%s", status.error.c_str());
    ImGui::PopStyleColor();
  }
  const auto row = [](const char* label, const std::string& value, const char* tooltip) {
    info_row(label, value.c_str(), tooltip);
  };
  const auto pixels =
      static_cast<uint64_t>(std::max(status.width, 0)) * static_cast<uint64_t>(std::max(status.height, 0));
  const uint32_t most = context.document.project()->settings.max_samples;
  row("Samples",
      fmt::format("{} of {}{}", count_text(status.samples), count_text(most), status.finished ? ", done" : ""),
      "Of the pixel that has the fewest");
  row("Time", fmt::format("{:.1f} s", status.seconds), "Of rendering since the last restart");
  row("A sample", fmt::format("{:.{}f} ms", status.ms_per_sample, status.ms_per_sample < 10 ? 1 : 0),
      "For the whole picture");
  row("Noise", status.noise >= 0 ? fmt::format("{:.2g} %", static_cast<double>(status.noise) * 100) : "not known yet",
      "Estimated relative noise over the picture");
  row("Speed", fmt::format("{:.3g} Mrays/s", status.mrays_per_second), "Million rays a second");
  row("Restarted by", status.restart_reason.empty() ? "—" : status.restart_reason, "What the last restart was for");
  row("Pixels", fmt::format("{} of {} restarted", count_text(status.restarted_pixels), count_text(pixels)),
      "How many pixels the last edit began anew");
  row("Weight", status.weights_at_hand ? "follows at once" : "shaded again",
      "How the picture answers when the selected weight is pulled: from sums that are ready, or by shading again");
  row("Uploaded", bytes_text(status.bytes_uploaded), "By the last edit, to the GPU");
  row("GPU memory", bytes_text(status.gpu_bytes), "What the scene, the materials and the picture take");
  row("Picture", fmt::format("{} × {} pixels", status.width, status.height), "The size of the viewport");
  row("Device", status.device.empty() ? "—" : status.device, "What renders");
}

void RenderPanel::draw_settings(PanelContext& context) const {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const RenderSettings& now = project->settings;
  const RenderSettings initial;
  const auto change = [&](const char* what, auto set) {
    RenderSettings settings = now;
    set(settings);
    return change_settings(*project, settings, what);
  };
  section("Settings");
  gap(4);
  Parameter samples{"Max samples",
                    1,
                    static_cast<float>(kMaxSamples),
                    static_cast<float>(initial.max_samples),
                    "%.0f",
                    "The picture stops refining there.",
                    "samples a pixel",
                    &kLog};
  samples.whole = true;
  number_row(document, samples, static_cast<float>(now.max_samples), [&](float value) {
    return change("Max samples", [&](RenderSettings& s) { s.max_samples = static_cast<uint32_t>(value); });
  });
  number_row(
      document,
      {"Noise goal", 0, 20, 100 * initial.noise_goal, "%.2f %%",
       "Relative noise that is good enough: where the picture has less, it stops refining, and time goes where it "
       "has more. 0: refine everywhere.",
       "%"},
      100 * now.noise_goal,
      [&](float value) { return change("Noise goal", [&](RenderSettings& s) { s.noise_goal = value / 100; }); });
  // As text: a slider has not the digits for 32 bits.
  std::string seed = std::to_string(now.seed);
  const EditOf<std::string> typed =
      text_row("Seed", seed, "Chooses the random numbers, 0 to 4294967295: the same seed gives the same picture.");
  apply_edit(document, typed, [&] {
    return change("Seed", [&](RenderSettings& s) {
      uint32_t value = 0;
      const auto [end, error] = std::from_chars(seed.data(), seed.data() + seed.size(), value);
      if (error == std::errc() && end == seed.data() + seed.size()) s.seed = value;
    });
  });
  constexpr std::array<const char*, 2> kTaps{"One at random", "All four"};
  int tap = static_cast<int>(now.tap);
  const EditOf<int> chosen = combo_row("Texels", tap, kTaps, static_cast<int>(initial.tap),
                                       "Between four texels: one drawn at random is faster, all four less noisy. Both "
                                       "refine to the same picture.");
  apply_edit(document, chosen,
             [&] { return change("Texels", [&](RenderSettings& s) { s.tap = static_cast<TexelTap>(tap); }); });
  bool centres = now.pixel_centres;
  const EditOf<bool> toggled = toggle_row("Pixel centres", centres, initial.pixel_centres,
                                          "Rays through the middle of each pixel: no smooth edges.");
  apply_edit(document, toggled,
             [&] { return change("Pixel centres", [&](RenderSettings& s) { s.pixel_centres = centres; }); });
  gap(2);
}

void RenderPanel::draw_display(PanelContext& context) const {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  section("Display");
  gap(4);
  number_row(document,
             {"Exposure", -kMaxExposure, kMaxExposure, 0, "%+.2f EV",
              "Brightness of the picture; a step up doubles it. Nothing restarts.", "EV"},
             project->display.exposure, [&](float value) { return set_exposure(*project, value); });
  constexpr std::array<const char*, 2> kMaps{"PBR Neutral", "None"};
  int map = static_cast<int>(project->display.tone_map);
  const EditOf<int> chosen =
      combo_row("Tone map", map, kMaps, static_cast<int>(ToneMap::pbr_neutral),
                "How light beyond white is shown. PBR Neutral keeps the colours of materials. Nothing restarts.");
  apply_edit(document, chosen, [&] { return set_tone_map(*project, static_cast<ToneMap>(map)); });
}

}  // namespace vamp::ui
