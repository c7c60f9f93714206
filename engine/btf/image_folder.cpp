#include "engine/btf/image_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "engine/btf/image_names.h"
#include "engine/core/jobs.h"

namespace vamp {
namespace {

// More than the 151 x 151 pictures of Bonn's newer dome a hundred times over.
constexpr size_t kMaxPictures = 2'300'000;

bool is_picture(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".jpg" || extension == ".jpeg" || extension == ".png" || extension == ".exr" ||
         extension == ".hdr";
}

// Theta and phi in ten thousandths of a degree: names are compared as numbers, 30 and 030.0 being the same.
using Key = std::pair<int64_t, int64_t>;

Key key_of(double theta, double phi) {
  const auto ten_thousandths = [](double degrees) { return static_cast<int64_t>(degrees * 1e4 + 0.5); };
  return {ten_thousandths(theta), theta == 0 ? 0 : ten_thousandths(phi) % 3'600'000};
}

std::string text_of(const Key& light, const Key& view) {
  const auto degrees = [](int64_t value) { return static_cast<double>(value) / 1e4; };
  return fmt::format("light {} {}, view {} {}", degrees(light.first), degrees(light.second), degrees(view.first),
                     degrees(view.second));
}

using Found = std::map<std::pair<Key, Key>, fs::path>;  // by view and light

Result<Found> look_through(const fs::path& folder) {
  const std::string name = folder.string();
  Found found;
  std::error_code code;
  for (fs::recursive_directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    const fs::path path = at->path();
    const auto angles = image_angles(path.filename().string());
    if (!angles || !is_picture(path) || !at->is_regular_file(code)) continue;
    if (angles->light_theta > 90 || angles->view_theta > 90 || angles->light_phi > 720 || angles->view_phi > 720)
      return fail(ErrorKind::bad_input, path.string(), "name", "theta to 90 and phi to 360 degrees", "others");
    const Key light = key_of(angles->light_theta, angles->light_phi);
    const Key view = key_of(angles->view_theta, angles->view_phi);
    const auto [old, is_new] = found.emplace(std::pair(view, light), path);
    if (!is_new)
      return fail(ErrorKind::bad_input, name, text_of(light, view), "one picture",
                  fmt::format("two, {} and {}", std::min(old->second, path).lexically_relative(folder).string(),
                              std::max(old->second, path).lexically_relative(folder).string()));
    if (found.size() > kMaxPictures)
      return fail(ErrorKind::bad_input, name, "", fmt::format("at most {} pictures", kMaxPictures), "more");
  }
  if (code) return fail(ErrorKind::io, name, "", "cannot be read: " + code.message());
  if (found.empty())
    return fail(ErrorKind::bad_input, name, "", "pictures named after angles (tl000_pl000_tv000_pv000)", "none");
  return found;
}

DirectionSet directions_of(const std::map<Key, size_t>& keys) {
  std::vector<dvec3> directions;
  for (const auto& [key, index] : keys) {
    const double degree = std::numbers::pi / 180 / 1e4;
    dvec3 direction = direction_of({static_cast<double>(key.first) * degree, static_cast<double>(key.second) * degree});
    direction.z = std::max(direction.z, 0.0);
    directions.push_back(direction);
  }
  return named_direction_set(std::move(directions));
}

}  // namespace

Result<ImageSet> find_images(const fs::path& folder) {
  VAMP_TRY(const Found found, look_through(folder));
  std::map<Key, size_t> views, lights;
  for (const auto& [pair, path] : found) views[pair.first], lights[pair.second];
  if (views.size() > kMaxBtfDirections || lights.size() > kMaxBtfDirections)
    return fail(ErrorKind::bad_input, folder.string(), "names", fmt::format("at most {} directions", kMaxBtfDirections),
                fmt::format("{} views and {} lights", views.size(), lights.size()));
  // Said before anything of this size is allocated: a few stray names make many directions.
  for (const auto& [view, unused_view] : views)
    for (const auto& [light, unused_light] : lights)
      if (!found.contains({view, light}))
        return fail(ErrorKind::bad_input, folder.string(), text_of(light, view),
                    fmt::format("a picture for each of {} views and {} lights", views.size(), lights.size()),
                    fmt::format("none among {}", found.size()));
  ImageSet images{folder, directions_of(views), directions_of(lights), {}};
  for (const auto& [pair, path] : found) images.files.push_back(path);  // sorted by view, then light
  return images;
}

}  // namespace vamp
