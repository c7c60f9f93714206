#pragma once
// What can go wrong because of the user's files or the machine, and how it is said.
#include <tl/expected.hpp>

#include <stdexcept>
#include <string>
#include <string_view>

namespace vamp {

// Also the program's exit codes (docs/command-line.md).
enum class ErrorKind : int {
  failed = 1,         // the work itself failed
  usage = 2,          // the command line is wrong
  bad_input = 3,      // a file is missing, damaged, hostile or not of the expected kind
  io = 4,             // reading or writing failed: disk full, no permission
  no_device = 5,      // no Vulkan device that serves
  device_lost = 6,    // the device was lost or its memory ran out
  interrupted = 130,  // the user stopped it
};

// One clear line: which file, where in it, what was expected, what was found. Parts that do not apply stay empty.
struct Error {
  ErrorKind kind = ErrorKind::failed;
  std::string file;
  std::string place;
  std::string expected;
  std::string found;

  std::string message() const;
};

template <class T>
using Result = tl::expected<T, Error>;
using Status = tl::expected<void, Error>;

// return fail(ErrorKind::bad_input, path, "accessors[3].count", "at most 65536", "4294967295");
tl::unexpected<Error> fail(ErrorKind kind, std::string_view file, std::string_view place, std::string_view expected,
                           std::string_view found = {});

// The machine fails (device lost, out of GPU memory): thrown, caught once in app, which saves the document first.
class MachineError : public std::runtime_error {
 public:
  MachineError(ErrorKind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace vamp

// Hands an error upwards: VAMP_TRY(auto mesh, load_mesh(path)); or VAMP_CHECK_STATUS(save(path));
#define VAMP_TRY_JOIN2(a, b) a##b
#define VAMP_TRY_JOIN(a, b) VAMP_TRY_JOIN2(a, b)
#define VAMP_TRY_AS(name, declaration, expression)              \
  auto name = (expression);                                     \
  if (!name) return tl::unexpected(std::move(name).error());    \
  declaration = std::move(*name)
#define VAMP_TRY(declaration, expression) VAMP_TRY_AS(VAMP_TRY_JOIN(vamp_try_, __LINE__), declaration, expression)
#define VAMP_CHECK_STATUS(expression) \
  if (auto vamp_status = (expression); !vamp_status) return tl::unexpected(std::move(vamp_status).error())
