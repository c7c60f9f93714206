#pragma once
// Short messages over the window that go by themselves, and questions that wait for an answer.
#include <imgui.h>

#include <functional>
#include <string>
#include <vector>

namespace vamp::ui {

enum class Notice { info, done, warning, error };

// Shows a message in the lower right corner: infos for 4 s, warnings for 8 s, errors until they are clicked away. The
// same message again only renews it.
void notify(Notice kind, std::string text);
// With a button for what one may want next; it stays for 20 s.
void notify(Notice kind, std::string text, std::string button, std::function<void()> pressed);
void draw_notices(ImVec2 low, ImVec2 high);  // in front of everything, inside this rectangle; once a frame

// Begins a modal dialog in the middle of the window; call end_dialog() where it returned true. Esc or the window's
// close button sets `open` to false. The width is given for 96 dpi, the height follows the content.
bool begin_dialog(const char* title, bool& open, float width);
void end_dialog();

// A question with up to four buttons. The first is the main one (Enter), the last means "leave things as they are"
// (Esc).
class Question {
 public:
  void ask(std::string title, std::string text, std::vector<std::string> buttons, std::function<void(size_t)> answer);
  void draw();  // once a frame
  bool open() const { return open_; }

 private:
  std::string title_;
  std::string text_;
  std::vector<std::string> buttons_;
  std::function<void(size_t)> answer_;
  bool open_ = false;
};

}  // namespace vamp::ui
