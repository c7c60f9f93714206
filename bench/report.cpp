#include "bench/report.h"

#include <fmt/format.h>

#include "engine/core/check.h"
#include "engine/core/files.h"

namespace vamp {
namespace {

constexpr uint64_t kPageLimit = 4 << 20;
constexpr std::string_view kEnd = "<!-- end -->";

std::string joined(const std::vector<std::string>& cells, const char* between) {
  return fmt::format("{}", fmt::join(cells, between));
}

}  // namespace

void Report::table(std::vector<std::string> columns) { tables_.push_back({{std::move(columns)}}); }

void Report::row(std::vector<std::string> cells) {
  CHECK(!tables_.empty() && cells.size() == tables_.back().rows.front().size());
  tables_.back().rows.push_back(std::move(cells));
}

std::string Report::text() const {
  std::string text = circumstances_ + "\n";
  for (const Table& table : tables_) {
    std::vector<size_t> widths(table.rows.front().size(), 0);
    for (const auto& row : table.rows)
      for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    text += '\n';
    for (const auto& row : table.rows) {
      text += fmt::format("{:<{}}", row[0], widths[0]);
      for (size_t i = 1; i < row.size(); ++i) text += fmt::format("  {:>{}}", row[i], widths[i]);
      text += '\n';
    }
  }
  for (const std::string& remark : remarks_) text += "\n" + remark + "\n";
  return text;
}

std::string Report::markdown() const {
  std::string text = circumstances_ + "\n";
  for (const Table& table : tables_) {
    text += "\n| " + joined(table.rows.front(), " | ") + " |\n|";
    for (size_t i = 0; i < table.rows.front().size(); ++i) text += i == 0 ? "---|" : "---:|";
    text += '\n';
    for (size_t i = 1; i < table.rows.size(); ++i) text += "| " + joined(table.rows[i], " | ") + " |\n";
  }
  for (const std::string& remark : remarks_) text += "\n" + remark + "\n";
  return text;
}

Json Report::json() const {
  Json json{{"bench", name_}, {"circumstances", circumstances_}};
  json.update(data_);
  return json;
}

Status Report::write_into(const std::string& file) const {
  VAMP_TRY(std::string page, read_text(file, kPageLimit));
  const std::string begin = "<!-- bench " + name_ + " -->\n";
  const size_t start = page.find(begin);
  const size_t end = start == std::string::npos ? start : page.find(kEnd, start);
  if (end == std::string::npos)
    return fail(ErrorKind::bad_input, file, "",
                "a block from \"<!-- bench " + name_ + " -->\" to \"" + std::string(kEnd) + "\"", "none");
  page.replace(start + begin.size(), end - start - begin.size(), markdown());
  return write_text_atomically(file, page);
}

}  // namespace vamp
