#include "engine/scene/part_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace vamp {
namespace {

// UTF-8 that ends before the byte `limit` without cutting a character in two.
std::string shortened(const std::string& text, size_t limit) {
  if (text.size() <= limit) return text;
  while (limit > 0 && (static_cast<unsigned char>(text[limit]) & 0xc0u) == 0x80u) --limit;
  return text.substr(0, limit);
}

// One line, without the blanks at its ends, of at most 200 bytes.
std::string readable(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
  const size_t first = name.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return shortened(name.substr(first, name.find_last_not_of(' ') - first + 1), 200);
}

}  // namespace

PartNames::PartNames(const std::vector<std::string>& material_names) {
  for (const std::string& name : material_names) taken_.insert(readable(name));
  int number = 0;
  for (const std::string& material : material_names) {
    std::string name = readable(material);
    if (name.empty()) {
      do {
        name = fmt::format("Part {}", ++number);
      } while (taken_.contains(name));
      taken_.insert(name);
    }
    names_.push_back(std::move(name));
  }
  for (int i = 2; taken_.contains(default_); ++i) default_ = fmt::format("Default {}", i);
}

}  // namespace vamp
