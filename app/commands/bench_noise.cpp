// `vamp bench noise`: the estimate of a picture's noise beside its error.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/noise.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string rounds = "3", reference = "4096";
};

Result<std::vector<NoiseScene>> scenes() {
  VAMP_TRY(Project shoe, bench_project(""));
  VAMP_TRY(Project shapes, bench_project("shapes"));
  Project close = shoe;
  close.camera.fov_degrees /= 4;
  std::vector<NoiseScene> all;
  all.push_back({"the shipped shoe", std::move(shoe)});
  all.push_back({"its leather from near", std::move(close)});
  all.push_back({"shapes", std::move(shapes)});
  return all;
}

Result<Report> run(const Options& options, const CommonOptions& common) {
  NoiseBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(bench.reference, count_option(options.reference, "--reference", 512, 1 << 20));
  bench.rounds = static_cast<int>(rounds);
  VAMP_TRY(const std::vector<NoiseScene> all, scenes());
  VAMP_TRY(const auto device, open_device(common));
  return bench_noise(*device, all, bench);
}

}  // namespace

void add_bench_noise(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "noise", "What the program says of a picture's noise, beside its error", common,
                                 action, [options, &common] { return run(*options, common); });
  verb->add_option("--rounds", options->rounds, "Pictures of each")->type_name("N")->capture_default_str();
  verb->add_option("--reference", options->reference, "Samples of the references")
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace vamp
