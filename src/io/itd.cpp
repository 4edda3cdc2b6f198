#include "tandem/io/itd.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/itd_lexer.h"
#include "io/limits.h"
#include "io/scan_number.h"
#include "io/text_position.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Coordinates that a point type can have, E1..E9 and P1..P9.
constexpr int kMostCoordinates = 9;

/// Objects that hold curves which are no curves of the scene: trimming loops, boundaries in a parameter
/// plane.
constexpr std::array<std::string_view, 11> kPassedOver = {"SURFACE",   "TRIMSRF",  "MODEL",   "TRISRF",
                                                          "TRIVAR",    "MULTIVAR", "POLYGON", "POLYLINE",
                                                          "POINTLIST", "STRING",   "INSTANCE"};

class ItdReader {
 public:
  ItdReader(std::string_view text, const std::string& source) : lexer_(text, source) {}

  std::vector<Curve> read() {
    for (;;) {
      const ItdToken token = lexer_.next();
      if (token.kind == ItdKind::end) return std::move(curves_);
      if (token.kind != ItdKind::open) continue;
      const ItdToken name = lexer_.peek();
      if (name.kind != ItdKind::word) continue;
      if (name.text == "CURVE") {
        lexer_.next();
        read_curve(token.offset);
      } else if (std::find(kPassedOver.begin(), kPassedOver.end(), name.text) != kPassedOver.end()) {
        skip_list();
      }
    }
  }

 private:
  struct PointType {
    int coordinates = 0;
    bool rational = false;
  };

  /// After "[CURVE". The attributes in front of the counts are lists of their own.
  void read_curve(std::size_t offset) {
    const ItdToken kind = lexer_.next();
    const bool bspline = kind.kind == ItdKind::word && kind.text == "BSPLINE";
    if (!bspline && !(kind.kind == ItdKind::word && kind.text == "BEZIER")) {
      lexer_.fail_expected("BEZIER or BSPLINE", kind);
    }
    skip_attributes();
    const std::size_t n = count("the number of points");
    const std::size_t order = bspline ? count("the order") : n;
    const PointType type = point_type();
    if (order < 2) lexer_.fail(offset, fmt::format("order {} is a set of points; expected 2 or more", order));
    if (n < order) {
      lexer_.fail(offset,
                  fmt::format("{} points are too few for order {}, expected at least {}", n, order, order));
    }
    if (order > static_cast<std::size_t>(kLargestDegree) + 1) {
      lexer_.fail(offset,
                  fmt::format("order {} is beyond the largest that is read, {}", order, kLargestDegree + 1));
    }
    const KnotVector knots = bspline ? read_knots(n, order) : KnotVector{};
    std::vector<double> weights;
    Points points = read_points(n, type, weights);
    const ItdToken end = lexer_.next();
    if (end.kind != ItdKind::close) lexer_.fail_expected(fmt::format("']' after {} points", n), end);
    if (knots.periodic) repeat_first(points, weights, order - 1);
    try {
      curves_.push_back(
          bspline ? Curve(static_cast<int>(order) - 1, knots.values, std::move(points), std::move(weights))
                  : Curve::bezier(std::move(points), std::move(weights)));
    } catch (const InvalidArgument& error) {
      lexer_.fail(offset, error.what());
    }
  }

  struct KnotVector {
    std::vector<double> values;
    bool periodic = false;
  };

  /// [KV ...] or, for a periodic curve, [KVP ...], whose knots go once round: order - 1 more of them.
  KnotVector read_knots(std::size_t n, std::size_t order) {
    expect(ItdKind::open, "'[KV' or '[KVP'");
    const ItdToken name = lexer_.next();
    if (name.kind != ItdKind::word || (name.text != "KV" && name.text != "KVP")) {
      lexer_.fail_expected("KV or KVP", name);
    }
    KnotVector knots;
    knots.periodic = name.text == "KVP";
    const std::size_t length = n + order + (knots.periodic ? order - 1 : 0);
    while (lexer_.peek().kind == ItdKind::word) {
      const std::size_t offset = lexer_.peek().offset;
      knots.values.push_back(number("a knot"));
      if (std::fabs(knots.values.back()) > kLargestCoordinate)
        lexer_.fail(offset, "the knot lies beyond 1e300");
    }
    const ItdToken end = lexer_.next();
    if (end.kind != ItdKind::close) lexer_.fail_expected("a knot", end);
    if (knots.values.size() != length) {
      lexer_.fail(name.offset,
                  fmt::format("{} knots, expected {} ({} points, order {}{})", knots.values.size(), length, n,
                              order, knots.periodic ? ", periodic" : ""));
    }
    return knots;
  }

  Points read_points(std::size_t n, const PointType& type, std::vector<double>& weights) {
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < n; ++i) {
      expect(ItdKind::open, "'[' of a point");
      skip_attributes();
      double weight = 1.0;
      if (type.rational) {
        const std::size_t offset = lexer_.peek().offset;
        weight = number("a weight");
        if (!(weight > 0.0))
          lexer_.fail(offset, fmt::format("the weight is {}, expected more than 0", weight));
        weights.push_back(weight);
      }
      for (int k = 0; k < type.coordinates; ++k) {
        const std::size_t offset = lexer_.peek().offset;
        const double coordinate = number("a coordinate") / weight;  // P types hold (w, w x, w y, ...)
        if (!(std::fabs(coordinate) <= kLargestCoordinate)) {
          lexer_.fail(offset, "the coordinate (divided by its weight) lies beyond 1e300");
        }
        coordinates.push_back(coordinate);
      }
      const ItdToken end = lexer_.next();
      if (end.kind != ItdKind::close) {
        lexer_.fail_expected(fmt::format("']' after {} numbers", type.coordinates + (type.rational ? 1 : 0)),
                             end);
      }
    }
    return Points(type.coordinates, std::move(coordinates));
  }

  /// The control points that a periodic curve leaves out.
  static void repeat_first(Points& points, std::vector<double>& weights, std::size_t degree) {
    for (std::size_t i = 0; i < degree; ++i) {
      const Point point(points[i].begin(), points[i].end());
      points.push_back(point);
      if (!weights.empty()) weights.push_back(weights[i]);
    }
  }

  std::size_t count(std::string_view what) {
    const ItdToken token = lexer_.next();
    constexpr std::size_t kMostDigits = 9;
    const bool digits =
        token.kind == ItdKind::word && token.text.size() <= kMostDigits &&
        std::all_of(token.text.begin(), token.text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits) lexer_.fail_expected(what, token);
    return static_cast<std::size_t>(*parse_number(token.text));
  }

  PointType point_type() {
    const ItdToken token = lexer_.next();
    const bool fits = token.kind == ItdKind::word && token.text.size() == 2 &&
                      (token.text[0] == 'E' || token.text[0] == 'P') && token.text[1] >= '1' &&
                      token.text[1] <= '9';
    if (!fits) lexer_.fail_expected("a point type, E1 to E9 or P1 to P9", token);
    return {token.text[1] - '0', token.text[0] == 'P'};
  }

  double number(std::string_view what) {
    const ItdToken token = lexer_.next();
    const std::optional<double> value =
        token.kind == ItdKind::word ? parse_number(token.text) : std::optional<double>();
    if (!value) lexer_.fail_expected(what, token);
    return *value;
  }

  void expect(ItdKind kind, std::string_view what) {
    const ItdToken token = lexer_.next();
    if (token.kind != kind) lexer_.fail_expected(what, token);
  }

  /// Lists like [COLOR 4] or [rgb "255,0,0"].
  void skip_attributes() {
    while (lexer_.peek().kind == ItdKind::open) {
      lexer_.next();
      skip_list();
    }
  }

  /// To the bracket that closes the list just opened.
  void skip_list() {
    for (std::size_t depth = 1; depth > 0;) {
      const ItdToken token = lexer_.next();
      if (token.kind == ItdKind::open) ++depth;
      if (token.kind == ItdKind::close) --depth;
    }
  }

  ItdLexer lexer_;
  std::vector<Curve> curves_;
};

/// What to write for w * x so that dividing by w gives x again. Where no double does that (w * x near the
/// lower end of a binade, x near the upper end of its own), the product, which reads back within one unit in
/// the last place.
double premultiplied(double x, double w) {
  const double product = x * w;
  for (const double toward :
       {product, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
    const double candidate = std::nextafter(product, toward);
    if (candidate / w == x) return candidate;
  }
  return product;
}

void append_itd(std::string& out, const Curve& curve, std::size_t index) {
  const auto to = std::back_inserter(out);
  fmt::format_to(to, "[OBJECT CURVE{}\n  [CURVE BSPLINE {} {} {}{}\n    [KV", index, curve.size(),
                 curve.degree() + 1, curve.is_rational() ? 'P' : 'E', curve.dim());
  for (const double knot : curve.knots()) fmt::format_to(to, " {}", knot);
  out += "]\n";
  for (std::size_t i = 0; i < curve.size(); ++i) {
    out += "    [";
    const double weight = curve.is_rational() ? curve.weights()[i] : 1.0;
    if (curve.is_rational()) fmt::format_to(to, "{} ", weight);
    const std::span<const double> point = curve.control_points()[i];
    for (std::size_t k = 0; k < point.size(); ++k) {
      const double coordinate = curve.is_rational() ? premultiplied(point[k], weight) : point[k];
      if (!std::isfinite(coordinate)) {
        throw InvalidArgument(
            fmt::format("curve {}, point {}: {} times its weight overflows", index, i, point[k]));
      }
      fmt::format_to(to, "{}{}", k == 0 ? "" : " ", coordinate);
    }
    out += "]\n";
  }
  out += "  ]\n]\n";
}

}  // namespace

std::vector<Curve> parse_itd(std::string_view text, const std::string& source) {
  text = without_bom(text);
  std::vector<Curve> curves = ItdReader(text, source).read();
  if (curves.empty()) fail_at(source, text, 0, "there is no [CURVE ...] in it");
  return curves;
}

std::string format_itd(std::span<const Curve> curves) {
  std::string out;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].dim() > kMostCoordinates) {
      throw InvalidArgument(fmt::format("curve {} has {} coordinates, an ITD file holds at most {}", i,
                                        curves[i].dim(), kMostCoordinates));
    }
    append_itd(out, curves[i], i);
  }
  return out;
}

}  // namespace v0
}  // namespace tandem
