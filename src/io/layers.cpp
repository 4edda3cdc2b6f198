#include "io/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/ink.h"
#include "tandem/error.h"
#include "tandem/morph/key_times.h"

namespace tandem {
inline namespace v0 {
namespace {

// A half-way paint of two kinds is a color.
Paint mixed(const Paint& a, const Paint& b, double share) {
  if (share == 0.0) return a;
  if (share == 1.0) return b;
  Paint paint = a;
  if (a.kind != b.kind || a.kind == Paint::Kind::color) {
    const std::array<double, 3> from = rgb_of(a);
    const std::array<double, 3> to = rgb_of(b);
    paint.kind = Paint::Kind::color;
    for (std::size_t k = 0; k < 3; ++k) paint.rgb[k] = (1.0 - share) * from[k] + share * to[k];
  }
  paint.opacity = (1.0 - share) * a.opacity + share * b.opacity;
  return paint;
}

/// The key from which key `k` takes what it does not have: the nearest one before it, or else behind it.
template <class Has>
std::optional<std::size_t> lender(const std::vector<Style>& keys, std::size_t k, Has has) {
  for (std::size_t i = k + 1; i-- > 0;) {
    if (has(keys[i])) return i;
  }
  for (std::size_t i = k + 1; i < keys.size(); ++i) {
    if (has(keys[i])) return i;
  }
  return std::nullopt;
}

/// A fill that a key does not have is there, invisible; so is a line, without width. Caps and joins are one.
std::vector<Style> completed(const std::vector<Style>& keys) {
  std::vector<Style> result = keys;
  const auto fills = [](const Style& style) { return style.fill.paints(); };
  const auto strokes = [](const Style& style) { return style.stroke.paints(); };
  const std::optional<std::size_t> first = lender(keys, 0, strokes);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (!fills(keys[k])) {
      if (const auto from = lender(keys, k, fills)) result[k].fill = keys[*from].fill;
      result[k].fill.opacity = 0.0;
    }
    if (!first) continue;
    if (!strokes(keys[k])) {
      result[k].stroke = keys[*lender(keys, k, strokes)].stroke;
      result[k].stroke_width = 0.0;
    }
    result[k].line_cap = keys[*first].line_cap;
    result[k].line_join = keys[*first].line_join;
    result[k].miter_limit = keys[*first].miter_limit;
  }
  return result;
}

std::vector<std::size_t> contours_where(const PathMorph& morph, bool closed) {
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < morph.contours().size(); ++c) {
    if (morph.contours()[c].keys.front().is_closed() == closed) found.push_back(c);
  }
  return found;
}

std::vector<Layer> plain_layers(const PathMorph& morph, const View& view, const Paint& ink) {
  Style fill;
  fill.fill = ink;
  Style stroke;
  stroke.fill = Paint{};
  stroke.stroke = ink;
  stroke.stroke_width = stroke_width(view);
  stroke.line_join = LineJoin::round;  // and butt caps: a contour that has shrunk to a point draws nothing
  std::vector<Layer> layers;
  for (const bool closed : {true, false}) {
    std::vector<std::size_t> contours = contours_where(morph, closed);
    if (contours.empty()) continue;
    layers.push_back({closed ? "filled" : "stroked", std::move(contours),
                      std::vector<Style>(morph.key_count(), closed ? fill : stroke)});
  }
  return layers;
}

/// Per key whether the contour is more than the point that it is born from or dies to. Of open contours butt
/// caps draw nothing there, others a dot.
std::vector<bool> presence(const PathMorph& morph, std::size_t contour, LineCap cap) {
  std::vector<bool> present(morph.key_count(), true);
  if (cap == LineCap::butt && !morph.contours()[contour].keys.front().is_closed()) return present;
  for (std::size_t k = 0; k < morph.steps().size(); ++k) {
    const ContourStep& step = morph.steps()[k].contours[contour];
    if (!step.a) present[k] = false;
    if (!step.b) present[k + 1] = false;
  }
  return present;
}

struct Group {
  std::vector<bool> present;
  std::vector<std::size_t> contours;
};

/// Those that are always there first.
std::vector<Group> groups_of(const PathMorph& morph, LineCap cap) {
  std::vector<Group> groups{{std::vector<bool>(morph.key_count(), true), {}}};
  for (std::size_t c = 0; c < morph.contours().size(); ++c) {
    const std::vector<bool> present = presence(morph, c, cap);
    auto same = std::find_if(groups.begin(), groups.end(),
                             [&](const Group& group) { return group.present == present; });
    if (same == groups.end()) same = groups.insert(same, {present, {}});
    same->contours.push_back(c);
  }
  return groups;
}

}  // namespace

View view_of(const Look& look, const Box& box) {
  if (!look.view_box) return view_of(box);
  return {look.view_box->x, look.view_box->y, look.view_box->width, look.view_box->height};
}

View view_at(const PathMorph& morph, const Look& look, double s, std::span<const CubicPath> paths) {
  const View within = view_of(look, morph.box());
  if (s >= 0.0 && s <= 1.0) return within;
  Box box = morph.box();
  for (const CubicPath& path : paths) box.include(bounding_box(to_curve(path)));
  const View all = view_of(box);
  if (!look.view_box) return all;
  const double x = std::min(within.x, all.x);
  const double y = std::min(within.y, all.y);
  return {x, y, std::max(within.x + within.width, all.x + all.width) - x,
          std::max(within.y + within.height, all.y + all.height) - y};
}

std::vector<Layer> layers_of(const PathMorph& morph, const Look& look, const View& view, const Paint& ink) {
  if (look.styles.empty()) return plain_layers(morph, view, ink);
  if (look.styles.size() != morph.key_count()) {
    throw InvalidArgument(fmt::format("look: {} styles for {} keys, expected none, or one for each",
                                      look.styles.size(), morph.key_count()));
  }
  const std::vector<Style> keys = completed(look.styles);
  const bool fills = keys.front().fill.paints();
  const bool strokes = keys.front().stroke.paints();
  std::vector<std::size_t> all(morph.contours().size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = c;
  if (!strokes) return {{"filled", std::move(all), keys}};
  std::vector<Group> groups = groups_of(morph, keys.front().line_cap);
  if (groups.size() == 1) return {{fills ? "drawn" : "stroked", std::move(all), keys}};

  std::vector<Layer> layers;
  if (fills) {
    layers.push_back({"filled", std::move(all), keys});
    for (Style& style : layers.back().keys) style.stroke = Paint{};
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].contours.empty()) continue;
    const std::string name = g == 0 ? "stroked" : g == 1 ? "growing" : fmt::format("growing{}", g);
    layers.push_back({name, std::move(groups[g].contours), keys});
    for (std::size_t k = 0; k < keys.size(); ++k) {
      layers.back().keys[k].fill = Paint{};
      if (!groups[g].present[k]) layers.back().keys[k].stroke_width = 0.0;
    }
  }
  return layers;
}

Paint ink_paint() {
  return {Paint::Kind::color, {1.0 * kInkColor[0], 1.0 * kInkColor[1], 1.0 * kInkColor[2]}, 1.0};
}

Style style_at(const Layer& layer, std::span<const double> key_times, double s) {
  const KeyPosition at = locate_key(std::clamp(s, 0.0, 1.0), key_times);
  const Style& a = layer.keys[at.key];
  const Style& b = layer.keys[at.key + 1];
  Style style = a;
  style.fill = mixed(a.fill, b.fill, at.local);
  style.stroke = mixed(a.stroke, b.stroke, at.local);
  style.stroke_width = (1.0 - at.local) * a.stroke_width + at.local * b.stroke_width;
  return style;
}

std::array<double, 3> rgb_of(const Paint& paint) {
  return paint.kind == Paint::Kind::color ? paint.rgb : std::array<double, 3>{};
}

std::string color_text(const Paint& paint) {
  if (!paint.paints()) return "none";
  if (paint.kind == Paint::Kind::current) return "currentColor";
  if (paint.kind == Paint::Kind::automatic) return "black";
  const auto byte = [](double x) { return std::lround(std::clamp(x, 0.0, 255.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(paint.rgb[0]), byte(paint.rgb[1]), byte(paint.rgb[2]));
}

}  // namespace v0
}  // namespace tandem
