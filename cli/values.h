#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "usage_error.h"

namespace cli {

/// A finite number, all of `text`. @throws UsageError that names the option
[[nodiscard]] double parse_number(std::string_view option, const std::string& text);

/// A number in [lo, hi]. @throws UsageError
[[nodiscard]] double parse_number(std::string_view option, const std::string& text, double lo, double hi);

/// An integer in [lo, hi]. @throws UsageError
[[nodiscard]] int parse_count(std::string_view option, const std::string& text, int lo, int hi);

/// The parts between commas; an empty part is an error. @throws UsageError
[[nodiscard]] std::vector<std::string> split_list(std::string_view option, const std::string& text);

/// A word of an option and what it stands for.
template <typename Value>
struct Choice {
  std::string_view word;
  Value value;
};

/// The value of the word. `later`: words of the interface that do not work yet.
/// @throws UsageError
template <typename Value>
[[nodiscard]] Value choose(std::string_view option, const std::string& text,
                           const std::vector<Choice<Value>>& choices,
                           const std::vector<std::string_view>& later = {}) {
  std::string words;
  for (const Choice<Value>& choice : choices) {
    if (choice.word == text) return choice.value;
    if (!words.empty()) words += ", ";
    words += choice.word;
  }
  if (std::find(later.begin(), later.end(), text) != later.end()) {
    throw UsageError(fmt::format("{} {} is not available yet; there is {}", option, text, words));
  }
  throw UsageError(fmt::format("{} takes one of {}, not '{}'", option, words, text));
}

}  // namespace cli
