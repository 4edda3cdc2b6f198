#include "values.h"

#include <cerrno>
#include <cmath>
#include <cstdlib>

namespace cli {

double parse_number(std::string_view option, const std::string& text) {
  // strtod passes over leading blanks and takes hexadecimal numbers; nobody means those here. The program
  // never calls setlocale, so the decimal point is a point.
  const bool plain = !text.empty() && text.find_first_not_of("+-.0123456789eE") == std::string::npos;
  char* end = nullptr;
  const double value = plain ? std::strtod(text.c_str(), &end) : 0.0;
  if (!plain || *end != '\0' || !std::isfinite(value)) {
    throw UsageError(fmt::format("{} takes a finite number, not '{}'", option, text));
  }
  return value;
}

double parse_number(std::string_view option, const std::string& text, double lo, double hi) {
  const double value = parse_number(option, text);
  if (value < lo || value > hi) {
    throw UsageError(fmt::format("{} takes a number from {} to {}, not {}", option, lo, hi, text));
  }
  return value;
}

int parse_count(std::string_view option, const std::string& text, int lo, int hi) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  errno = 0;
  const long value = digits ? std::strtol(text.c_str(), nullptr, 10) : -1;
  if (!digits || errno != 0 || value < lo || value > hi) {
    throw UsageError(fmt::format("{} takes a whole number from {} to {}, not '{}'", option, lo, hi, text));
  }
  return static_cast<int>(value);
}

std::vector<std::string> split_list(std::string_view option, const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (const std::string& part : parts) {
    if (part.empty()) {
      throw UsageError(fmt::format("{} takes a list like 1,2,3 without gaps, not '{}'", option, text));
    }
  }
  return parts;
}

}  // namespace cli
