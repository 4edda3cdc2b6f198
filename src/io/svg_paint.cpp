#include "io/svg_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/color_names.h"
#include "io/scan_number.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kWhite = 255.0;
constexpr int kMostReferences = 8;  // gradients that take their colours from other gradients

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\n\r\f";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

Paint color(double red, double green, double blue, double opacity = 1.0) {
  const auto in = [](double x) { return std::clamp(x, 0.0, kWhite); };
  return {Paint::Kind::color, {in(red), in(green), in(blue)}, std::clamp(opacity, 0.0, 1.0)};
}

/// #rgb, #rgba, #rrggbb, #rrggbbaa, without the #.
std::optional<Paint> parse_hex(std::string_view digits) {
  const std::size_t each = digits.size() <= 4 ? 1 : 2;
  const std::size_t count = digits.size() / each;
  if (digits.size() % each != 0 || count < 3 || count > 4) return std::nullopt;
  std::array<double, 4> values{0.0, 0.0, 0.0, kWhite};
  for (std::size_t i = 0; i < count; ++i) {
    int value = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const char c = digits[each * i + (each == 2 ? k : 0)];
      const bool number = c >= '0' && c <= '9';
      if (!number && (c < 'a' || c > 'f')) return std::nullopt;
      value = 16 * value + (number ? c - '0' : c - 'a' + 10);
    }
    values[i] = value;
  }
  return color(values[0], values[1], values[2], values[3] / kWhite);
}

struct Argument {
  double value = 0.0;
  bool percent = false;
  [[nodiscard]] double of(double whole) const { return percent ? value / 100.0 * whole : value; }
};

/// The numbers between the brackets of a function; separated by blanks, commas or a slash.
std::optional<std::vector<Argument>> arguments_of(std::string_view text) {
  std::vector<Argument> arguments;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\n\r\f,/"), text.size()));
    if (text.empty()) return arguments;
    const std::optional<ScannedNumber> number = scan_number(text);
    if (!number || !std::isfinite(number->value)) return std::nullopt;
    text.remove_prefix(number->length);
    const bool percent = !text.empty() && text.front() == '%';
    if (percent) text.remove_prefix(1);
    if (text.substr(0, 3) == "deg") text.remove_prefix(3);
    arguments.push_back({number->value, percent});
  }
}

/// CSS Color 4, section 7: hue in degrees, the others in [0,1].
Paint hsl(double hue, double saturation, double lightness, double opacity) {
  const auto channel = [&](double n) {
    const double k = std::fmod(std::fmod(n + hue / 30.0, 12.0) + 12.0, 12.0);
    const double a = saturation * std::min(lightness, 1.0 - lightness);
    return kWhite * (lightness - a * std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0})));
  };
  return color(channel(0.0), channel(8.0), channel(4.0), opacity);
}

std::optional<Paint> parse_function(const std::string& text) {
  const std::size_t open = text.find('(');
  if (open == std::string::npos || text.back() != ')') return std::nullopt;
  const std::string name = text.substr(0, open);
  const auto arguments = arguments_of(std::string_view(text).substr(open + 1, text.size() - open - 2));
  if (!arguments || arguments->size() < 3 || arguments->size() > 4) return std::nullopt;
  const std::vector<Argument>& a = *arguments;
  const double opacity = a.size() == 4 ? a[3].of(1.0) : 1.0;
  if (name == "rgb" || name == "rgba")
    return color(a[0].of(kWhite), a[1].of(kWhite), a[2].of(kWhite), opacity);
  if (name != "hsl" && name != "hsla") return std::nullopt;
  const auto share = [](const Argument& x) { return std::clamp(x.value / 100.0, 0.0, 1.0); };
  return hsl(a[0].value, share(a[1]), share(a[2]), opacity);
}

std::optional<Paint> parse_color(std::string_view text) {
  const std::string word = lower(trimmed(text));
  if (word.empty()) return std::nullopt;
  if (word == "none" || word == "transparent") return Paint{};
  if (word == "currentcolor") return Paint{Paint::Kind::current, {}, 1.0};
  if (word.front() == '#') return parse_hex(std::string_view(word).substr(1));
  const auto found =
      std::lower_bound(kColorNames.begin(), kColorNames.end(), word,
                       [](const ColorName& name, const std::string& wanted) { return name.name < wanted; });
  if (found == kColorNames.end() || found->name != word) return parse_function(word);
  return color((found->rgb >> 16U) & 0xFFU, (found->rgb >> 8U) & 0xFFU, found->rgb & 0xFFU);
}

/// What a <stop> says in its style attribute or in one of its own.
std::optional<Paint> stop_color(const pugi::xml_node& stop) {
  const std::string style = stop.attribute("style").value();
  constexpr std::string_view kProperty = "stop-color:";
  const std::size_t at = style.find(kProperty);
  if (at == std::string::npos) return parse_color(stop.attribute("stop-color").value());
  const std::string_view value = std::string_view(style).substr(at + kProperty.size());
  return parse_color(value.substr(0, value.find(';')));
}

std::optional<Paint> gradient_color(const SvgDocument& document, std::string id) {
  for (int i = 0; i < kMostReferences; ++i) {
    const pugi::xml_node node = document.find(id);
    for (const pugi::xml_node& stop : node.children()) {
      if (document.name(stop) != "stop") continue;
      if (const auto paint = stop_color(stop)) return paint;
    }
    const pugi::xml_attribute plain = node.attribute("href");
    const std::string reference = plain ? plain.value() : node.attribute("xlink:href").value();
    if (reference.size() < 2) return std::nullopt;
    id = reference.substr(1);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Paint> parse_paint(std::string_view text, const SvgDocument& document) {
  text = trimmed(text);
  if (lower(text.substr(0, 4)) != "url(") return parse_color(text);
  const std::size_t end = text.find(')');
  if (end == std::string_view::npos) return std::nullopt;
  std::string id;
  for (const char c : text.substr(4, end - 4)) {
    if (std::string_view("\"'# ").find(c) == std::string_view::npos) id += c;
  }
  if (const auto paint = gradient_color(document, id)) return paint;
  if (const auto paint = parse_color(text.substr(end + 1))) return paint;
  return color(0.0, 0.0, 0.0);
}

std::optional<double> parse_opacity(std::string_view text) {
  text = trimmed(text);
  const bool percent = !text.empty() && text.back() == '%';
  if (percent) text.remove_suffix(1);
  const std::optional<double> number = parse_number(text);
  if (!number) return std::nullopt;
  return std::clamp(percent ? *number / 100.0 : *number, 0.0, 1.0);
}

std::optional<LineCap> parse_line_cap(std::string_view text) {
  const std::string word = lower(trimmed(text));
  if (word == "butt") return LineCap::butt;
  if (word == "round") return LineCap::round;
  if (word == "square") return LineCap::square;
  return std::nullopt;
}

std::optional<LineJoin> parse_line_join(std::string_view text) {
  const std::string word = lower(trimmed(text));
  if (word == "round") return LineJoin::round;
  if (word == "bevel") return LineJoin::bevel;
  if (word.substr(0, 5) == "miter") return LineJoin::miter;
  return std::nullopt;
}

std::optional<double> parse_miter_limit(std::string_view text) {
  const std::optional<double> number = parse_number(trimmed(text));
  return number && *number >= 1.0 ? number : std::nullopt;
}

}  // namespace v0
}  // namespace tandem
