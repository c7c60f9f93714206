#pragma once
// Tables of BRDF questions: CSV with a header line, read a row at a time, so that millions of rows need no memory.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "engine/brdf/lobe.h"
#include "engine/core/error.h"

namespace vamp {

// Columns are found by their names, in any order; columns that nobody asked for are passed on.
class BrdfTable {
 public:
  struct Row {
    std::string text;  // the line as it was read
    Lobe lobe;
    std::vector<float> numbers;  // the asked-for columns, in order
  };

  // `path`: a file, or "-" for standard input. `columns` beside model, variant and p0 to p5. `appended` are those that
  // the result will have and the table must not.
  static Result<BrdfTable> open(const std::string& path, std::vector<std::string> columns,
                                const std::vector<std::string>& appended);

  const std::string& header() const { return header_; }
  // The next row; false at the end. Errors name the line and the column.
  Result<bool> next(Row& row);
  // How much of the file has been read, 0 to 1; 0 where its size is not known.
  float fraction() const;

  // An error in a column of the row at hand, or in the whole row where `column` is empty.
  tl::unexpected<Error> refuse(const std::string& column, const std::string& expected, const std::string& found) const;

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const {
      if (file != stdin) std::fclose(file);
    }
  };

  BrdfTable() = default;
  Result<bool> next_line(std::string& line);
  Status split(const std::string& line);
  Status read_lobe(Lobe& lobe) const;
  Result<float> number(size_t column, const std::string& name) const;

  std::unique_ptr<std::FILE, CloseFile> file_;
  std::string name_;  // for messages
  std::string header_;
  std::vector<std::string> names_;   // of the asked-for columns, model, variant and p0 to p5 first
  std::vector<size_t> places_;       // where they stand
  std::vector<std::string> fields_;  // of the current line
  size_t field_count_ = 0;
  size_t line_ = 0;
  uint64_t size_ = 0, read_ = 0;  // bytes
};

}  // namespace vamp
