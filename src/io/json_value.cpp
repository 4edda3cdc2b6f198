#include "io/json_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/text_position.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Curves need a depth of five; the limit keeps the destructor's recursion short.
constexpr std::size_t kDeepestNesting = 64;

/// Feeds the JSON library and tells how far it has read, which its events do not.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* position, const char** furthest) : position_(position), furthest_(furthest) {}
  reference operator*() const { return *position_; }
  CountingIterator& operator++() {
    *furthest_ = ++position_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return position_ == other.position_; }
  bool operator!=(const CountingIterator& other) const { return position_ != other.position_; }

 private:
  const char* position_;
  const char** furthest_;
};

bool in_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

/// Builds the tree from the events of nlohmann's parser.
class TreeBuilder {
 public:
  using number_integer_t = std::int64_t;
  using number_unsigned_t = std::uint64_t;
  using number_float_t = double;
  using string_t = std::string;
  using binary_t = nlohmann::json::binary_t;

  TreeBuilder(std::string_view text, const std::string& source)
      : text_(text), source_(source), read_(text.data()) {}

  [[nodiscard]] const char** furthest() { return &read_; }
  [[nodiscard]] JsonValue take() { return std::move(root_); }

  bool null() { return add(bytes_read() - 4, std::monostate{}); }
  bool boolean(bool value) { return add(bytes_read() - (value ? 4 : 5), value); }
  bool number_integer(std::int64_t value) { return add_number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return add_number(static_cast<double>(value)); }
  bool number_float(double value, const std::string& /*text*/) { return add_number(value); }
  bool string(std::string& value) { return add(string_start(), std::move(value)); }
  bool binary(binary_t& /*value*/) { return false; }  // only binary formats have it
  bool start_object(std::size_t /*size*/) { return open(JsonValue::Object{}); }
  bool start_array(std::size_t /*size*/) { return open(JsonValue::Array{}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& key) {
    key_ = std::move(key);
    return true;
  }

  [[noreturn]] bool parse_error(std::size_t position, const std::string& /*token*/,
                                const nlohmann::json::exception& error) {
    std::string message = error.what();
    // "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error while ..."
    if (const std::size_t code = message.find("] "); code != std::string::npos) message.erase(0, code + 2);
    if (message.rfind("parse error at ", 0) == 0) {
      if (const std::size_t colon = message.find(": "); colon != std::string::npos)
        message.erase(0, colon + 2);
    }
    std::size_t offset = position > 0 ? position - 1 : 0;
    if (message.rfind("number overflow", 0) == 0) offset = number_start(std::min(offset, text_.size()));
    fail_at(source_, text_, offset, message);
  }

 private:
  [[nodiscard]] std::size_t bytes_read() const { return static_cast<std::size_t>(read_ - text_.data()); }
  [[nodiscard]] std::size_t last_byte() const { return bytes_read() - 1; }

  /// The start of the number that ends at `end`, or one byte before it.
  [[nodiscard]] std::size_t number_start(std::size_t end) const {
    if (end > 0 && !in_number(text_[end - 1])) --end;
    while (end > 0 && in_number(text_[end - 1])) --end;
    return end;
  }

  /// The quote that opens the string just read: going back, the first one without a backslash.
  [[nodiscard]] std::size_t string_start() const {
    std::size_t i = last_byte();
    while (i > 0) {
      --i;
      if (text_[i] == '"' && (i == 0 || text_[i - 1] != '\\')) break;
    }
    return i;
  }

  /// The parser has read one byte beyond the number, except at the end of the text.
  bool add_number(double value) {
    const std::size_t start = number_start(bytes_read());
    if (value == 0.0 && text_[start] == '-') value = -0.0;  // the parser takes "-0" for an integer
    return add(start, value);
  }

  template <typename Value>
  bool open(Value&& container) {
    if (open_.size() >= kDeepestNesting) {
      fail_at(source_, text_, last_byte(), fmt::format("nested more than {} levels deep", kDeepestNesting));
    }
    return add(last_byte(), std::forward<Value>(container), true);
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  template <typename Value>
  bool add(std::size_t offset, Value&& value, bool container = false) {
    JsonValue* place = &root_;
    if (!open_.empty()) {
      if (auto* array = std::get_if<JsonValue::Array>(&open_.back()->value)) {
        place = &array->emplace_back();
      } else {
        auto& object = std::get<JsonValue::Object>(open_.back()->value);
        place = &object.emplace_back(JsonMember{std::move(key_), {}}).value;
      }
    }
    place->offset = offset;
    place->value = std::forward<Value>(value);
    if (container) open_.push_back(place);  // stays put: its parent grows only after it is closed
    return true;
  }

  std::string_view text_;
  const std::string& source_;
  const char* read_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::string key_;
};

}  // namespace

const JsonValue* JsonValue::member(std::string_view key) const noexcept {
  const Object* members = object();
  if (members == nullptr) return nullptr;
  const auto found = std::find_if(members->rbegin(), members->rend(),  // of several, the last counts
                                  [key](const JsonMember& member) { return member.key == key; });
  return found == members->rend() || found->value.is_null() ? nullptr : &found->value;
}

std::string_view JsonValue::kind() const noexcept {
  static constexpr std::array<std::string_view, 6> kKinds = {"null",     "true or false", "a number",
                                                             "a string", "an array",      "an object"};
  return kKinds[value.index()];
}

JsonValue parse_json(std::string_view text, const std::string& source) {
  text = without_bom(text);
  TreeBuilder builder(text, source);
  const CountingIterator first(text.data(), builder.furthest());
  const CountingIterator last(text.data() + text.size(), builder.furthest());
  nlohmann::json::sax_parse(first, last, &builder);
  return builder.take();
}

}  // namespace v0
}  // namespace tandem
