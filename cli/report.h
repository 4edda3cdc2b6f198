#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "messages.h"
#include "tandem/match/match.h"
#include "tandem/shape/shape.h"

namespace cli {

/// Two contours that were matched.
struct ContourMatch {
  std::size_t a = 0;
  std::size_t b = 0;
  const tandem::Match* match = nullptr;
};

/// What matching two shapes brought.
struct ShapeReport {
  std::vector<ContourMatch> pairs;
  std::vector<std::size_t> unmatched_a;  ///< contours without a partner: left over, or points
  std::vector<std::size_t> unmatched_b;

  [[nodiscard]] bool valid() const;
};

/// Contours are paired in order. match_of(i): the match of contours i, nullptr when there is none.
[[nodiscard]] ShapeReport make_report(std::size_t contours_a, std::size_t contours_b,
                                      const std::function<const tandem::Match*(std::size_t)>& match_of);

/// A JSON number; null where there is none (NaN, infinity).
[[nodiscard]] std::string json_number(double value);

/// The text without blanks and newlines at its end.
[[nodiscard]] std::string trimmed(std::string text);

/// A JSON string with its quotes.
[[nodiscard]] std::string json_string(std::string_view text);

/// docs/interface.md, "The match report".
[[nodiscard]] std::string format_report(const ShapeReport& report);

/// The same for people, a few lines.
[[nodiscard]] std::string format_table(const ShapeReport& report);

/// Says so when the match is not valid, or when contours have no partner.
/// key: the place of the first of both shapes among all, from 0.
void warn(const Messages& messages, const ShapeReport& report, std::size_t key = 0);

/// "A", "B", ..., "shape 27": how messages name the inputs.
[[nodiscard]] std::string key_name(std::size_t key);

}  // namespace cli
