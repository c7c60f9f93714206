#include "tests/app/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "tests/scene/glb_builder.h"

namespace vamp::test {
namespace {

constexpr uint64_t kLimit = 64 << 20;

void redirect(const fs::path& path, int descriptor) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || ::dup2(file, descriptor) < 0) std::_Exit(126);
}

}  // namespace

Json Ended::json() const {
  auto parsed = parse_json(out, "stdout");
  EXPECT_TRUE(parsed) << out;
  return parsed ? *parsed : Json();
}

Program::Program() {
  std::string name = (fs::temp_directory_path() / "vamp-app-XXXXXX").string();
  EXPECT_NE(::mkdtemp(name.data()), nullptr);
  folder = name;
  output = folder / "stdout";
}

Program::~Program() {
  std::error_code code;
  fs::remove_all(folder, code);
}

pid_t Program::start(const std::vector<std::string>& arguments,
                     const std::vector<std::pair<std::string, std::string>>& environment) {
  const pid_t process = ::fork();
  EXPECT_GE(process, 0);
  if (process != 0) return process;
  redirect(output, STDOUT_FILENO);
  redirect(folder / "stderr", STDERR_FILENO);
  for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"})
    ::setenv(variable, (folder / "home").c_str(), 1);
  for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (::chdir(folder.c_str()) != 0) std::_Exit(126);
  std::vector<char*> words = {const_cast<char*>("vamp")};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(VAMP_PROGRAM, words.data());
  std::_Exit(127);
}

Ended Program::finish(pid_t process) {
  int status = 0;
  EXPECT_EQ(::waitpid(process, &status, 0), process);
  Ended ended;
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ended.out = read_text(folder / "stdout", kLimit).value_or("");
  ended.err = said();
  return ended;
}

Ended Program::run(const std::vector<std::string>& arguments,
                   const std::vector<std::pair<std::string, std::string>>& environment) {
  return finish(start(arguments, environment));
}

std::string Program::said() const { return read_text(folder / "stderr", kLimit).value_or(""); }

std::string Program::box_on_floor() {
  GlbBuilder builder;
  builder.add(box(vec3(0.1f)), builder.material("Box"));
  builder.add(plane(2, 2), builder.material("Floor", vec4(0.5f, 0.5f, 0.5f, 1)), vec3(0, -0.05f, 0));
  builder.write(folder / "box.glb");
  return "box.glb";
}

Ended Program::render(std::vector<std::string> arguments) {
  const auto given = [&arguments](const char* option) {
    return std::find(arguments.begin(), arguments.end(), option) != arguments.end();
  };
  std::vector<std::string> all = {"render", "--validate"};
  if (!given("--from")) all.push_back(box_on_floor());
  if (!given("--from") && !given("--size")) all.insert(all.end(), {"--size", "24x16"});
  if (!given("--from") && !given("--samples") && !given("--time")) all.insert(all.end(), {"--samples", "2"});
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run(all);
}

std::string Program::bytes_of(const std::string& name) const {
  const auto bytes = read_text(folder / name, kLimit);
  EXPECT_TRUE(bytes) << name;
  return bytes.value_or("");
}

}  // namespace vamp::test
