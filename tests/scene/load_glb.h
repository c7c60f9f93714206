#pragma once
// Loading a model that a test has just made.
#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/scene/scene.h"
#include "tests/scene/glb_builder.h"

namespace vamp::test {

// A folder of its own, gone at the end.
class TempFolder {
 public:
  TempFolder() {
    std::string name = (fs::temp_directory_path() / "vamp-scene-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  ~TempFolder() {
    std::error_code code;
    fs::remove_all(path_, code);
  }
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

inline Result<std::shared_ptr<const Scene>> load(const GlbBuilder& builder, const std::string& name = "model.glb") {
  const TempFolder folder;
  builder.write(folder / name);
  return load_scene(folder / name);
}

// The scene, or a failed test and an empty one.
inline std::shared_ptr<const Scene> loaded(const GlbBuilder& builder, const std::string& name = "model.glb") {
  auto scene = load(builder, name);
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().message());
  return scene ? *scene : std::make_shared<const Scene>();
}

}  // namespace vamp::test
