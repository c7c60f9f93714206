#include "bench/window/pace.h"

#include <array>
#include <chrono>
#include <thread>

#include "bench/series.h"

namespace vamp {
namespace {

constexpr int kRounds = 5;
constexpr double kPhase = 3;  // s

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

struct Phase {
  double pictures = 0, frames = 0, vertices = 0;  // a second; a second; of the last frame
};

// `hertz`: how often the mouse moves; 0: it rests.
Phase phase(EditorWindow& window, const Area& panel, double hertz) {
  Mouse& mouse = window.screen().mouse();
  const auto count = [&](const char* what) { return window.told().value(what, 0.0); };
  const auto next_frame = [&] {
    const double frames = count("frames");
    window.waits_for([&](const Json& told) { return told.value("frames", 0.0) > frames; }, 2);
    return Clock::now();
  };
  const auto start = next_frame();
  const double pictures = count("pictures"), frames = count("frames");
  for (int moves = 0; seconds_since(start) < kPhase; ++moves) {
    if (hertz > 0) mouse.move(panel.x + panel.width / 2 + moves % 7, panel.y + moves * 29 % panel.height);
    sleep(hertz > 0 ? 1 / hertz : kPhase / 10);
  }
  const double seconds = std::chrono::duration<double>(next_frame() - start).count();
  return {(count("pictures") - pictures) / seconds, (count("frames") - frames) / seconds, count("vertices")};
}

}  // namespace

Result<std::vector<Pace>> measure_paces(EditorWindow& window) {
  // Over many rows of the panel.
  VAMP_TRY(const Area row, window.find("Material", "Weight"));
  const Area panel{row.x, 200, row.width, 600};
  // A pass or two, after which tiles are made as they will be.
  if (!window.waits_for([](const Json& told) { return told.value("samples", 0) >= 8; }, 120))
    return fail(ErrorKind::failed, "vamp edit", "", "8 samples within two minutes", "fewer");
  std::vector<Pace> paces{{"the mouse rests", 0, 0, {}, 0},
                          {"the mouse moves now and then", 0, 0, {}, 0.9},
                          {"the mouse moves without pause", 0, 0, {}, 0}};
  constexpr std::array<double, 3> kHertz{0, 10, 60};
  std::vector<std::vector<double>> frames(paces.size());
  for (int round = 0; round < kRounds; ++round) {
    double resting = 0;
    for (size_t i = 0; i < paces.size(); ++i) {
      const Phase now = phase(window, panel, kHertz[i]);
      if (i == 0) resting = now.pictures;
      paces[i].shares.push_back(resting > 0 ? now.pictures / resting : 0);
      paces[i].vertices = now.vertices;
      frames[i].push_back(now.frames);
    }
  }
  for (size_t i = 0; i < paces.size(); ++i) paces[i].frames = quantile(frames[i], 0.5);
  return paces;
}

Result<double> processor_share(EditorWindow& window, double seconds) {
  if (!window.waits_for([](const Json& told) { return told.value("finished", false); }, 60))
    return fail(ErrorKind::failed, "vamp edit", "", "a finished picture", "none after a minute");
  sleep(1);
  const double before = window.program().cpu_seconds();
  const auto start = Clock::now();
  sleep(seconds);
  const double after = window.program().cpu_seconds();
  if (before < 0 || after < 0) return fail(ErrorKind::failed, "vamp edit", "", "its processor time", "it ended");
  return (after - before) / seconds_since(start);
}

Status wait_until_idle(EditorWindow& window) {
  constexpr double kIdle = 0.05, kPatienceSeconds = 120;
  const auto start = Clock::now();
  while (seconds_since(start) < kPatienceSeconds) {
    VAMP_TRY(const double share, processor_share(window, 2));
    if (share < kIdle) break;
  }
  return {};
}

}  // namespace vamp
