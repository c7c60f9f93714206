// A scene pays only for what it uses: the kernel specialised without a model is, as SPIR-V, the kernel built without
// it.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "shaders/brdf/lobe_tags.h"
#include "shaders/shared/frame.h"

namespace vamp {
namespace {

namespace fs = std::filesystem;

std::string output_of(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::string text;
  char piece[4096];
  for (size_t n = 0; pipe && (n = std::fread(piece, 1, sizeof(piece), pipe)) > 0;) text.append(piece, n);
  EXPECT_EQ(pipe ? ::pclose(pipe) : -1, 0) << command << "\n" << text;
  return text;
}

// What is left of a kernel with its constants frozen and all that they exclude removed: its lines in the order of the
// alphabet, because the order in which constants are declared is all that may differ.
std::vector<std::string> essence(const std::string& kernel, const std::string& constant) {
  std::string name = (fs::temp_directory_path() / "vamp-spirv-XXXXXX").string();
  EXPECT_NE(::mkdtemp(name.data()), nullptr);
  const std::string small = name + "/small.spv";
  output_of(std::string(VAMP_SPIRV_OPT) + " " + constant +
            " --strip-debug --freeze-spec-const --fold-spec-const-op-composite --ccp --eliminate-dead-branches"
            " --merge-blocks --eliminate-dead-code-aggressive --eliminate-dead-functions --unify-const"
            " --eliminate-dead-const --compact-ids " +
            kernel + " -o " + small);
  std::istringstream text(output_of(std::string(VAMP_SPIRV_DIS) + " " + small));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  fs::remove_all(name);
  return lines;
}

std::string specialised(uint32_t models) {
  return "--set-spec-const-default-value=" + std::to_string(SPEC_LOBE_MODELS) + ":" + std::to_string(models);
}

std::string built(uint32_t models) { return std::string(VAMP_KERNELS) + "/shade_" + std::to_string(models) + ".spv"; }

const std::string kGeneric = std::string(VAMP_KERNELS) + "/shade.spv";

TEST(Spirv, TheKernelSpecialisedWithoutAModelIsTheKernelBuiltWithoutIt) {
  for (uint32_t bit = LOBE_LAMBERT; bit <= LOBE_ASHIKHMIN_SHIRLEY_BASE; bit *= 2) {
    const uint32_t models = LOBE_EVERYTHING & ~bit;
    const auto lines = essence(kGeneric, specialised(models));
    EXPECT_GT(lines.size(), 1000u);
    EXPECT_TRUE(lines == essence(built(models), "")) << "without " << bit;
  }
}

TEST(Spirv, TheKernelOfAUsualSceneIsTheKernelBuiltForIt) {
  const uint32_t models = LOBE_LAMBERT | LOBE_OREN_NAYAR | LOBE_COOK_TORRANCE;
  const auto lines = essence(kGeneric, specialised(models));
  EXPECT_TRUE(lines == essence(built(models), ""));
  EXPECT_LT(lines.size(), essence(kGeneric, specialised(LOBE_EVERYTHING)).size());
}

}  // namespace
}  // namespace vamp
