#include "io/svg_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>

#include "io/limits.h"
#include "io/scanner.h"

namespace tandem {
inline namespace v0 {
namespace {

struct Unit {
  std::string_view name;
  double pixels;
};

constexpr double kPixelsPerInch = 96.0;
constexpr double kFontSize = 16.0;

constexpr std::array<Unit, 12> kUnits = {{{"", 1.0},
                                          {"px", 1.0},
                                          {"pt", kPixelsPerInch / 72.0},
                                          {"pc", kPixelsPerInch / 6.0},
                                          {"in", kPixelsPerInch},
                                          {"cm", kPixelsPerInch / 2.54},
                                          {"mm", kPixelsPerInch / 25.4},
                                          {"Q", kPixelsPerInch / 101.6},
                                          {"em", kFontSize},
                                          {"rem", kFontSize},
                                          {"ex", kFontSize / 2.0},
                                          {"ch", kFontSize / 2.0}}};

/// One function of a transform list and its numbers.
class TransformFunction {
 public:
  TransformFunction(Scanner& scanner, std::string_view name, std::size_t offset)
      : name_(name), offset_(offset) {
    scanner.skip_blanks();
    if (!scanner.accept('(')) scanner.fail_expected(fmt::format("'(' after {}", name_));
    scanner.skip_blanks();
    while (!scanner.accept(')')) {
      if (count_ == numbers_.size()) scanner.fail_expected("')'");
      numbers_[count_++] = scanner.number(fmt::format("a number of {}", name_));
      const std::size_t unit_offset = scanner.position();
      const std::string_view unit = scanner.word();
      if (!unit.empty() && unit != "px" && unit != "deg") {
        Scanner::fail(unit_offset,
                      fmt::format("the unit '{}' of {} is not known, expected px or deg", unit, name_));
      }
      const bool comma = scanner.skip_comma_and_blanks();
      if (comma && !scanner.number_follows()) scanner.fail_expected("a number after the comma");
    }
  }

  [[nodiscard]] Transform map() const {
    const auto& n = numbers_;
    if (name_ == "matrix") return expect({6}), Transform{n[0], n[1], n[2], n[3], n[4], n[5]};
    if (name_ == "translate") return expect({1, 2}), Transform::translate(n[0], n[1]);
    if (name_ == "scale") return expect({1, 2}), Transform::scale(n[0], count_ == 2 ? n[1] : n[0]);
    if (name_ == "rotate") {
      expect({1, 3});
      return Transform::translate(n[1], n[2]) * Transform::rotate_degrees(n[0]) *
             Transform::translate(-n[1], -n[2]);
    }
    if (name_ == "skewX") return expect({1}), Transform::skew_x_degrees(n[0]);
    if (name_ == "skewY") return expect({1}), Transform::skew_y_degrees(n[0]);
    if (name_ == "translateX") return expect({1}), Transform::translate(n[0], 0.0);
    if (name_ == "translateY") return expect({1}), Transform::translate(0.0, n[0]);
    if (name_ == "scaleX") return expect({1}), Transform::scale(n[0], 1.0);
    if (name_ == "scaleY") return expect({1}), Transform::scale(1.0, n[0]);
    Scanner::fail(offset_,
                  fmt::format("unknown transform '{}', expected matrix, translate, scale, rotate, skewX or "
                              "skewY",
                              name_));
  }

 private:
  void expect(std::initializer_list<std::size_t> counts) const {
    if (std::find(counts.begin(), counts.end(), count_) != counts.end()) return;
    std::string wanted;
    for (const std::size_t count : counts) wanted += fmt::format("{}{}", wanted.empty() ? "" : " or ", count);
    Scanner::fail(offset_, fmt::format("{} has {} numbers, expected {}", name_, count_, wanted));
  }

  std::string_view name_;
  std::size_t offset_;
  std::array<double, 6> numbers_{};
  std::size_t count_ = 0;
};

bool is_finite(const Transform& t) {
  const std::array<double, 6> numbers = {t.a, t.b, t.c, t.d, t.e, t.f};
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// 0, 1/2 or 1 for Min, Mid, Max.
std::optional<double> alignment(std::string_view word) {
  if (word == "Min") return 0.0;
  if (word == "Mid") return 0.5;
  if (word == "Max") return 1.0;
  return std::nullopt;
}

}  // namespace

Transform parse_transform(std::string_view text) {
  Scanner scanner(text);
  Transform result;
  bool comma = false;
  for (scanner.skip_blanks(); !scanner.at_end() || comma; comma = scanner.skip_comma_and_blanks()) {
    const std::size_t offset = scanner.position();
    const std::string_view name = scanner.word();
    if (name.empty()) scanner.fail_expected("a transform such as translate(1 2)");
    if (name == "none" && scanner.at_end()) break;
    result = result * TransformFunction(scanner, name, offset).map();
    if (!is_finite(result))
      Scanner::fail(offset, "the transforms multiply to something beyond the range of numbers");
  }
  return result;
}

SvgLength parse_length(std::string_view text) {
  Scanner scanner(text);
  scanner.skip_blanks();
  SvgLength length;
  if (!scanner.number_follows() && scanner.word() == "auto") {
    length.kind = SvgLength::Kind::automatic;
  } else {
    length.value = scanner.number("a length");
    const std::size_t offset = scanner.position();
    if (scanner.accept('%')) {
      length.kind = SvgLength::Kind::percent;
    } else {
      const std::string_view name = scanner.word();
      const auto unit =
          std::find_if(kUnits.begin(), kUnits.end(), [name](const Unit& u) { return u.name == name; });
      if (unit == kUnits.end()) Scanner::fail(offset, fmt::format("the unit '{}' is not known", name));
      length.value *= unit->pixels;
    }
  }
  scanner.skip_blanks();
  if (!scanner.at_end()) scanner.fail_expected("the end of the length");
  if (std::fabs(length.value) > kLargestCoordinate) Scanner::fail(0, "the length lies beyond 1e300");
  return length;
}

ViewBox parse_view_box(std::string_view text) {
  Scanner scanner(text);
  std::array<double, 4> numbers{};
  scanner.skip_blanks();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) scanner.skip_comma_and_blanks();
    const std::size_t offset = scanner.position();
    numbers[i] = scanner.number("four numbers: min-x min-y width height");
    if (std::fabs(numbers[i]) > kLargestCoordinate) Scanner::fail(offset, "the number lies beyond 1e300");
    if (i >= 2 && numbers[i] < 0.0)
      Scanner::fail(offset, fmt::format("a size of {} is negative", numbers[i]));
  }
  scanner.skip_blanks();
  if (!scanner.at_end()) scanner.fail_expected("the end after four numbers");
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Transform fit_view_box(const ViewBox& box, double width, double height,
                       std::string_view preserve_aspect_ratio) {
  Scanner scanner(preserve_aspect_ratio);
  scanner.skip_blanks();
  std::string_view align = scanner.word();
  if (align == "defer") {  // SVG 1.1
    scanner.skip_blanks();
    align = scanner.word();
  }
  double scale_x = width / box.width;
  double scale_y = height / box.height;
  if (align == "none") {
    return Transform::scale(scale_x, scale_y) * Transform::translate(-box.x, -box.y);
  }
  if (align.empty()) align = "xMidYMid";
  const bool fits = align.size() == 8 && align[0] == 'x' && align[4] == 'Y';
  const std::optional<double> align_x = fits ? alignment(align.substr(1, 3)) : std::nullopt;
  const std::optional<double> align_y = fits ? alignment(align.substr(5, 3)) : std::nullopt;
  if (!align_x || !align_y)
    Scanner::fail(0, fmt::format("'{}': expected none, or something like xMidYMid", align));
  scanner.skip_blanks();
  const bool slice = scanner.word() == "slice";
  scale_x = scale_y = slice ? std::max(scale_x, scale_y) : std::min(scale_x, scale_y);
  const double left = (width - box.width * scale_x) * *align_x;
  const double top = (height - box.height * scale_y) * *align_y;
  return Transform::translate(left, top) * Transform::scale(scale_x, scale_y) *
         Transform::translate(-box.x, -box.y);
}

std::vector<Vec2> parse_point_list(std::string_view text) {
  Scanner scanner(text);
  std::vector<Vec2> points;
  bool comma = false;
  for (scanner.skip_blanks(); !scanner.at_end() || comma; comma = scanner.skip_comma_and_blanks()) {
    const double x = scanner.number("a number (x of a point)");
    scanner.skip_comma_and_blanks();
    const double y = scanner.number("a number (y of a point)");
    points.push_back({x, y});
  }
  return points;
}

}  // namespace v0
}  // namespace tandem
