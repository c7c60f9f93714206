#pragma once
// Small projects and presets for tests, and a folder that goes away.
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/project/project.h"

namespace vamp::test {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "vamp-test-XXXXXX").string();
    path_ = std::filesystem::canonical(::mkdtemp(name.data()));
  }
  ~TemporaryFolder() {
    std::error_code code;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, code);
    std::filesystem::remove_all(path_, code);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Home folders of the program inside a temporary folder, for as long as this lives.
class TemporaryHome {
 public:
  TemporaryHome() {
    ::setenv("XDG_CONFIG_HOME", (folder_.path() / "config").c_str(), 1);
    ::setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
    ::setenv("XDG_DATA_HOME", (folder_.path() / "data").c_str(), 1);
    ::setenv("XDG_CACHE_HOME", (folder_.path() / "cache").c_str(), 1);
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

// A model of three boxes, "vamp", "sole" and "lace", without lights and cameras, as a .glb.
void write_model(const std::filesystem::path& path);

// Two clusters and three functions (Lambert, Cook-Torrance, Ashikhmin-Shirley) over 4 x 4 texels.
std::shared_ptr<const Spmm> small_fit(float brightness = 0.5f);
Preset small_preset(const std::string& name, float brightness = 0.5f);

// A scene in memory with the same three parts, and a project whose first part shows small_fit().
Project small_project();

}  // namespace vamp::test
