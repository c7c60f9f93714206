#include "engine/project/job_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/project/limits.h"
#include "shaders/shared/tonemap.h"

namespace vamp {
namespace {

std::string quoted(std::string_view text) {
  constexpr size_t kShown = 80;  // an error stays one line, whatever was pasted
  return fmt::format("\"{}{}\"", text.substr(0, kShown), text.size() > kShown ? "..." : "");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (size_t begin = 0;;) {
    const size_t end = text.find(separator, begin);
    pieces.push_back(trimmed(text.substr(begin, end - begin)));
    if (end == std::string_view::npos) return pieces;
    begin = end + 1;
  }
}

// The whole text as a finite number; locale-independent.
bool number_from(std::string_view text, float& number) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  return code == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

// "key=a,b,c,key=d": each value a list of its components, in the order of writing.
struct Value {
  std::string_view key;
  std::vector<std::string_view> components;
};

// Reads the values of one option; the first problem stays, readers go on with what they have.
class OptionReader {
 public:
  explicit OptionReader(std::string_view place) : place_(place) {}

  void read(const std::vector<std::string_view>& pieces, size_t first) {
    for (size_t i = first; i < pieces.size(); ++i) {
      const size_t equals = pieces[i].find('=');
      if (equals != std::string_view::npos) {
        const std::string_view key = trimmed(pieces[i].substr(0, equals));
        if (find(key) != nullptr) refuse("", "each key once", fmt::format("{} twice", quoted(key)));
        values_.push_back({key, {trimmed(pieces[i].substr(equals + 1))}});
      } else if (values_.empty()) {
        refuse("", "key=value", quoted(pieces[i]));
      } else {
        values_.back().components.push_back(pieces[i]);
      }
    }
  }

  void allow(const std::vector<std::string_view>& keys) {
    for (const Value& value : values_)
      if (std::find(keys.begin(), keys.end(), value.key) == keys.end())
        refuse("", fmt::format("one of the keys {}", fmt::join(keys, ", ")), quoted(value.key));
  }

  bool has(std::string_view key) const { return find(key) != nullptr; }

  float number(std::string_view key, float low, float high, std::string_view unit) {
    float result = low;
    const Value* value = need(key, unit);
    if (value == nullptr) return result;
    if (value->components.size() != 1 || !number_from(value->components[0], result) || result < low || result > high)
      refuse(key, fmt::format("{} from {:g} to {:g}", unit, low, high), quoted(joined(*value)));
    return result;
  }

  vec3 vector(std::string_view key) {
    vec3 result(0);
    const Value* value = need(key, "x,y,z");
    if (value == nullptr) return result;
    bool good = value->components.size() == 3;
    for (int i = 0; good && i < 3; ++i)
      good = number_from(value->components[static_cast<size_t>(i)], result[i]) && std::abs(result[i]) <= kMaxCoordinate;
    if (!good) refuse(key, "x,y,z: three numbers of at most 1e7", quoted(joined(*value)));
    return result;
  }

  vec3 color(std::string_view key) {
    const Value* value = need(key, "r,g,b or #rrggbb");
    if (value == nullptr) return vec3(0);
    const auto result = parse_color(joined(*value), place_ + " " + std::string(key));
    if (result) return *result;
    if (!error_) error_ = result.error();
    return vec3(0);
  }

  vec2 sides(std::string_view key) {
    vec2 result(0);
    const Value* value = need(key, "AxB");
    if (value == nullptr) return result;
    const auto pieces = split(joined(*value), 'x');
    if (pieces.size() != 2 || !number_from(pieces[0], result.x) || !number_from(pieces[1], result.y) ||
        !(result.x >= kMinLength && result.x <= kMaxCoordinate && result.y >= kMinLength && result.y <= kMaxCoordinate))
      refuse(key, "AxB: two lengths above 0 in scene units", quoted(joined(*value)));
    return result;
  }

  std::string text(std::string_view key) {
    const Value* value = need(key, "a name");
    if (value == nullptr) return {};
    std::string result = joined(*value);
    if (result.empty() || result.size() > kMaxNameBytes)
      refuse(key, fmt::format("a name of 1 to {} bytes", kMaxNameBytes), quoted(result));
    return result;
  }

  void refuse(std::string_view key, std::string_view expected, std::string_view found) {
    if (error_) return;
    std::string place(place_);
    if (!key.empty()) place += " " + std::string(key);
    error_ = Error{ErrorKind::usage, "", std::move(place), std::string(expected), std::string(found)};
  }

  const std::optional<Error>& error() const { return error_; }

 private:
  static std::string joined(const Value& value) { return fmt::format("{}", fmt::join(value.components, ",")); }

  const Value* find(std::string_view key) const {
    for (const Value& value : values_)
      if (value.key == key) return &value;
    return nullptr;
  }

  const Value* need(std::string_view key, std::string_view form) {
    const Value* value = find(key);
    if (value == nullptr) refuse("", fmt::format("{}={}", key, form), fmt::format("no {}", key));
    return value;
  }

  std::string place_;
  std::vector<Value> values_;
  std::optional<Error> error_;
};

std::vector<std::string_view> keys_of(LightType type) {
  std::vector<std::string_view> keys = {"center", "power", "color", "name"};
  if (type != LightType::point && type != LightType::sphere) keys.push_back("target");
  if (type == LightType::rect) keys.insert(keys.end(), {"size", "roll"});
  if (type == LightType::disk || type == LightType::sphere) keys.push_back("radius");
  if (type == LightType::spot) keys.insert(keys.end(), {"inner", "outer"});
  return keys;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

Result<Light> parse_light(std::string_view value, std::string_view place) {
  const auto pieces = split(value, ',');
  Light light;
  if (!light_type_from_name(pieces[0], light.type))
    return fail(ErrorKind::usage, "", place, "a light that starts with rect, disk, sphere, point, spot or directional",
                quoted(pieces[0]));
  OptionReader reader(place);
  reader.read(pieces, 1);
  const auto keys = keys_of(light.type);
  reader.allow(keys);

  // What every type has.
  light.name = reader.has("name") ? reader.text("name") : std::string(name_of(light.type));
  light.center = reader.vector("center");
  light.power = reader.number("power", 0, kMaxPower, "watts");
  light.color = reader.has("color") ? reader.color("color") : vec3(1);

  // What only some have.
  const bool aims = std::find(keys.begin(), keys.end(), "target") != keys.end();
  if (aims) {
    light.target = reader.vector("target");
    if (light.target == light.center) reader.refuse("target", "a point away from center", "the same point");
  }
  if (light.type == LightType::rect) {
    light.size = reader.sides("size");
    if (reader.has("roll")) light.roll_degrees = reader.number("roll", -kMaxRoll, kMaxRoll, "degrees");
  }
  if (light.type == LightType::disk || light.type == LightType::sphere)
    light.radius = reader.number("radius", kMinLength, kMaxCoordinate, "a length");
  if (light.type == LightType::spot) {
    if (reader.has("inner")) light.inner_degrees = reader.number("inner", 0, 90, "degrees");
    if (reader.has("outer")) light.outer_degrees = reader.number("outer", 0, 90, "degrees");
    if (!(light.outer_degrees > light.inner_degrees))
      reader.refuse("outer", fmt::format("degrees above inner ({:g})", light.inner_degrees),
                    fmt::format("{:g}", light.outer_degrees));
  }
  if (reader.error()) return tl::unexpected(*reader.error());
  return light;
}

Result<Camera> parse_camera(std::string_view value, std::string_view place) {
  OptionReader reader(place);
  reader.read(split(value, ','), 0);
  reader.allow({"eye", "target", "fov", "up"});
  Camera camera;
  camera.eye = reader.vector("eye");
  camera.target = reader.vector("target");
  camera.fov_degrees = reader.number("fov", kMinFovDegrees, kMaxFovDegrees, "degrees");
  if (reader.has("up")) {
    camera.up = reader.vector("up");
    if (camera.up == vec3(0)) reader.refuse("up", "a direction", "0,0,0");
  }
  if (camera.eye == camera.target) reader.refuse("target", "a point away from eye", "the same point");
  if (reader.error()) return tl::unexpected(*reader.error());
  return camera;
}

Result<vec3> parse_color(std::string_view value, std::string_view place) {
  const std::string_view text = trimmed(value);
  const auto refuse = [&] {
    return fail(ErrorKind::usage, "", place, "r,g,b (linear, 0 or more) or #rrggbb (sRGB)", quoted(value));
  };
  vec3 color(0);
  if (!text.empty() && text.front() == '#') {
    if (text.size() != 7) return refuse();
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<size_t>(1 + 2 * i);
      const int high = hex_digit(text[at]), low = hex_digit(text[at + 1]);
      if (high < 0 || low < 0) return refuse();
      color[i] = srgb_decode(static_cast<float>(high * 16 + low) / 255.0f);
    }
    return color;
  }
  const auto pieces = split(text, ',');
  if (pieces.size() != 3) return refuse();
  for (int i = 0; i < 3; ++i)
    if (!number_from(pieces[static_cast<size_t>(i)], color[i]) || color[i] < 0 || color[i] > kMaxColor) return refuse();
  return color;
}

Result<uvec2> parse_size(std::string_view value, std::string_view place) {
  const auto pieces = split(value, 'x');
  uvec2 size(0);
  bool good = pieces.size() == 2;
  for (int i = 0; good && i < 2; ++i) {
    const std::string_view piece = pieces[static_cast<size_t>(i)];
    const auto [end, code] = std::from_chars(piece.data(), piece.data() + piece.size(), size[i]);
    good = code == std::errc() && end == piece.data() + piece.size() && size[i] >= 1 && size[i] <= kMaxPictureSide;
  }
  if (good) return size;
  return fail(ErrorKind::usage, "", place, fmt::format("WxH, each from 1 to {} pixels", kMaxPictureSide),
              quoted(value));
}

}  // namespace vamp
