#pragma once
// A picture in memory: named channels of floats. Linear Rec.709 unless a function says otherwise.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"

namespace vamp {

// Row 0 is the top row. pixels[(y * width + x) * channels.size() + c].
// Channels are named as in OpenEXR: R, G, B, A, Y for a single grey one, "layer.R" for those of a layer.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::vector<float> pixels;

  Image() = default;
  // All zero; width and height at least 1, at least one channel.
  Image(int width, int height, std::vector<std::string> channels);

  size_t index(int x, int y, size_t channel) const {
    return (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) * channels.size() + channel;
  }
  float at(int x, int y, size_t channel) const { return pixels[index(x, y, channel)]; }
  float& at(int x, int y, size_t channel) { return pixels[index(x, y, channel)]; }
  size_t pixel_count() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }

  std::optional<size_t> channel(std::string_view name) const;
};

// "depth" of "depth.Z"; empty for "R".
std::string_view layer_of(std::string_view channel);
// "Z" of "depth.Z", "R" of "R".
std::string_view component_of(std::string_view channel);

// A new image of the channels named, in this order. A name that does not exist is a programming error.
Image select_channels(const Image& image, std::span<const std::string> names);

// R, G and B of a layer as three channels; a lone Y is spread over the three. Error when the layer has neither.
Result<Image> colour_of(const Image& image, std::string_view layer, std::string_view file);

// Appends the channels of `other` as "layer.name" ("name" where layer is empty). Sizes must agree.
void add_layer(Image& image, const Image& other, std::string_view layer);

// The first value that is not finite, as "pixel (x, y), channel R" and what it is; nothing when all are finite.
std::optional<std::pair<std::string, std::string>> first_not_finite(const Image& image);

// Area average: each new pixel is the mean of the old ones under it, weighted by the covered part. New sizes from 1 to
// the old ones.
Image downsampled(const Image& image, int width, int height);

// The largest size of the same shape with both sides at most `side`, at least 1 and never larger than the image.
std::pair<int, int> size_within(int width, int height, int side);

}  // namespace vamp
