#include "tests/render/edit_sequences.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vamp::test {

Project two_materials() {
  SceneBuilder scene;
  scene.add_quad("floor", {-2, -0.6f, 2}, {4, 0, 0}, {0, 0, -4});
  scene.add_sphere("ball", vec3(0), 0.6f, 24);
  scene.add_sphere("pearl", {0.9f, -0.3f, 0.3f}, 0.3f, 16);
  Project project = dark_project(scene.build());
  put_material(project, "ball", make_rich_material(7));
  put_material(project, "pearl", make_rich_material(8));
  Light key;
  key.type = LightType::rect;
  key.center = vec3(1, 2, 1);
  key.target = vec3(0);
  key.power = 30;
  project.lights = {key};
  project.ambient = vec3(0.2f);
  project.camera.eye = vec3(0.5f, 0.8f, 3);
  project.camera.target = vec3(0.1f, 0, 0);
  project.camera.fov_degrees = 35;
  return project;
}

void EditedPicture::show(Renderer& renderer, const Project& project) {
  const Result<Change> change = renderer.set_project(std::make_shared<const Project>(project));
  ASSERT_TRUE(change) << change.error().message();
  last = *change;
}

// As the window does when the hand rests.
void EditedPicture::settle(Renderer& renderer) {
  if (!renderer.wants_tree()) return;
  ++trees;
  ASSERT_TRUE(renderer.make_tree());
}

std::vector<float> EditedPicture::finish(Renderer& renderer, uint32_t samples) {
  settle(renderer);
  uint64_t value = 0;
  while (renderer.replaying()) value = renderer.replay(700);
  for (int tile = 0; tile < renderer.tile_count(); ++tile)
    while (renderer.samples_of(tile) < samples) value = renderer.refine(tile, samples);
  return renderer.linear_picture(std::max(value, device->last_submitted()));
}

std::vector<float> EditedPicture::fresh(const Project& project, uint32_t samples) {
  if (!fresh_) fresh_ = std::make_unique<Renderer>(*device);
  show(*fresh_, project);
  fresh_->set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  return finish(*fresh_, samples);
}

namespace {

void edit_at_random(Project& project, std::mt19937& random) {
  const auto unit = [&] { return static_cast<float>(random() % 1000) / 1000.0f; };
  // The last two are the measured ones.
  MaterialInstance& material = project.materials[project.materials.size() - 1 - random() % 2];
  const int cluster = static_cast<int>(random() % material.fit->clusters.size());
  const int basis = static_cast<int>(random() % material.fit->dictionary.size());
  BasisEdit edit;
  switch (random() % 8) {
    case 0:
    case 1:
      edit.gain = vec3(unit(), 2 * unit(), unit());
      material.edits.set({cluster, basis}, edit);
      break;
    case 2:
    case 3: {
      const float tilt = 0.6f * unit();
      edit.normal = vec3(tilt, 0, std::sqrt(1 - tilt * tilt));
      edit.psi = unit();
      material.edits.set({cluster, basis}, edit);
      break;
    }
    case 4:
      material.edits.residual_terms = static_cast<int>(random() % 5);
      break;
    case 5:
      project.parts[1].texture_rotation = unit();
      break;
    case 6:
      std::swap(project.parts[1].material, project.parts[2].material);
      break;
    case 7:
      project.lights[0].power = 10 + 20 * unit();
      break;
  }
}

// A little, or through other parts and beyond the scene; back to where it was; hidden and shown.
void move_at_random(Project& project, std::mt19937& random) {
  const auto unit = [&] { return static_cast<float>(random() % 2001) / 1000.0f - 1; };
  PartState& part = project.parts[random() % project.parts.size()];
  switch (random() % 6) {
    case 0:
      part.place.offset += 0.05f * vec3(unit(), unit(), unit());
      break;
    case 1:
    case 5:
      part.place.offset = 2.0f * vec3(unit(), unit(), unit());
      break;
    case 2:
      part.place.turn = 3.0f * vec3(unit(), unit(), unit());
      break;
    case 3:
      part.place = {};
      break;
    case 4:
      part.visible = !part.visible;
      break;
  }
}

// A function in one cluster, or in all of them.
WeightGroup rows_at_random(const Project& project, std::mt19937& random) {
  WeightGroup group;
  group.material = static_cast<int>(project.materials.size() - 1 - random() % 2);
  const Spmm& fit = *project.materials[static_cast<size_t>(group.material)].fit;
  const int basis = static_cast<int>(random() % fit.dictionary.size());
  const bool everywhere = random() % 2 == 0;
  const int only = static_cast<int>(random() % fit.clusters.size());
  for (int c = 0; c < static_cast<int>(fit.clusters.size()); ++c)
    if (everywhere || c == only) group.rows.push_back({c, basis});
  return group;
}

// As the weight row of the editor: brighter or darker, tinted, or muted.
void pull_weights(Project& project, const WeightGroup& group, std::mt19937& random) {
  const auto unit = [&] { return static_cast<float>(random() % 1000) / 1000.0f; };
  const uint32_t how = random() % 3;
  const vec3 gain = how == 0 ? vec3(2 * unit()) : vec3(unit(), 2 * unit(), unit());
  EditLayer& edits = project.materials[static_cast<size_t>(group.material)].edits;
  for (const BasisKey key : group.rows) {
    BasisEdit edit = edits.edit_of(key);
    edit.gain = gain;
    edit.mute = how == 2 && gain.x < 0.5f;
    edits.set(key, edit);
  }
}

}  // namespace

void EditedPicture::run(const Sequence& sequence) {
  std::mt19937 random(sequence.seed);
  Project project = two_materials();
  project.parts[0].mirror_f0 = sequence.mirror;
  if (!edited_) {
    edited_ = std::make_unique<Renderer>(*device);
    edited_->make_trees_later();
  }
  Renderer& renderer = *edited_;
  renderer.set_weights_at_hand({});
  renderer.set_history(sequence.history);
  show(renderer, project);
  renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  WeightGroup group;
  bool exact = true;
  std::vector<float> brightest;
  const uint32_t first = random() % 8;
  settle(renderer);
  for (int tile = 0; tile < renderer.tile_count(); ++tile)
    while (renderer.samples_of(tile) < first) renderer.refine(tile, first);
  for (int step = 0; step < 32; ++step) {
    const uint32_t what = random() % 6;
    if (sequence.moves && random() % 3 == 0) {
      // A drag: first looks alone until the hand rests.
      for (uint32_t i = random() % 4; i < 4; ++i) {
        move_at_random(project, random);
        show(renderer, project);
        if (last.restarted && !renderer.replaying()) renderer.preview(2 + random() % 3);
      }
      settle(renderer);
    } else if (what < 2) {
      const bool weights = !group.rows.empty() && random() % 4 != 0;
      if (weights)
        pull_weights(project, group, random);
      else
        edit_at_random(project, random);
      show(renderer, project);
      EXPECT_FALSE(step > 0 && last.restarted && !sequence.moves) << last.what;
      if (last.recombined > 0) {
        ++recombined;
        exact = false;
        // What a pull takes away is what its rounding is measured by.
        const std::vector<float> now = renderer.linear_picture(device->last_submitted());
        brightest.resize(now.size());
        for (size_t i = 0; i < now.size(); ++i) brightest[i] = std::max(brightest[i], std::abs(now[i]));
      }
    } else if (sequence.weights && what == 2) {
      group = rows_at_random(project, random);
      renderer.set_weights_at_hand(group);
    } else if (sequence.weights && what == 3 && !renderer.replaying()) {
      // To the end, or a part of the way.
      const uint32_t most = random() % 2 == 0 ? 1u << 20 : 1 + random() % 2000;
      for (int i = 0; renderer.wants_weights(true) && (most > 2000 || i < 20); ++i) renderer.gather_weights(true, most);
    } else if (renderer.replaying()) {
      const bool all = random() % 2 == 0;
      do renderer.replay(1 + random() % 3000);
      while (all && renderer.replaying());
    } else {
      // One tile, or all of them once.
      const int tiles = renderer.tile_count();
      const int only = static_cast<int>(random() % static_cast<uint32_t>(2 * tiles));
      for (int tile = 0; tile < tiles; ++tile)
        if (only >= tiles || tile == only) renderer.refine(tile, 10);
    }
  }
  const std::vector<float> want = fresh(project, 10), have = finish(renderer, 10);
  if (exact)
    EXPECT_TRUE(same_bytes(want, have)) << "sequence " << sequence.seed;
  else
    EXPECT_LT(largest_difference(want, have, brightest), 1e-5) << "sequence " << sequence.seed;
}

bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b, const std::vector<float>& before) {
  EXPECT_EQ(a.size(), b.size());
  double mean = 0;
  for (const float x : a) mean += std::abs(double{x}) / static_cast<double>(a.size());
  double largest = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const double size = std::max({std::abs(double{a[i]}), std::abs(double{b[i]}), std::abs(double{before[i]})});
    largest = std::max(largest, std::abs(double{a[i]} - double{b[i]}) / (size + 0.01 * mean));
  }
  return largest;
}

}  // namespace vamp::test
