#pragma once
// Choosing a file to open or a name to save under.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vamp::ui {

struct FileRequest {
  enum class Mode { open, save, folder } mode = Mode::open;
  std::string title = "Open";
  std::filesystem::path folder;               // where to start; empty or gone: the last one, else home
  std::string name;                           // suggested, when saving
  std::vector<std::string> extensions;        // ".glb"; empty: all files. The first is added to a name without one
  std::vector<std::filesystem::path> places;  // offered at the left besides home and recent folders
  std::function<void(const std::filesystem::path&)> done;  // not called when cancelled
};

// Keyboard: arrows choose, Enter opens, Backspace goes up, typing edits the name (a typed path works too), Esc cancels.
class FileDialog {
 public:
  void open(FileRequest request);
  bool is_open() const { return open_; }
  void draw();  // once a frame

  // The folders that files were chosen in, latest first, for the settings file.
  const std::vector<std::filesystem::path>& recent() const { return recent_; }
  void set_recent(std::vector<std::filesystem::path> folders) { recent_ = std::move(folders); }

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    uint64_t bytes = 0;
  };
  void list();
  void go(const std::filesystem::path& folder);
  void accept();
  void finish(const std::filesystem::path& path);
  void draw_places();
  void draw_entries();
  void draw_footer();
  void handle_keys();

  FileRequest request_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::vector<std::filesystem::path> recent_;
  std::string name_;
  std::string problem_;
  int chosen_ = -1;
  bool open_ = false;
  bool hidden_ = false;   // shows files that start with a dot
  bool confirm_ = false;  // the name exists: asked once, a second acceptance overwrites
  bool focus_name_ = false;
  bool scroll_ = false;
};

// The name with the request's first extension where it has none of them.
std::string with_extension(const std::string& name, const std::vector<std::string>& extensions);

}  // namespace vamp::ui
