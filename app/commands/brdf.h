#pragma once
// `vamp brdf`: the models by themselves. What its verbs share.
#include <span>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "engine/brdf/lobe.h"
#include "engine/probe/brdf_probe.h"

namespace vamp {

void add_brdf_list(CLI::App& brdf, CommonOptions& common, Action& action);
void add_brdf_eval(CLI::App& brdf, CommonOptions& common, Action& action);
void add_brdf_sample(CLI::App& brdf, CommonOptions& common, Action& action);
void add_brdf_albedo(CLI::App& brdf, CommonOptions& common, Action& action);
void add_brdf_plot(CLI::App& brdf, CommonOptions& common, Action& action);

// The text of shaders/brdf as it runs on the device, as C++ float, or as C++ double. All three get the same floats.
class BrdfEngine {
 public:
  // `on`: gpu, cpu or double.
  static Result<BrdfEngine> open(const std::string& on, const CommonOptions& common);
  BrdfEngine(BrdfEngine&&) noexcept;
  ~BrdfEngine();

  struct Value {
    double fcos = 0;
    double pdf = 0;
  };
  struct Draw {
    dvec3 wi{0};
    double pdf = 0, weight = 0;
    bool valid = false;
  };
  // Directions are normalised where unit_direction() would, with the same floats for each build; 0 unless both are
  // above the horizon. Throw MachineError.
  std::vector<Value> values(std::vector<BrdfQuestion> questions);
  std::vector<Draw> draws(std::vector<BrdfQuestion> questions);

  // How a number of this build is printed so that it reads back the same.
  std::string print(double value) const;

 private:
  enum class Build { gpu, cpu, oracle };
  BrdfEngine() = default;
  Build build_ = Build::cpu;
  std::unique_ptr<gpu::Device> device_;
  std::unique_ptr<BrdfProbe> probe_;
};

// Adds --on to a verb.
void add_engine_option(CLI::App& verb, std::string& on);

// One lobe as words on the command line: MODEL or MODEL/VARIANT, then NAME=VALUE in the measure that `vamp brdf list`
// shows; what is not said has the row's default. Errors are of kind usage.
struct LobeWords {
  std::string model;
  std::vector<std::string> parameters;
};
void add_lobe_words(CLI::App& verb, LobeWords& words, bool required);
Result<Lobe> lobe_of(const LobeWords& words);

inline constexpr float kMaxTheta = 89.9999f;  // of directions on the command line, degrees

// Several angles, "0,15,30", in degrees from 0 to kMaxTheta.
Result<std::vector<double>> angles_option(const std::string& text, const char* option);

// The direction at `theta` and `phi` degrees, rounded to floats.
vec3 direction_at(double theta, double phi);

}  // namespace vamp
