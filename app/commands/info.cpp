#include "app/commands/info.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "app/commands/command.h"
#include "engine/core/text.h"

namespace vamp {
namespace {

Result<Json> info_of(const fs::path& path) {
  std::error_code code;
  if (!fs::exists(path, code)) return fail(ErrorKind::bad_input, path.string(), "", "a file", "nothing there");
  if (fs::is_directory(path, code)) {
    // Both kinds of folder may be damaged; a preset has this file, pictures lie about without it.
    const bool pictures = !fs::exists(path / "material.json", code) && !fs::exists(path / "tables.bin", code);
    return pictures ? btf_info(path) : preset_info(path);
  }
  const std::string extension = lower_extension(path);
  if (extension == ".glb" || extension == ".gltf") return model_info(path);
  if (extension == ".vampproj") return project_info(path);
  if (extension == ".vamp") return preset_info(path);
  for (const char* picture : {".png", ".jpg", ".jpeg", ".exr", ".hdr"})
    if (extension == picture) return picture_info(path);
  for (const char* measured : {".btf", ".lp", ".ptm", ".bin"})
    if (extension == measured) return btf_info(path);
  return fail(
      ErrorKind::bad_input, path.string(), "",
      "a model (.glb, .gltf), project (.vampproj), preset (.vamp or a folder), picture (.png, .jpg, .exr, .hdr) "
      "or BTF (.btf, .lp, .ptm or a folder)",
      extension.empty() ? "a name without an extension" : "\"" + extension + "\"");
}

std::string plain(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  return value.is_null() ? "none" : value.dump();
}

// One line where nothing is nested: "a, b, c" or "key value, key value".
std::string on_one_line(const Json& value) {
  std::string text;
  for (const auto& [key, item] : value.items()) {
    if (!text.empty()) text += ", ";
    if (value.is_object()) text += key + " ";
    text += item.is_structured() ? "(" + on_one_line(item) + ")" : plain(item);
  }
  return text.empty() ? "none" : text;
}

// The JSON for people: a line a member; a list of objects gets a line each.
std::string as_text(const Json& json) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    const bool list = value.is_array() && !value.empty() && value.front().is_object();
    std::string label = key;
    std::replace(label.begin(), label.end(), '_', ' ');
    text += fmt::format("{}: {}\n", label,
                        list                    ? std::to_string(value.size())
                        : value.is_structured() ? on_one_line(value)
                                                : plain(value));
    if (!list) continue;
    for (const Json& item : value) text += "  " + on_one_line(item) + "\n";
  }
  return text;
}

}  // namespace

Status print_info(const fs::path& path, bool as_json) {
  VAMP_TRY(const Json json, info_of(path));
  fmt::print("{}", as_json ? print_json(json) : as_text(json));
  return {};
}

void add_info(CLI::App& app, CommonOptions& common, Action& action) {
  auto file = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("info", "Say what is in a model, project, preset, picture or BTF");
  verb->add_option("file", *file, "The file, or the folder of a preset or of pictures")->type_name("FILE")->required();
  verb->add_flag("--json", common.json, "Print it as JSON");
  verb->callback([file, &common, &action] { action = [file, &common] { return print_info(*file, common.json); }; });
}

}  // namespace vamp
