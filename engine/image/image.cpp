#include "engine/image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/check.h"

namespace vamp {
namespace {

// Which old pixels a new one covers along one axis, and how much of each.
struct Cover {
  int first = 0;
  std::vector<double> weights;
};

std::vector<Cover> covers(int from, int to) {
  std::vector<Cover> all(static_cast<size_t>(to));
  const double step = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double low = i * step;
    const double high = i + 1 == to ? from : (i + 1) * step;
    Cover& cover = all[static_cast<size_t>(i)];
    cover.first = static_cast<int>(low);
    for (int k = cover.first; k < from && k < high; ++k)
      cover.weights.push_back((std::min<double>(high, k + 1) - std::max<double>(low, k)) / (high - low));
  }
  return all;
}

}  // namespace

Image::Image(int new_width, int new_height, std::vector<std::string> names)
    : width(new_width), height(new_height), channels(std::move(names)) {
  CHECK(width > 0 && height > 0 && !channels.empty());
  pixels.resize(pixel_count() * channels.size());
}

std::optional<size_t> Image::channel(std::string_view name) const {
  const auto found = std::find(channels.begin(), channels.end(), name);
  if (found == channels.end()) return std::nullopt;
  return static_cast<size_t>(found - channels.begin());
}

std::string_view layer_of(std::string_view channel) {
  const size_t dot = channel.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : channel.substr(0, dot);
}

std::string_view component_of(std::string_view channel) {
  const size_t dot = channel.rfind('.');
  return dot == std::string_view::npos ? channel : channel.substr(dot + 1);
}

Image select_channels(const Image& image, std::span<const std::string> names) {
  Image selected(image.width, image.height, {names.begin(), names.end()});
  const size_t wide = image.channels.size();
  for (size_t c = 0; c < names.size(); ++c) {
    const auto source = image.channel(names[c]);
    CHECK(source.has_value());
    for (size_t i = 0; i < image.pixel_count(); ++i)
      selected.pixels[i * names.size() + c] = image.pixels[i * wide + *source];
  }
  return selected;
}

Result<Image> colour_of(const Image& image, std::string_view layer, std::string_view file) {
  const auto full = [layer](std::string_view name) {
    return layer.empty() ? std::string(name) : fmt::format("{}.{}", layer, name);
  };
  std::vector<std::string> names = {full("R"), full("G"), full("B")};
  if (image.channel(full("Y"))) names.assign(3, full("Y"));
  for (const auto& name : names)
    if (!image.channel(name))
      return fail(ErrorKind::bad_input, file, "channels", "R, G and B or Y",
                  fmt::format("{}", fmt::join(image.channels, ", ")));
  Image colour = select_channels(image, names);
  colour.channels = {"R", "G", "B"};
  return colour;
}

void add_layer(Image& image, const Image& other, std::string_view layer) {
  CHECK(image.width == other.width && image.height == other.height);
  const size_t old_wide = image.channels.size();
  const size_t added = other.channels.size();
  for (const auto& name : other.channels) {
    image.channels.push_back(layer.empty() ? name : fmt::format("{}.{}", layer, name));
    CHECK(std::count(image.channels.begin(), image.channels.end(), image.channels.back()) == 1);
  }
  std::vector<float> joined;
  joined.reserve(image.pixel_count() * (old_wide + added));
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const auto row = [](const std::vector<float>& from, size_t at) {
      return from.begin() + static_cast<std::ptrdiff_t>(at);
    };
    joined.insert(joined.end(), row(image.pixels, i * old_wide), row(image.pixels, (i + 1) * old_wide));
    joined.insert(joined.end(), row(other.pixels, i * added), row(other.pixels, (i + 1) * added));
  }
  image.pixels = std::move(joined);
}

std::optional<std::pair<std::string, std::string>> first_not_finite(const Image& image) {
  const auto bad = std::find_if(image.pixels.begin(), image.pixels.end(), [](float v) { return !std::isfinite(v); });
  if (bad == image.pixels.end()) return std::nullopt;
  const auto at = static_cast<size_t>(bad - image.pixels.begin());
  const size_t pixel = at / image.channels.size();
  const auto width = static_cast<size_t>(image.width);
  return std::pair(fmt::format("pixel ({}, {}), channel {}", pixel % width, pixel / width,
                               image.channels[at % image.channels.size()]),
                   std::string(std::isnan(*bad) ? "NaN"
                               : *bad > 0       ? "infinity"
                                                : "-infinity"));
}

Image downsampled(const Image& image, int width, int height) {
  CHECK(width >= 1 && height >= 1 && width <= image.width && height <= image.height);
  const auto columns = covers(image.width, width);
  const auto rows = covers(image.height, height);
  const size_t wide = image.channels.size();
  Image small(width, height, image.channels);
  std::vector<double> sum(static_cast<size_t>(width) * wide);
  for (int y = 0; y < height; ++y) {
    std::fill(sum.begin(), sum.end(), 0.0);
    const Cover& row = rows[static_cast<size_t>(y)];
    for (size_t j = 0; j < row.weights.size(); ++j)
      for (int x = 0; x < width; ++x) {
        const Cover& column = columns[static_cast<size_t>(x)];
        for (size_t i = 0; i < column.weights.size(); ++i) {
          const double weight = row.weights[j] * column.weights[i];
          const size_t at = image.index(column.first + static_cast<int>(i), row.first + static_cast<int>(j), 0);
          for (size_t c = 0; c < wide; ++c)
            sum[static_cast<size_t>(x) * wide + c] += weight * static_cast<double>(image.pixels[at + c]);
        }
      }
    for (size_t i = 0; i < sum.size(); ++i) small.pixels[small.index(0, y, 0) + i] = static_cast<float>(sum[i]);
  }
  return small;
}

std::pair<int, int> size_within(int width, int height, int side) {
  CHECK(width > 0 && height > 0 && side > 0);
  const double scale = std::min(1.0, static_cast<double>(side) / std::max(width, height));
  const auto scaled = [scale](int length) { return std::max(1, static_cast<int>(std::lround(length * scale))); };
  return {scaled(width), scaled(height)};
}

}  // namespace vamp
