#include "bench/window/findings.h"

#include <fmt/format.h>

#include "bench/series.h"

namespace vamp {
namespace {

// What is asked of an answer, ms: for up to a tenth of the picture, and for more.
struct Asked {
  double median, at_95;
};
constexpr Asked kFew{25, 45}, kMany{45, 70};
constexpr double kFewPixels = 0.1, kOfCycles = 0.2, kResting = 0.02;

std::string spread(const std::vector<double>& ms) {
  return fmt::format("{:.1f} ({:.1f} to {:.1f})", quantile(ms, 0.5), quantile(ms, 0.05), quantile(ms, 0.95));
}

Json data_of(const std::string& what, const Answers& answers) {
  return Json{{"what", what},
              {"ms", quantile(answers.ms, 0.5)},
              {"ms_5", quantile(answers.ms, 0.05)},
              {"ms_95", quantile(answers.ms, 0.95)},
              {"rounds", answers.ms.size()},
              {"unanswered", answers.unanswered}};
}

const Answers& of(const CyclesAnswers& all, Peer peer) {
  return peer == Peer::view ? all.view : peer == Peer::light ? all.light : all.material;
}

void tell_answers(Report& report, const WindowFindings& found) {
  if (found.cases.empty()) return;
  report.table({"moved", "pixels", "ms", "asked", "of Cycles", "asked"});
  for (const auto& [what, answers, peer] : found.cases) {
    const Asked asked = answers.pixels > kFewPixels ? kMany : kFew;
    Json data = data_of(what, answers);
    data["pixels"] = answers.pixels;
    std::string ratio = "-";
    if (found.cycles) {
      const double theirs = quantile(of(*found.cycles, peer).ms, 0.5);
      const double share = theirs > 0 ? quantile(answers.ms, 0.5) / theirs : 0;
      ratio = fmt::format("{:.3f}", share);
      data["of_cycles"] = share;
    }
    if (answers.unanswered > 0)
      report.remark(fmt::format("{}: {} moves changed no pixel within seconds.", what, answers.unanswered));
    report.row({what, fmt::format("{:.1f} %", 100 * answers.pixels), spread(answers.ms),
                fmt::format("{:.0f} ({:.0f} at 95 %)", asked.median, asked.at_95), ratio,
                fmt::format("{}", kOfCycles)});
    report.data()["answers"].push_back(std::move(data));
  }
}

void tell_cycles(Report& report, const WindowFindings& found) {
  if (!found.no_cycles.empty()) report.remark("Cycles' viewport: " + found.no_cycles);
  if (!found.cycles) return;
  report.table({"Cycles' viewport", "ms"});
  for (const auto& [what, peer] : {std::pair("roughness of the same material", Peer::material),
                                   std::pair("energy of a light", Peer::light), std::pair("view", Peer::view)}) {
    const Answers& answers = of(*found.cycles, peer);
    report.row({what, spread(answers.ms)});
    report.data()["cycles"].push_back(data_of(what, answers));
  }
}

void tell_paces(Report& report, const WindowFindings& found) {
  if (found.paces.empty()) return;
  report.table({"1600 x 1000, while the picture refines", "frames a second", "vertices",
                "tiles, of the resting mouse's", "asked"});
  for (const Pace& pace : found.paces) {
    const double share = quantile(pace.shares, 0.5);
    report.row({pace.what, fmt::format("{:.0f}", pace.frames), fmt::format("{:.0f}", pace.vertices),
                fmt::format("{:.3f} ({:.3f} to {:.3f})", share, quantile(pace.shares, 0.1), quantile(pace.shares, 0.9)),
                pace.asked > 0 ? fmt::format("{}", pace.asked) : ""});
    report.data()["paces"].push_back(
        Json{{"what", pace.what}, {"frames_per_s", pace.frames}, {"vertices", pace.vertices}, {"of_resting", share}});
  }
}

}  // namespace

Report tell_window(const WindowFindings& found, const std::string& circumstances) {
  Report report("window", circumstances);
  tell_answers(report, found);
  tell_cycles(report, found);
  tell_paces(report, found);
  if (found.resting >= 0) {
    report.remark(
        fmt::format("With its picture finished and the mouse elsewhere the window takes {:.1f} % of a core "
                    "(asked: at most {:.0f}).",
                    100 * found.resting, 100 * kResting));
    report.data()["resting_share_of_a_core"] = found.resting;
  }
  if (!found.looks.empty())
    report.remark(fmt::format("The framebuffer was looked at every {:.2f} ms ({:.2f} at 95 %).",
                              quantile(found.looks, 0.5), quantile(found.looks, 0.95)));
  return report;
}

}  // namespace vamp
