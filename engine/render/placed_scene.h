#pragma once
// The tables of a scene whose parts may stand elsewhere than the model has them. They follow from where the parts stand
// now, never from how they got there, so that a picture after any moves is that of a fresh render: the tree of the
// parts as the model has them, made to fit; or, where that has become too bad, a tree made anew.
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/project/project.h"
#include "engine/render/scene_tables.h"

namespace vamp {

// Rows of the tables that a move has changed, besides all boxes.
struct MovedRows {
  std::vector<std::pair<uint32_t, uint32_t>> triangles;  // ranges [first, first + count) in the order of the tree
  bool turned = false;                                   // their surface records too
};

class PlacedScene {
 public:
  // Its visible parts, where they stand. Takes a while: a tree is made.
  explicit PlacedScene(const Project& project);

  // Follows the project, of which no more than places has changed; some milliseconds. tables() may be others then.
  MovedRows place(const Project& project);

  // Whether rays would be faster in a tree made anew, by so much that making it pays.
  bool wants_tree() const;
  // Makes it. tables() are others then.
  void make_tree();

  // In the order of their tree. Whoever reads them on another thread holds SceneTables::moving.
  std::shared_ptr<const SceneTables> tables() const { return remade_ ? remade_ : refitted_; }

 private:
  std::shared_ptr<const Scene> scene_;
  std::vector<bool> visible_;
  std::vector<Placement> places_;
  std::vector<RigidMotion> motions_;
  double rest_cost_ = 0, cost_ = 0;                 // of the refitted tree, when nothing was moved and now
  std::shared_ptr<SceneTables> refitted_, remade_;  // remade_: null while the refitted ones serve
};

}  // namespace vamp
