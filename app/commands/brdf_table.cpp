#include "app/commands/brdf_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "engine/brdf/registry.h"
#include "engine/core/files.h"

namespace vamp {
namespace {

constexpr size_t kLongestLine = 1 << 16;
constexpr size_t kModelColumn = 0, kVariantColumn = 1, kFirstParameter = 2, kFirstNumber = 8;

std::string in_quotes(std::string_view text) { return fmt::format("\"{}\"", text.substr(0, 60)); }

template <class Rows>
std::string names_of(const Rows& rows) {
  std::vector<std::string_view> names;
  for (const auto& row : rows) names.push_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// The text as the nearest float; false where it is none or not finite.
bool read_float(std::string_view text, float& value) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return false;
  if (code == std::errc::result_out_of_range) value = std::strtof(std::string(text).c_str(), nullptr);
  return (code == std::errc() || code == std::errc::result_out_of_range) && std::isfinite(value);
}

// What a parameter may be for the formulas to mean anything. Nothing is clamped to the row's range; but a width of 0 or
// a negative exponent is no BRDF.
struct Domain {
  float low, high;
};
Domain domain_of(const ParameterRow& row) {
  constexpr float kHuge = 1e9f, kNarrowest = 1e-6f;
  return {row.min > 0 ? kNarrowest : row.min < 0 ? -kHuge : 0, kHuge};
}

}  // namespace

Result<BrdfTable> BrdfTable::open(const std::string& path, std::vector<std::string> columns,
                                  const std::vector<std::string>& appended) {
  BrdfTable table;
  table.name_ = path == "-" ? "standard input" : path;
  std::error_code code;
  if (path == "-") {
    table.file_.reset(stdin);
  } else {
    if (!fs::exists(path, code)) return fail(ErrorKind::bad_input, path, "", "a file", "nothing there");
    if (fs::is_directory(path, code)) return fail(ErrorKind::bad_input, path, "", "a file", "a folder");
    table.file_.reset(std::fopen(path.c_str(), "rb"));
    if (!table.file_) return fail(ErrorKind::io, path, "", std::string("cannot be opened: ") + std::strerror(errno));
    const auto size = fs::file_size(path, code);
    if (!code) table.size_ = size;
  }

  table.names_ = {"model", "variant", "p0", "p1", "p2", "p3", "p4", "p5"};
  table.names_.insert(table.names_.end(), columns.begin(), columns.end());
  const std::string all = fmt::format("{}", fmt::join(table.names_, ","));
  VAMP_TRY(const bool any, table.next_line(table.header_));
  if (!any) return table.refuse("", "a header with the columns " + all, "an empty file");
  if (table.header_.starts_with("\xef\xbb\xbf")) table.header_.erase(0, 3);  // a byte order mark
  VAMP_CHECK_STATUS(table.split(table.header_));
  const auto first = table.fields_.begin(), last = first + static_cast<ptrdiff_t>(table.fields_.size());
  for (const std::string& name : table.names_) {
    const auto at = std::find(first, last, name);
    if (at == last) return table.refuse("", "a header with the columns " + all, "no column " + in_quotes(name));
    if (std::find(at + 1, last, name) != last) return table.refuse("", "one column " + in_quotes(name), "two");
    table.places_.push_back(static_cast<size_t>(at - first));
  }
  for (const std::string& name : appended) {
    if (std::find(first, last, name) != last)
      return table.refuse("", "no column " + in_quotes(name) + ", which is to be added", "one");
  }
  table.field_count_ = table.fields_.size();
  return table;
}

float BrdfTable::fraction() const {
  return size_ == 0 ? 0.0f
                    : std::min(1.0f, static_cast<float>(static_cast<double>(read_) / static_cast<double>(size_)));
}

tl::unexpected<Error> BrdfTable::refuse(const std::string& column, const std::string& expected,
                                        const std::string& found) const {
  const std::string place = fmt::format("line {}{}{}", line_, column.empty() ? "" : ", ", column);
  return fail(ErrorKind::bad_input, name_, place, expected, found);
}

Result<bool> BrdfTable::next_line(std::string& line) {
  line.clear();
  ++line_;
  int c = 0;
  while ((c = getc_unlocked(file_.get())) != EOF && c != '\n') {
    if (line.size() == kLongestLine) return refuse("", fmt::format("at most {} characters", kLongestLine), "more");
    line.push_back(static_cast<char>(c));
  }
  read_ += line.size() + 1;
  if (std::ferror(file_.get())) return fail(ErrorKind::io, name_, "", "cannot be read to its end");
  if (line.ends_with('\r')) line.pop_back();
  return c != EOF || !line.empty();
}

// Fields between commas, spaces around them dropped; a field may stand in double quotes.
Status BrdfTable::split(const std::string& line) {
  size_t count = 0, i = 0;
  const auto skip_spaces = [&] {
    while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
  };
  for (;;) {
    if (count == fields_.size()) fields_.emplace_back();
    std::string& field = fields_[count++];
    field.clear();
    skip_spaces();
    if (i < line.size() && line[i] == '"') {
      for (++i;; ++i) {
        if (i == line.size()) return refuse("", "a closing quotation mark", "none");
        if (line[i] == '"') {
          if (i + 1 == line.size() || line[i + 1] != '"') break;
          ++i;  // two of them stand for one
        }
        field.push_back(line[i]);
      }
      ++i;
      skip_spaces();
      if (i < line.size() && line[i] != ',')
        return refuse("", "a comma behind a quoted field", in_quotes(std::string_view(line).substr(i)));
    } else {
      const size_t end = std::min(line.find(',', i), line.size());
      field.assign(line, i, end - i);
      while (field.ends_with(' ') || field.ends_with('\t')) field.pop_back();
      i = end;
    }
    if (i == line.size()) break;
    ++i;
  }
  fields_.resize(count);
  return {};
}

Result<float> BrdfTable::number(size_t column, const std::string& name) const {
  std::string_view text = fields_[column];
  if (text.starts_with('+')) text.remove_prefix(1);
  float value = 0;
  if (!read_float(text, value)) return refuse(name, "a finite number", in_quotes(fields_[column]));
  return value;
}

Status BrdfTable::read_lobe(Lobe& lobe) const {
  const std::string& model_name = fields_[places_[kModelColumn]];
  const auto model = find_model(model_name);
  if (!model) return refuse("model", "one of " + names_of(models()), in_quotes(model_name));
  const ModelRow& row = model_row(*model);
  const std::string& variant_name = fields_[places_[kVariantColumn]];
  const auto variant = find_variant(*model, variant_name);
  if (!variant) {
    const auto list = names_of(row.variants);
    return refuse("variant", row.variants.size() > 1 ? "one of " + list : list, in_quotes(variant_name));
  }
  lobe = {*model, *variant, {}};
  for (size_t p = 0; p < lobe.params.size(); ++p) {
    const std::string& name = names_[kFirstParameter + p];
    VAMP_TRY(const float value, number(places_[kFirstParameter + p], name));
    lobe.params[p] = value;
    const ParameterRow* parameter = find_parameter(*model, *variant, static_cast<int>(p));
    if (parameter) {
      const Domain domain = domain_of(*parameter);
      if (!(value >= domain.low && value <= domain.high)) {
        return refuse(fmt::format("{} ({})", name, parameter->name),
                      fmt::format("a number from {:g} to {:g}", domain.low, domain.high), fmt::format("{:g}", value));
      }
    } else if (value != 0 && std::none_of(row.parameters.begin(), row.parameters.end(),
                                          [p](const ParameterRow& other) { return other.slot == p; })) {
      return refuse(name, fmt::format("0, because {} has no such parameter", row.name), fmt::format("{:g}", value));
    }
  }
  return {};
}

Result<bool> BrdfTable::next(Row& row) {
  do {
    VAMP_TRY(const bool more, next_line(row.text));
    if (!more) return false;
  } while (row.text.empty());
  VAMP_CHECK_STATUS(split(row.text));
  if (fields_.size() != field_count_)
    return refuse("", fmt::format("{} fields, as in the header", field_count_), std::to_string(fields_.size()));
  VAMP_CHECK_STATUS(read_lobe(row.lobe));
  row.numbers.resize(names_.size() - kFirstNumber);
  for (size_t i = 0; i < row.numbers.size(); ++i) {
    VAMP_TRY(row.numbers[i], number(places_[kFirstNumber + i], names_[kFirstNumber + i]));
  }
  return true;
}

}  // namespace vamp
