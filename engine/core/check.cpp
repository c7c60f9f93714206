#include "engine/core/check.h"

#include <cstdio>
#include <cstdlib>

namespace vamp {

void check_failed(const char* file, int line, const char* condition) {
  std::fprintf(stderr, "vamp: internal error: %s:%d: %s\n", file, line, condition);
  std::abort();
}

}  // namespace vamp
