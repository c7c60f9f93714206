#pragma once
// A program that runs beside this one and ends with it at the latest.
#include <sys/types.h>

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/files.h"

namespace vamp {

class Child {
 public:
  // `words`: the program, looked for as a shell does, and its arguments. `variables`: "NAME=value", beside this
  // program's own. What it prints on stdout can be read as lines; stderr goes into `log`. Errors: io, failed where no
  // such program can be started.
  static Result<std::unique_ptr<Child>> start(const std::vector<std::string>& words,
                                              const std::vector<std::string>& variables, const fs::path& log);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Asks it to end, then makes it. Also done by the destructor.
  void stop();
  bool running();

  // The last whole line that it printed, and how many there were; empty before the first.
  struct Line {
    std::string text;
    uint64_t number = 0;
  };
  Line last_line() const;
  // Waits for a line after that number; the last one, whose number may be the same when `seconds` are over or it ended.
  Line line_after(uint64_t number, double seconds) const;

  // Seconds of processor time that it has taken so far, all its threads; less than 0 once it has ended.
  double cpu_seconds() const;

 private:
  Child(pid_t process, int out);
  void read_lines();

  pid_t process_;
  int out_;
  mutable std::mutex mutex_;
  mutable std::condition_variable came_;
  Line line_;
  bool closed_ = false;
  std::thread reader_;
};

}  // namespace vamp
