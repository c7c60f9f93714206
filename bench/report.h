#pragma once
// What a benchmark found, as words for a terminal, as a block of a page in docs/, and as JSON.
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/json.h"

namespace vamp {

class Report {
 public:
  // `name`: the verb's name, "frame". `circumstances`: one line on what was measured, where and how often.
  Report(std::string name, std::string circumstances)
      : name_(std::move(name)), circumstances_(std::move(circumstances)) {}

  // Rows of as many cells as there are columns; the first column names the row.
  void table(std::vector<std::string> columns);
  void row(std::vector<std::string> cells);
  // A line of its own below the tables, such as a link to a plot.
  void remark(std::string text) { remarks_.push_back(std::move(text)); }
  // The same figures as data; a JSON object.
  Json& data() { return data_; }

  std::string text() const;
  std::string markdown() const;
  Json json() const;

  // Replaces what stands in the file between "<!-- bench NAME -->" and "<!-- end -->" by markdown(). Errors: a file
  // that cannot be read or written, or that has no such block.
  Status write_into(const std::string& file) const;

 private:
  struct Table {
    std::vector<std::vector<std::string>> rows;  // the first is the heads
  };
  std::string name_, circumstances_;
  std::vector<Table> tables_;
  std::vector<std::string> remarks_;
  Json data_ = Json::object();
};

}  // namespace vamp
