#include "engine/btf/btf_xml.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace vamp {
namespace {

constexpr std::string_view kElement = "<vamp ";
constexpr std::pair<char, std::string_view> kEntities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\n', "&#10;"}};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    std::string_view written(&c, 1);
    for (const auto& [plain, entity] : kEntities)
      if (c == plain) written = entity;
    result += written;
  }
  return result;
}

std::string unescaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    size_t length = 1;
    char c = text.front();
    for (const auto& [plain, entity] : kEntities)
      if (text.starts_with(entity)) c = plain, length = entity.size();
    result += c;
    text.remove_prefix(length);
  }
  return result;
}

std::optional<std::string> attribute(std::string_view element, std::string_view name) {
  const std::string start = fmt::format(" {}=\"", name);
  const size_t at = element.find(start);
  if (at == std::string_view::npos) return {};
  const size_t first = at + start.size();
  const size_t end = element.find('"', first);
  if (end == std::string_view::npos) return {};
  return unescaped(element.substr(first, end - first));
}

}  // namespace

std::string btf_xml(const BtfInfo& info) {
  return fmt::format(
      "<vamp name=\"{}\" provenance=\"{}\" licence=\"{}\" mm_per_texel=\"{}\" synthetic=\"{}\" "
      "checksum=\"{:016}\"/>",
      escaped(info.name), escaped(info.provenance), escaped(info.licence), info.mm_per_texel,
      info.synthetic ? "yes" : "no", 0);
}

bool has_btf_xml(std::string_view xml) { return xml.find(kElement) != std::string_view::npos; }

std::optional<size_t> checksum_place(std::string_view xml) {
  constexpr std::string_view kStart = " checksum=\"";
  const size_t at = xml.find(kStart);
  if (at == std::string_view::npos) return {};
  return at + kStart.size();
}

bool read_btf_xml(std::string_view xml, BtfInfo& info) {
  const size_t start = xml.find(kElement);
  if (start == std::string_view::npos) return false;
  const std::string_view element = xml.substr(start, xml.find("/>", start) - start);
  info.name = attribute(element, "name").value_or("");
  info.provenance = attribute(element, "provenance").value_or("");
  info.licence = attribute(element, "licence").value_or("");
  info.synthetic = attribute(element, "synthetic") == "yes";
  // The header has pixels per mm, whose inverse is not always the number that was written.
  const std::string size = attribute(element, "mm_per_texel").value_or("");
  float mm = 0;
  const auto [end, code] = std::from_chars(size.data(), size.data() + size.size(), mm);
  if (code == std::errc() && std::isfinite(mm) && mm >= 0) info.mm_per_texel = mm;
  return true;
}

}  // namespace vamp
