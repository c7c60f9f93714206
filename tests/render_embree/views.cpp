#include "tests/render_embree/views.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>

#include "engine/project/project_file.h"
#include "tests/render/scenes.h"

namespace vamp {
namespace {

// Spheres that cut each other, from finely to coarsely tessellated (shading normals far from the faces), boxes that cut
// them, and blades a hundredth of a pixel to a pixel wide.
std::shared_ptr<const Scene> bumps() {
  SceneBuilder scene;
  scene.add_quad("floor", {-6, 0, 6}, {12, 0, 0}, {0, 0, -12});
  scene.add_sphere("ball", {0, 1, 0}, 1, 96);
  for (int i = 0; i < 120; ++i) {
    // Golden-angle points of the ball.
    const float k = (static_cast<float>(i) + 0.5f) / 120, phi = 2.39996f * static_cast<float>(i);
    const float y = 1 - 2 * k, r = std::sqrt(1 - y * y);
    scene.add_sphere("bumps", vec3(0, 1, 0) + vec3(r * std::cos(phi), y, r * std::sin(phi)),
                     0.04f + 0.1f * std::fmod(0.618034f * static_cast<float>(i), 1.0f), 6 + i % 8);
  }
  scene.add_sphere("coarse", {1.6f, 0.55f, 0.6f}, 0.6f, 5);
  scene.add_box("box", {-1.9f, -0.1f, -0.4f}, {-0.8f, 0.7f, 0.5f});
  scene.add_box("plate", {-1.7f, 0.7f, -0.3f}, {-0.2f, 0.71f, 0.9f});
  for (int i = 0; i < 160; ++i) {
    const float x = -2.2f + 0.03f * static_cast<float>(i), width = 1e-4f * std::pow(1.03f, static_cast<float>(i));
    const float lean = 0.3f * std::sin(static_cast<float>(7 * i));
    scene.add_quad("blades", {x, 0, 1.5f + 0.4f * std::cos(static_cast<float>(3 * i))}, {width, 0, 0.3f * width},
                   {lean, 0.5f + lean * lean, 0.2f});
  }
  return scene.build();
}

std::shared_ptr<const Scene> shelves() {
  SceneBuilder scene;
  scene.add_quad("floor", {-4, 0, 4}, {8, 0, 0}, {0, 0, -8});
  scene.add_quad("wall", {-4, 0, -1}, {8, 0, 0}, {0, 5, 0});
  for (int row = 0; row < 4; ++row) {
    const float y = 0.6f * static_cast<float>(row);
    scene.add_box("shelf", {-2, y + 0.5f, -1}, {2, y + 0.53f, 0});
    for (int i = 0; i < 14; ++i) {
      const float x = -1.9f + 0.28f * static_cast<float>(i), h = 0.15f + 0.02f * static_cast<float>((5 * i + row) % 13);
      if ((i + row) % 3 == 0)
        scene.add_sphere("balls", {x, y + 0.12f, -0.4f}, 0.12f, 8 + 2 * i);
      else
        scene.add_box("books", {x - 0.1f, y, -0.7f}, {x + 0.1f, y + h, -0.1f - 0.03f * static_cast<float>(i % 4)});
    }
  }
  return scene.build();
}

Camera look(vec3 eye, vec3 target, float fov_degrees) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.fov_degrees = fov_degrees;
  return camera;
}

View view_of(const std::string& name, const Scene& opened, const Camera& camera) {
  auto scene = std::make_shared<Scene>(opened);
  for (Part& part : scene->parts) {
    part.material = {};
    part.material.name = part.name;
    part.material.metallic = 0;
    part.material.roughness = 1;
  }
  View view{name, dark_project(scene)};
  Project& project = view.project;
  project.camera = camera;
  project.settings.pixel_centres = true;
  project.settings.seed = 7;
  // In proportion to what the camera looks at; the floors are far larger.
  const float distance = glm::length(camera.eye - camera.target);
  project.settings.ao_radius = 0.3f * distance;
  // Low and from both sides, so that long shadows fall into the picture.
  Light rect;
  rect.type = LightType::rect;
  rect.center = camera.target + distance * vec3(0.6f, 0.35f, 0.05f);
  rect.target = camera.target;
  rect.size = distance * vec2(0.35f, 0.2f);
  Light sphere;
  sphere.type = LightType::sphere;
  sphere.center = camera.target + distance * vec3(-0.6f, 0.25f, 0.35f);
  sphere.radius = 0.1f * distance;
  project.lights = {rect, sphere};
  return view;
}

}  // namespace

Result<View> make_view(int number) {
  if (number == 1) return view_of("bumps", *bumps(), look({1.2f, 2.4f, 4.6f}, {0, 0.8f, 0.2f}, 38));
  std::filesystem::path file = "scenes/derby.glb";
  if (number == 2) {
    const char* data = std::getenv("VAMP_TEST_DATA");
    file = data != nullptr ? std::filesystem::path(data) / "shoe" / "shoe.gltf" : "";
    if (!std::filesystem::exists(file))
      return view_of("shelves", *shelves(), look({1.5f, 1.9f, 3.4f}, {0, 1.1f, -0.4f}, 45));
  }
  VAMP_TRY(const Project opened, open_scene(file));
  // The shoe comes without a camera; the one that fits every model leaves it small.
  Camera camera = opened.camera;
  if (opened.scene->cameras.empty()) camera.fov_degrees *= 0.6f;
  return view_of(file.stem().string(), *opened.scene, camera);
}

}  // namespace vamp
