#pragma once
// The open document on disk, seconds after an edit, in case the program or the machine dies. Written by a thread of its
// own from the immutable project: the caller never waits for the disk.
//
// state_dir()/autosave holds for each running session "<id>.lock", locked (flock) for as long as its process lives, and
// "<id>.json" while there is something unsaved. A document whose lock nobody holds was left by a crash. Autosaves name
// files by absolute paths: they never leave the machine.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "editor/model/document.h"

namespace vamp {

class Autosave {
 public:
  struct Options {
    std::filesystem::path folder;           // empty: state_dir() / "autosave"
    std::chrono::milliseconds delay{2000};  // from the first unsaved edit to the start of writing
  };
  Autosave() : Autosave(Options{}) {}
  explicit Autosave(Options options);
  // A clean end: what was written is removed. To keep it (the device is lost, the program ends itself), call abandon().
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  // Tells what the document is now: call it after each change, also when it was saved. Cheap. A document that is not
  // dirty has no autosave.
  void update(const Document& document);

  // Writes what is pending now, on the caller's thread. What could not be written stays pending and is tried again
  // after 10 s.
  Status flush();

  // Writes what is pending and leaves it behind for the next start, as a crash would.
  void abandon();

  // Whether the last write succeeded and the document was not saved since: a crash now would leave something behind.
  bool written() const;

  // The last failure to write, once: "the disk is full" is worth telling, not worth stopping for. Empty: none.
  std::string take_problem();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// A document that a session left behind when it died.
struct Leftover {
  std::filesystem::path file;      // the autosave
  std::filesystem::path document;  // the project file it had been loaded from or saved to; may be empty
  std::string model;               // file name of the model, for the list
  int64_t saved_at = 0;            // seconds since 1970
  std::string problem;             // not empty: it cannot be read, and why
};

// Those whose session is gone, the latest first. `folder` as in Autosave::Options. Never fails: what cannot be read is
// listed with its problem.
std::vector<Leftover> find_leftovers(const std::filesystem::path& folder = {});

// The project as it was. The document that it becomes has Leftover::document for its path and is unsaved
// (Document::mark_unsaved). The leftover stays until it is discarded: call that once the document has its own autosave.
Result<Project> recover(const Leftover& leftover);
void discard(const Leftover& leftover);

}  // namespace vamp
