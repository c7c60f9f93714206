#include "bench/window/drags.h"

#include <chrono>
#include <functional>
#include <random>
#include <thread>

namespace vamp {
namespace {

constexpr double kAnswer = 3;  // s: later there is none
constexpr int kReach = 5;      // steps of a slider to either side
constexpr int kLine = 40;      // pixels at the picture's upper edge that the status line may take

void sleep_ms(double ms) { std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(ms)); }

// Moves on in one direction and then back, `reach` steps each.
class ToAndFro {
 public:
  explicit ToAndFro(int reach) : reach_(reach) {}
  int next() {
    if (std::abs(at_ + way_) > reach_) way_ = -way_;
    return at_ += way_;
  }

 private:
  int reach_, at_ = 0, way_ = 1;
};

Result<Answers> measure(EditorWindow& window, int rounds, bool summed, const std::function<void()>& move) {
  Answers answers;
  Screen& screen = window.screen();
  std::mt19937 random(1);
  for (int round = -kWarmRounds; round < rounds; ++round) {
    const auto done = [&](const Json& told) {
      return told.value("finished", false) && (!summed || told.value("weights_ready", false));
    };
    if (!window.waits_for(done, 60) || !screen.wait_for_rest(0.15, 20))
      return fail(ErrorKind::failed, "vamp edit", "", "a finished picture that rests", "none after a minute");
    // Anywhere between two frames of the window.
    sleep_ms(std::uniform_real_distribution<double>(0, 60)(random));
    screen.remember();
    const auto moved = Clock::now();
    move();
    const Screen::Seen seen = screen.wait_for_change(kAnswer);
    if (round < 0) continue;
    if (seen.changed) {
      answers.ms.push_back(1e3 * std::chrono::duration<double>(seen.at - moved).count());
    } else if (++answers.unanswered > rounds / 2) {
      return fail(ErrorKind::failed, "vamp edit", "", "changed pixels after the mouse has moved",
                  "none in half of the rounds");
    }
  }
  window.waits_for([](const Json& told) { return told.value("finished", false); }, 60);
  const Area view = window.viewport();
  const Json& told = window.told();
  answers.pixels = (told.value("restarted", 0.0) + told.value("recombined", 0.0)) / (view.width * view.height);
  return answers;
}

}  // namespace

void watch_picture(Screen& screen, const Area& picture, std::vector<Area> except) {
  except.push_back({picture.x, picture.y, picture.width, kLine});
  screen.watch(picture, std::move(except));
}

Result<Answers> pull(EditorWindow& window, const Area& slider, int rounds, bool summed) {
  Mouse& mouse = window.screen().mouse();
  watch_picture(window.screen(), window.viewport());
  const int x = slider.x + slider.width / 2, y = slider.y + slider.height / 2;
  const int step = std::max(slider.width / 40, 3);  // more than what a click may tremble
  ToAndFro place(kReach);
  mouse.move(x, y);
  sleep_ms(200);
  mouse.press(Mouse::kLeft);
  sleep_ms(200);
  Result<Answers> answers = measure(window, rounds, summed, [&] { mouse.move(x + step * place.next(), y); });
  mouse.release(Mouse::kLeft);
  sleep_ms(200);
  return answers;
}

Result<Answers> turn(EditorWindow& window, int rounds) {
  constexpr int kStep = 6, kPointer = 24;  // pixels: of a move; around the pointer, which is drawn into the picture
  Mouse& mouse = window.screen().mouse();
  const Area view = window.viewport();
  const int x = view.x + view.width / 2, y = view.y + view.height / 2, reach = kReach * kStep + kPointer;
  watch_picture(window.screen(), view, {{x - reach, y - kPointer, 2 * reach, 2 * kPointer}});
  ToAndFro place(kReach);
  mouse.move(x, y);
  sleep_ms(200);
  mouse.press(Mouse::kRight);
  sleep_ms(200);
  Result<Answers> answers = measure(window, rounds, false, [&] { mouse.move(x + kStep * place.next(), y); });
  mouse.release(Mouse::kRight);
  sleep_ms(200);
  return answers;
}

}  // namespace vamp
