#include "editor/model/settings.h"

#include <algorithm>
#include <array>
#include <functional>

#include "engine/core/files.h"
#include "engine/core/json.h"
#include "engine/core/log.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxBytes = 4 << 20;
constexpr size_t kMaxLayoutPiece = 4096;  // JSON strings of ours are no longer: a layout is written in pieces
constexpr size_t kMaxLayoutPieces = 256;
constexpr int kMaxPixels = 1 << 16;
constexpr std::array<std::string_view, 3> kThemes = {"dark", "light", "high_contrast"};

fs::path settings_path(const fs::path& file) { return file.empty() ? config_dir() / "settings.json" : file; }

// Reads members one by one, each with its own error, so that one damaged value costs no other.
class Members {
 public:
  Members(const Json& json, std::string file, std::string& problem)
      : json_(json), file_(std::move(file)), problem_(problem) {}

  template <class Read>
  void read(std::string_view key, Read read) {
    const JsonReader reader(json_, file_);
    if (!reader.has(key)) return;  // written by an earlier version: the default serves
    read(reader.member(key));
    if (const Status status = reader.status(); !status && problem_.empty()) problem_ = status.error().message();
  }

  // A value that is used only if it could be read.
  template <class Value>
  void value(std::string_view key, Value& value, const std::function<Value(const JsonReader&)>& from) {
    read(key, [&](const JsonReader& reader) {
      Value found = from(reader);
      if (reader.status()) value = std::move(found);
    });
  }
  void flag(std::string_view key, bool& target) {
    value<bool>(key, target, [](const JsonReader& reader) { return reader.boolean(); });
  }
  void integer(std::string_view key, int& target, int low, int high) {
    value<int>(key, target, [=](const JsonReader& reader) { return static_cast<int>(reader.integer(low, high)); });
  }
  void text(std::string_view key, std::string& target) {
    value<std::string>(key, target, [](const JsonReader& reader) { return reader.text(); });
  }

 private:
  const Json& json_;
  std::string file_;
  std::string& problem_;
};

Theme theme_from(const JsonReader& reader) {
  const std::string name = reader.text(64);
  const auto found = std::find(kThemes.begin(), kThemes.end(), name);
  if (found == kThemes.end()) reader.refuse("dark, light or high_contrast", "\"" + name + "\"");
  return found == kThemes.end() ? Theme::dark : static_cast<Theme>(found - kThemes.begin());
}

std::string layout_from(const JsonReader& reader) {
  std::string layout;
  for (size_t i = 0, count = reader.size(kMaxLayoutPieces); i < count; ++i) layout += reader.element(i).text();
  return layout;
}

// Cuts between UTF-8 characters.
Json layout_to_json(const std::string& layout) {
  Json pieces = Json::array();
  for (size_t begin = 0; begin < layout.size();) {
    size_t end = std::min(layout.size(), begin + kMaxLayoutPiece);
    while (end < layout.size() && end > begin + 1 && (static_cast<unsigned char>(layout[end]) & 0xc0u) == 0x80u) --end;
    pieces.push_back(layout.substr(begin, end - begin));
    begin = end;
  }
  return pieces;
}

Settings read_members(const Json& json, const std::string& file, std::string& problem) {
  Settings settings;
  Members members(json, file, problem);
  members.value<float>("ui_scale", settings.ui_scale, [](const JsonReader& reader) {
    const float scale = reader.number(0, 4);
    if (scale > 0 && scale < 0.5f) reader.refuse("0 or a number from 0.5 to 4", std::to_string(scale));
    return scale;
  });
  members.value<Theme>("theme", settings.theme, theme_from);
  members.value<std::string>("layout", settings.layout, layout_from);
  members.integer("layout_version", settings.layout_version, 0, 1 << 20);
  members.text("device", settings.device);
  members.value<WindowPlace>("window", settings.window, [](const JsonReader& reader) {
    WindowPlace place;
    const auto pixels = [&](const char* key, int low) {
      return static_cast<int>(reader.member(key).integer(low, kMaxPixels));
    };
    place.x = pixels("x", -kMaxPixels);
    place.y = pixels("y", -kMaxPixels);
    place.width = pixels("width", 64);
    place.height = pixels("height", 64);
    place.maximized = reader.member("maximized").boolean();
    place.placed = reader.member("placed").boolean();
    return place;
  });
  members.flag("reopen_last", settings.reopen_last);
  members.flag("reduced_motion", settings.reduced_motion);
  members.text("last_folder", settings.last_folder);
  return settings;
}

}  // namespace

LoadedSettings load_settings(const fs::path& file) {
  const fs::path path = settings_path(file);
  LoadedSettings loaded;
  std::error_code code;
  if (!fs::exists(path, code)) return loaded;
  const auto give_up = [&](const Error& error) {
    fs::path aside = path;
    fs::rename(path, aside += ".damaged", code);
    loaded.problem = error.message() + "; the defaults are used";
    if (!code) loaded.problem += ", the old file is now " + aside.string();
    spdlog::warn("{}", loaded.problem);
    return loaded;
  };
  const auto text = read_text(path, kMaxBytes);
  if (!text) return give_up(text.error());
  const auto json = parse_json(*text, path.string());
  if (!json) return give_up(json.error());
  if (!json->is_object())
    return give_up(Error{ErrorKind::bad_input, path.string(), "", "an object", json->type_name()});
  loaded.settings = read_members(*json, path.string(), loaded.problem);
  if (!loaded.problem.empty()) spdlog::warn("{}; the default is used", loaded.problem);
  return loaded;
}

Status save_settings(const Settings& settings, const fs::path& file) {
  const fs::path path = settings_path(file);
  Json json;
  json["ui_scale"] = json_number(settings.ui_scale);
  json["theme"] = kThemes[static_cast<size_t>(settings.theme)];
  json["layout"] = layout_to_json(settings.layout);
  json["layout_version"] = settings.layout_version;
  json["device"] = settings.device;
  const WindowPlace& window = settings.window;
  json["window"] = {{"x", window.x},
                    {"y", window.y},
                    {"width", window.width},
                    {"height", window.height},
                    {"maximized", window.maximized},
                    {"placed", window.placed}};
  json["reopen_last"] = settings.reopen_last;
  json["reduced_motion"] = settings.reduced_motion;
  json["last_folder"] = settings.last_folder;
  std::error_code code;
  fs::create_directories(path.parent_path(), code);
  return write_text_atomically(path, print_json(json));
}

WindowPlace clamp_to_monitor(const WindowPlace& place, int left, int top, int width, int height) {
  constexpr int kSeen = 100;  // pixels of the title bar that must stay in reach
  WindowPlace clamped = place;
  clamped.width = std::clamp(place.width, std::min(320, width), std::max(width, 1));
  clamped.height = std::clamp(place.height, std::min(240, height), std::max(height, 1));
  clamped.x = std::clamp(place.x, left - clamped.width + kSeen, std::max(left, left + width - kSeen));
  clamped.y = std::clamp(place.y, top, std::max(top, top + height - kSeen));
  return clamped;
}

}  // namespace vamp
