#include "bench/window/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <sstream>

namespace vamp {
namespace {

constexpr int kNotStarted = 127;

[[noreturn]] void become(const std::vector<std::string>& words, const std::vector<std::string>& variables, int out,
                         const fs::path& log) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const std::string& variable : variables) putenv(const_cast<char*>(variable.c_str()));
  dup2(out, STDOUT_FILENO);
  const int messages = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (messages >= 0) dup2(messages, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(kNotStarted);
}

}  // namespace

Result<std::unique_ptr<Child>> Child::start(const std::vector<std::string>& words,
                                            const std::vector<std::string>& variables, const fs::path& log) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return fail(ErrorKind::io, words[0], "", "a pipe from it", "none");
  const pid_t process = fork();
  if (process == 0) become(words, variables, ends[1], log);
  close(ends[1]);
  if (process < 0) {
    close(ends[0]);
    return fail(ErrorKind::failed, words[0], "", "a process for it", "none");
  }
  return std::unique_ptr<Child>(new Child(process, ends[0]));
}

Child::Child(pid_t process, int out) : process_(process), out_(out), reader_([this] { read_lines(); }) {}

Child::~Child() {
  stop();
  reader_.join();
  close(out_);
}

void Child::stop() {
  if (process_ <= 0) return;
  kill(process_, SIGTERM);
  for (int wait = 0; wait < 100 && running(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (!running()) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = -1;
}

bool Child::running() {
  if (process_ > 0 && waitpid(process_, nullptr, WNOHANG) == process_) process_ = -1;
  return process_ > 0;
}

void Child::read_lines() {
  std::array<char, 1 << 16> part{};
  std::string rest;
  for (ssize_t got = 0; (got = read(out_, part.data(), part.size())) > 0;) {
    rest.append(part.data(), static_cast<size_t>(got));
    const size_t end = rest.rfind('\n');
    if (end == std::string::npos) continue;
    const size_t before = end == 0 ? std::string::npos : rest.rfind('\n', end - 1);
    const size_t begin = before == std::string::npos ? 0 : before + 1;
    {
      const std::lock_guard lock(mutex_);
      line_.number += static_cast<uint64_t>(std::count(rest.begin(), rest.begin() + static_cast<long>(end) + 1, '\n'));
      line_.text = rest.substr(begin, end - begin);
    }
    came_.notify_all();
    rest.erase(0, end + 1);
  }
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  came_.notify_all();
}

Child::Line Child::last_line() const {
  const std::lock_guard lock(mutex_);
  return line_;
}

Child::Line Child::line_after(uint64_t number, double seconds) const {
  std::unique_lock lock(mutex_);
  came_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return closed_ || line_.number > number; });
  return line_;
}

double Child::cpu_seconds() const {
  const Result<std::string> stat = read_text(fmt::format("/proc/{}/stat", process_), 1 << 16);
  const size_t name_end = stat ? stat->rfind(')') : std::string::npos;
  if (name_end == std::string::npos) return -1;
  // After the name: state and ten numbers, then the time in the program and in the system for it, in clock ticks.
  std::istringstream words(stat->substr(name_end + 2));
  std::string skipped;
  for (int i = 0; i < 11; ++i) words >> skipped;
  double user = 0, system = 0;
  words >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace vamp
