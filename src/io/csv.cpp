#include "tandem/io/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/interpolate.h"
#include "io/limits.h"
#include "io/number.h"
#include "io/scan_number.h"
#include "io/text_position.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr char kBlanks = ' ';  ///< stands for "separated by blanks"

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view unquoted(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return quoted ? trimmed(text.substr(1, text.size() - 2)) : text;
}

/// The lines that hold something, without comments; all views look into the text.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty() && line.front() != '#') lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// The first of these that a line contains; a semicolon leaves the comma to be the decimal sign.
char separator_of(std::string_view line) {
  for (const char c : {';', ',', '\t'}) {
    if (line.find(c) != std::string_view::npos) return c;
  }
  return kBlanks;
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  if (separator == kBlanks) {
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
      const std::size_t end = std::min(line.find_first_of(" \f\v"), line.size());
      fields.push_back(unquoted(line.substr(0, end)));
      line.remove_prefix(end);
    }
    return fields;
  }
  for (;;) {
    const std::size_t end = line.find(separator);
    fields.push_back(unquoted(trimmed(line.substr(0, end))));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::optional<double> number_of(std::string_view field, char separator) {
  if (separator != ';' || field.find(',') == std::string_view::npos) return parse_number(field);
  std::string with_point(field);
  with_point[with_point.find(',')] = '.';
  return parse_number(with_point);
}

/// "t" or "time", with or without a unit behind it: "Time [s]", "t (ms)", "time_s".
bool is_time(std::string_view name) {
  std::string lower(name.substr(0, name.find_first_of(" _([/")));
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower == "t" || lower == "time";
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  CsvTable read() {
    const std::vector<std::string_view> lines = lines_of(text_);
    if (lines.empty()) fail_at(source_, text_, 0, "there is no row in it");
    separator_ = separator_of(lines.front());
    const std::vector<std::string_view> first = fields_of(lines.front(), separator_);
    columns_ = first.size();
    const bool header = std::none_of(first.begin(), first.end(),
                                     [this](auto field) { return number_of(field, separator_).has_value(); });
    const bool timed = header && is_time(first.front());
    if (timed && columns_ < 2)
      fail(first.front(), "a time column alone is no curve, expected a column of values too");
    const std::size_t rows = lines.size() - (header ? 1 : 0);
    if (rows < 2) {
      fail_at(source_, text_, text_.size(),
              fmt::format("{} of numbers, a curve needs at least 2", rows == 0 ? "no row" : "1 row"));
    }
    for (std::size_t i = header ? 1 : 0; i < lines.size(); ++i) read_row(lines[i], timed);
    try {
      return {
          interpolate(times_, Points(static_cast<int>(columns_ - (timed ? 1 : 0)), std::move(coordinates_))),
          names_of(header ? first : std::vector<std::string_view>{}, timed), rows, header};
    } catch (const InvalidArgument&) {
      fail(lines.front(), "the rows are too unevenly spaced in time, or too large, to be interpolated");
    }
  }

 private:
  [[noreturn]] void fail(std::string_view where, const std::string& message) const {
    fail_at(source_, text_, static_cast<std::size_t>(where.data() - text_.data()), message);
  }

  /// Of the time, which may have no column, and of the values.
  [[nodiscard]] std::vector<std::string> names_of(const std::vector<std::string_view>& header,
                                                  bool timed) const {
    std::vector<std::string> names;
    if (!timed) names.emplace_back("t");
    for (std::size_t i = 0; i < columns_; ++i) {
      names.push_back(header.empty() ? fmt::format("x{}", i + 1) : std::string(header[i]));
    }
    return names;
  }

  void read_row(std::string_view line, bool timed) {
    const std::vector<std::string_view> fields = fields_of(line, separator_);
    if (fields.size() != columns_) {
      fail(line,
           fmt::format("a row of {} columns, expected {} as in the first row", fields.size(), columns_));
    }
    if (!timed) times_.push_back(static_cast<double>(times_.size()));
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const std::optional<double> value = number_of(fields[k], separator_);
      if (!value)
        fail(fields[k], fmt::format("column {}: expected a number, found '{}'", k + 1, shown(fields[k])));
      if (std::fabs(*value) > kLargestCoordinate) fail(fields[k], "the number lies beyond 1e300");
      if (timed && k == 0) {
        add_time(*value, fields[k]);
      } else {
        coordinates_.push_back(*value);
      }
    }
  }

  void add_time(double time, std::string_view field) {
    if (!times_.empty() && !(time > times_.back())) {
      fail(field,
           fmt::format("the time {} does not come after {}, that of the row before", time, times_.back()));
    }
    times_.push_back(time);
  }

  static std::string_view shown(std::string_view field) {
    constexpr std::size_t kShown = 30;
    return field.substr(0, kShown);
  }

  std::string_view text_;
  const std::string& source_;
  char separator_ = kBlanks;
  std::size_t columns_ = 0;
  std::vector<double> times_;
  std::vector<double> coordinates_;
};

}  // namespace

CsvTable parse_csv_table(std::string_view text, const std::string& source) {
  return CsvReader(without_bom(text), source).read();
}

Curve parse_csv(std::string_view text, const std::string& source) {
  return parse_csv_table(text, source).curve;
}

std::string format_csv(const Points& rows, std::span<const std::string> columns) {
  if (columns.size() != static_cast<std::size_t>(rows.dim())) {
    throw InvalidArgument(
        fmt::format("csv: {} names for {} columns, expected as many", columns.size(), rows.dim()));
  }
  std::string text;
  for (const std::string& name : columns) {
    if (&name != &columns.front()) text += ',';
    text += name.find_first_of(",;\t ") == std::string::npos ? name : '"' + name + '"';
  }
  text += '\n';
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (k > 0) text += ',';
      append_number(text, rows[i][k]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace v0
}  // namespace tandem
