#pragma once
// What happens to files: a few bytes changed, cut out, doubled, or numbers put where sizes may stand.
#include <cstddef>
#include <random>
#include <vector>

namespace vamp::test {

using Content = std::vector<std::byte>;

// One to three such things; `content` has more than 8 bytes.
Content mutated(const Content& content, std::mt19937& random);

}  // namespace vamp::test
