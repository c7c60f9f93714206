#include "engine/project/default_project.h"

#include <array>
#include <string_view>

#include "engine/core/files.h"
#include "engine/core/log.h"
#include "engine/project/project_file.h"

namespace vamp {
namespace {

struct Dressed {
  std::string_view preset;
  std::array<std::string_view, 8> parts;
};
constexpr std::array kDressed{
    Dressed{"calf", {"Vamp", "Toe cap", "Quarter", "Heel counter", "Tongue", "Pull tab"}},
    Dressed{"twill", {"Collar", "Lining", "Insole"}},
};

}  // namespace

Result<Project> default_project() {
  const fs::path scenes = shipped_dir("scenes");
  if (scenes.empty())
    return fail(ErrorKind::bad_input, "scenes", "", "the program's own scenes beside it (VAMP_DATA says where)",
                "none");
  VAMP_TRY(Project project, open_scene(scenes / "derby.glb"));
  const fs::path presets = shipped_dir("presets");
  for (const Dressed& dressed : kDressed) {
    const fs::path path = presets / (std::string(dressed.preset) + ".vamp");
    const Result<Preset> preset = load_preset(path);
    if (!preset) {
      spdlog::warn("{}", preset.error().message());
      continue;
    }
    for (const std::string_view name : dressed.parts)
      if (const int part = name.empty() ? -1 : find_part(project, name); part >= 0)
        assign_preset(project, part, *preset, path.string());
  }
  return project;
}

}  // namespace vamp
