#pragma once
// What is in an autosave: a project with its paths as they are on this machine, and where the document belongs.
#include <filesystem>

#include "editor/model/document.h"

namespace vamp {

struct AutosaveContent {
  ProjectPtr project;
  std::filesystem::path document;
};

std::filesystem::path default_autosave_folder();  // state_dir() / "autosave"

Status write_autosave(const AutosaveContent& content, const std::filesystem::path& path);

}  // namespace vamp
