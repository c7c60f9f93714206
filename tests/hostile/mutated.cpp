#include "tests/hostile/mutated.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace vamp::test {

Content mutated(const Content& content, std::mt19937& random) {
  constexpr uint32_t kNumbers[] = {0,          1,          2,          255,        65535,     65536,
                                   0x7fffffff, 0x80000000, 0xffffffff, 0x7f800000, 0x7fc00000};
  Content result = content;
  const size_t rounds = 1 + random() % 3;
  for (size_t i = 0; i < rounds && result.size() > 8; ++i) {
    // Headers more often than what follows them.
    const size_t reach = random() % 2 == 0 ? result.size() : std::min<size_t>(result.size(), 256);
    const size_t at = random() % (reach - 4);
    const size_t length = 1 + random() % 16;
    const auto here = result.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = result.begin() + static_cast<std::ptrdiff_t>(std::min(at + length, result.size()));
    switch (random() % 6) {
      case 0:
        result[at] ^= static_cast<std::byte>(1u << random() % 8);
        break;
      case 1:
        result[at] = static_cast<std::byte>(random());
        break;
      case 2: {
        const uint32_t number = kNumbers[random() % std::size(kNumbers)];
        std::memcpy(&*here, &number, sizeof(number));
        break;
      }
      case 3:
        result.erase(here, end);
        break;
      case 4: {
        const Content copy(here, end);
        result.insert(here, copy.begin(), copy.end());
        break;
      }
      default:
        result.resize(at);
    }
  }
  return result;
}

}  // namespace vamp::test
