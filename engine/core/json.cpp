#include "engine/core/json.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <set>

#include "engine/core/check.h"

namespace vamp {
namespace {

constexpr int kMaxDepth = 32;
constexpr size_t kMaxKey = 4096;

// Watches a parse without building anything: depth, duplicate keys and string lengths are known before memory is spent.
class StrictWatcher : public nlohmann::json_sax<Json> {
 public:
  explicit StrictWatcher(size_t string_limit) : string_limit_(string_limit) {}
  std::string problem;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t value, const string_t&) override {
    return std::isfinite(value) || stop("a number is not finite");
  }
  bool string(string_t& value) override {
    return value.size() <= string_limit_ || stop(fmt::format("a string is over {} KiB", string_limit_ / 1024));
  }
  bool binary(binary_t&) override { return stop("binary value"); }
  bool start_object(size_t) override {
    keys_.emplace_back();
    return enter();
  }
  bool end_object() override {
    keys_.pop_back();
    --depth_;
    return true;
  }
  bool start_array(size_t) override { return enter(); }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool key(string_t& value) override {
    if (value.size() > kMaxKey) return stop("a key is over 4 KiB");
    return keys_.back().insert(value).second || stop("the key \"" + value + "\" stands twice");
  }
  bool parse_error(size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    return stop(fmt::format("byte {}: {}", position, error.what()));
  }

 private:
  bool enter() { return ++depth_ <= kMaxDepth || stop(fmt::format("nesting deeper than {}", kMaxDepth)); }
  bool stop(std::string why) {
    if (problem.empty()) problem = std::move(why);
    return false;
  }
  size_t string_limit_;
  int depth_ = 0;
  std::vector<std::set<std::string>> keys_;
};

void check_finite(const Json& json) {
  if (json.is_number_float()) CHECK(std::isfinite(json.get<double>()));
  if (json.is_structured())
    for (const auto& child : json) check_finite(child);
}

}  // namespace

Result<Json> parse_json(std::string_view text, std::string_view file, size_t string_limit) {
  StrictWatcher watcher(string_limit);
  if (!Json::sax_parse(text.begin(), text.end(), &watcher))
    return fail(ErrorKind::bad_input, file, "", "valid JSON", watcher.problem);
  return Json::parse(text.begin(), text.end());
}

std::string print_json(const Json& json) {
  check_finite(json);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json json_number(float value) {
  CHECK(std::isfinite(value));
  if (value == 0 && std::signbit(value)) return -0.0;
  if (value == std::trunc(value) && std::abs(value) < 1e7f) return static_cast<int64_t>(value);
  return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

struct JsonReader::Shared {
  std::string file;
  std::optional<Error> error;
};

JsonReader::JsonReader(const Json& root, std::string_view file)
    : value_(&root), shared_(std::make_shared<Shared>(Shared{std::string(file), {}})) {}

JsonReader::JsonReader(const Json* value, std::shared_ptr<Shared> shared, std::string path)
    : value_(value), shared_(std::move(shared)), path_(std::move(path)) {}

bool JsonReader::has(std::string_view key) const {
  return value_ != nullptr && value_->is_object() && value_->contains(std::string(key));
}

JsonReader JsonReader::member(std::string_view key) const {
  std::string path = path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  if (value_ != nullptr && !value_->is_object()) refuse("an object", value_->type_name());
  const Json* child = has(key) ? &value_->at(std::string(key)) : nullptr;
  JsonReader reader(child, shared_, std::move(path));
  if (child == nullptr) reader.refuse("a value", "nothing");
  return reader;
}

JsonReader JsonReader::element(size_t index) const {
  const bool there = value_ != nullptr && value_->is_array() && index < value_->size();
  JsonReader reader(there ? &value_->at(index) : nullptr, shared_, fmt::format("{}[{}]", path_, index));
  if (!there) reader.refuse("a value", "nothing");
  return reader;
}

size_t JsonReader::size(size_t limit) const {
  if (value_ == nullptr) return 0;
  if (!value_->is_structured()) {
    refuse("an array or object", value_->type_name());
    return 0;
  }
  if (value_->size() > limit) {
    refuse(fmt::format("at most {} elements", limit), std::to_string(value_->size()));
    return 0;
  }
  return value_->size();
}

std::vector<std::string> JsonReader::keys(size_t limit) const {
  std::vector<std::string> names;
  if (value_ != nullptr && !value_->is_object())
    refuse("an object", value_->type_name());
  else if (size(limit) > 0)
    for (const auto& item : value_->items()) names.push_back(item.key());
  return names;
}

float JsonReader::number(float low, float high) const {
  // Compared as floats: 0.1 in a file is the limit 0.1f, though as doubles it lies below it.
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  const auto value = static_cast<float>(real(-kMost, kMost));
  if (value_ == nullptr || !value_->is_number()) return low;
  if (!(value >= low && value <= high)) {
    refuse(fmt::format("a number from {} to {}", low, high), fmt::format("{}", value));
    return low;
  }
  return value;
}

double JsonReader::real(double low, double high) const {
  if (value_ == nullptr) return low;
  if (!value_->is_number()) {
    refuse("a number", value_->type_name());
    return low;
  }
  const double value = value_->get<double>();
  if (!(value >= low && value <= high)) {
    refuse(fmt::format("a number from {:g} to {:g}", low, high), fmt::format("{}", value));
    return low;
  }
  return value;
}

int64_t JsonReader::integer(int64_t low, int64_t high) const {
  if (value_ == nullptr) return low;
  if (!value_->is_number_integer()) {
    refuse("an integer", value_->type_name());
    return low;
  }
  const bool huge = value_->is_number_unsigned() && value_->get<uint64_t>() > static_cast<uint64_t>(INT64_MAX);
  const int64_t value = huge ? INT64_MAX : value_->get<int64_t>();
  if (huge || value < low || value > high) {
    refuse(fmt::format("an integer from {} to {}", low, high), value_->dump());
    return low;
  }
  return value;
}

bool JsonReader::boolean() const {
  if (value_ == nullptr) return false;
  if (!value_->is_boolean()) {
    refuse("true or false", value_->type_name());
    return false;
  }
  return value_->get<bool>();
}

std::string JsonReader::text(size_t limit) const {
  if (value_ == nullptr) return {};
  if (!value_->is_string()) {
    refuse("a string", value_->type_name());
    return {};
  }
  auto value = value_->get<std::string>();
  if (value.size() > limit) {
    refuse(fmt::format("at most {} bytes of text", limit), std::to_string(value.size()));
    return {};
  }
  return value;
}

void JsonReader::refuse(std::string_view expected, std::string_view found) const {
  if (!shared_->error)
    shared_->error = Error{ErrorKind::bad_input, shared_->file, path_, std::string(expected), std::string(found)};
}

Status JsonReader::status() const {
  if (shared_->error) return tl::unexpected(*shared_->error);
  return {};
}

}  // namespace vamp
