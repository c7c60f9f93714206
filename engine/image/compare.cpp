#include "engine/image/compare.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/json.h"
#include "engine/image/load.h"
#include "engine/image/metrics.h"
#include "shaders/shared/tonemap.h"

namespace vamp {
namespace {

bool is_rgb(std::string_view component) { return component == "R" || component == "G" || component == "B"; }

bool is_colour(std::span<const std::string> names) {
  const auto has = [names](std::string_view c) {
    return std::any_of(names.begin(), names.end(), [c](const auto& name) { return component_of(name) == c; });
  };
  return (names.size() == 3 && has("R") && has("G") && has("B")) || (names.size() == 1 && has("Y"));
}

// What names the set that a channel belongs to.
std::string set_name(std::string_view channel) {
  const std::string_view layer = layer_of(channel);
  const std::string_view component = component_of(channel);
  const std::string prefix = layer.empty() ? std::string() : std::string(layer) + ".";
  if (component == "A") return prefix + "alpha";
  if (layer.empty()) return is_rgb(component) || component == "Y" ? "colour" : std::string(component);
  return std::string(layer);
}

// sRGB-encoded display values of R, G, B, and of their luminance.
struct Shown {
  std::vector<float> colour;
  std::vector<float> luminance;
};

Result<Shown> shown(const Image& colours, const Display& display) {
  VAMP_TRY(const Image light, displayed(colours, display));
  Shown result;
  for (size_t i = 0; i < light.pixels.size(); i += 3) {
    const float* p = light.pixels.data() + i;
    for (int c = 0; c < 3; ++c) result.colour.push_back(srgb_encode(p[c]));
    result.luminance.push_back(srgb_encode(static_cast<float>(
        luminance(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])))));
  }
  return result;
}

Result<ChannelErrors> compare_set(const Image& a, const Image& b, std::string name, std::vector<std::string> names,
                                  const Display& display) {
  Image left = select_channels(a, names);
  Image right = select_channels(b, names);
  ChannelErrors errors;
  errors.rmse = rmse(left.pixels, right.pixels);
  errors.rel_mse = rel_mse(left.pixels, right.pixels);
  errors.max_error = max_error(left.pixels, right.pixels);
  errors.equal = left.pixels == right.pixels;
  if (is_colour(names)) {
    for (Image* image : {&left, &right})
      for (std::string& channel : image->channels) channel = std::string(component_of(channel));
    VAMP_TRY(const Shown shown_left, shown(left, display));
    VAMP_TRY(const Shown shown_right, shown(right, display));
    if (shown_left.colour != shown_right.colour) errors.psnr = psnr(shown_left.colour, shown_right.colour);
    errors.mssim = mssim(shown_left.luminance, shown_right.luminance, a.width, a.height);
  }
  errors.name = std::move(name);
  errors.channels = std::move(names);
  return errors;
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

Result<CompareReport> compare_images(const Image& a, const Image& b, const Display& display, std::string_view file_a,
                                     std::string_view file_b) {
  if (a.width != b.width || a.height != b.height)
    return fail(ErrorKind::bad_input, file_a, "size", fmt::format("{} x {} as in {}", b.width, b.height, file_b),
                fmt::format("{} x {}", a.width, a.height));
  for (const auto& [image, file] : {std::pair(&a, file_a), std::pair(&b, file_b)})
    if (const auto bad = first_not_finite(*image))
      return fail(ErrorKind::bad_input, file, bad->first, "finite numbers", bad->second);

  CompareReport report{a.width, a.height, display, {}, {}, {}};
  std::vector<std::pair<std::string, std::vector<std::string>>> sets;
  for (const auto& name : a.channels) {
    if (!b.channel(name)) {
      report.only_in_a.push_back(name);
      continue;
    }
    const std::string set = set_name(name);
    auto found = std::find_if(sets.begin(), sets.end(), [&set](const auto& s) { return s.first == set; });
    if (found == sets.end()) found = sets.insert(sets.end(), {set, {}});
    found->second.push_back(name);
  }
  for (const auto& name : b.channels)
    if (!a.channel(name)) report.only_in_b.push_back(name);
  if (sets.empty())
    return fail(ErrorKind::bad_input, file_a, "channels", fmt::format("one of {}", fmt::join(b.channels, ", ")),
                fmt::format("{}", fmt::join(a.channels, ", ")));
  for (auto& [name, names] : sets) {
    VAMP_TRY(auto errors, compare_set(a, b, name, names, display));
    report.sets.push_back(std::move(errors));
  }
  return report;
}

Result<CompareReport> compare_files(const fs::path& a, const fs::path& b, float exposure) {
  const uint64_t limit = ImageLimits{}.bytes;
  VAMP_TRY(const auto bytes_a, read_file(a, limit));
  VAMP_TRY(const auto bytes_b, read_file(b, limit));
  VAMP_TRY(const ImageFormat format_a, image_format(bytes_a, a.string()));
  VAMP_TRY(const ImageFormat format_b, image_format(bytes_b, b.string()));
  const auto kind = [](ImageFormat format) {
    return is_display_format(format) ? "a display picture (PNG, JPEG)" : "a scene-linear picture (OpenEXR, HDR)";
  };
  if (is_display_format(format_a) != is_display_format(format_b))
    return fail(ErrorKind::bad_input, a.string(), "", fmt::format("{} as {} is", kind(format_b), b.string()),
                kind(format_a));
  VAMP_TRY(const Image image_a, decode_image(bytes_a, a.string()));
  VAMP_TRY(const Image image_b, decode_image(bytes_b, b.string()));
  const ToneCurve curve = is_display_format(format_a) ? ToneCurve::linear : ToneCurve::neutral;
  return compare_images(image_a, image_b, {exposure, curve}, a.string(), b.string());
}

std::string compare_json(const CompareReport& report) {
  Json sets = Json::array();
  for (const auto& set : report.sets)
    sets.push_back({{"name", set.name},
                    {"channels", set.channels},
                    {"rmse", set.rmse},
                    {"relmse", set.rel_mse},
                    {"max_error", set.max_error},
                    {"psnr", number_or_null(set.psnr)},
                    {"mssim", number_or_null(set.mssim)},
                    {"equal", set.equal}});
  // The first set stands at the top again, so that scripts find rmse, relmse and mssim without searching.
  const auto& first = report.sets.front();
  const Json json = {
      {"width", report.width},
      {"height", report.height},
      {"rmse", first.rmse},
      {"relmse", first.rel_mse},
      {"psnr", number_or_null(first.psnr)},
      {"mssim", number_or_null(first.mssim)},
      {"equal", std::all_of(report.sets.begin(), report.sets.end(), [](const auto& s) { return s.equal; }) &&
                    report.only_in_a.empty() && report.only_in_b.empty()},
      {"exposure", json_number(report.display.exposure)},
      {"tone_curve", report.display.curve == ToneCurve::neutral ? "neutral" : "linear"},
      {"sets", sets},
      {"only_in_a", report.only_in_a},
      {"only_in_b", report.only_in_b}};
  return print_json(json);
}

std::string compare_text(const CompareReport& report) {
  std::string text;
  for (const auto& set : report.sets) {
    text += fmt::format("{}: RMSE {:.6g}, relMSE {:.6g}, largest error {:.6g}", set.name, set.rmse, set.rel_mse,
                        set.max_error);
    if (set.psnr) text += fmt::format(", PSNR {:.2f} dB", *set.psnr);
    if (set.mssim) text += fmt::format(", MSSIM {:.6f}", *set.mssim);
    text += set.equal ? ", equal\n" : "\n";
  }
  if (!report.only_in_a.empty()) text += fmt::format("only in the first: {}\n", fmt::join(report.only_in_a, ", "));
  if (!report.only_in_b.empty()) text += fmt::format("only in the second: {}\n", fmt::join(report.only_in_b, ", "));
  return text;
}

}  // namespace vamp
