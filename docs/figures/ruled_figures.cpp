#include "ruled_figures.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "line_drawing.h"
#include "sheet.h"
#include "tandem/curve/compatible.h"
#include "tandem/io/files.h"
#include "tandem/io/json.h"
#include "tandem/surface/hermite_surface.h"
#include "tandem/surface/ruled.h"

namespace tandem::figures {

namespace {

constexpr double kWidth = 330.0;
constexpr double kHeight = 240.0;

std::vector<Curve> curves_of(const char* name) {
  return parse_json_curves(read_file(fmt::format("examples/data/{}", name)));
}

/// Ruled by the parameters that the curves have.
Surface naive(const Curve& a, const Curve& b) {
  const std::vector<Curve> rails = with_common_denominator(std::array<Curve, 2>{a, b});
  return Surface::of_rows(rails, 1, {0, 0, 1, 1});
}

/// Drawings side by side.
std::string side_by_side(const std::vector<LineDrawing>& drawings) {
  std::string svg;
  for (std::size_t k = 0; k < drawings.size(); ++k) {
    svg += fmt::format("<g transform=\"translate({:.0f} 0)\">\n{}</g>\n", kWidth * static_cast<double>(k),
                       drawings[k].svg(kWidth, kHeight));
  }
  return svg;
}

std::string pair_of(const std::string& label, const Surface& left, const Surface& right, int rulings) {
  std::vector<LineDrawing> drawings(2);
  drawings[0].add_rulings(left, rulings);
  drawings[1].add_rulings(right, rulings);
  Sheet sheet(kWidth, kHeight);
  sheet.add_svg(label, side_by_side(drawings), 2.0 * kWidth, kHeight);
  return sheet.svg();
}

/// [C] Figures 1(a) and 7(a).
std::string u_shapes() {
  const std::vector<Curve> u = curves_of("u_planar.json");
  return pair_of("By parameter (red: folded over), and in step", naive(u[0], u[1]), rule(u[0], u[1]).surface,
                 60);
}

/// A cubic near two periods of the cosine, from crest to crest, moved by (dx, dy).
Curve wave(double dx, double dy) {
  constexpr std::size_t kPoints = 50;
  Points points(2, kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double x = 4.0 * std::numbers::pi * static_cast<double>(i) / (kPoints - 1);
    points[i][0] = x + dx;
    points[i][1] = 3.0 * std::cos(x) + dy;
  }
  return Curve::clamped_uniform(3, std::move(points));
}

/// [C] Figure 3: equal tangents do not keep rulings from crossing.
std::string tangents_are_not_enough() {
  const Curve a = wave(0.0, 0.0);
  const Curve b = wave(2.0, 5.6);
  RuleOptions tangents;
  tangents.norm = NormKind::tangent;
  return pair_of("In step by tangents (red: folded over), and by the ruled norm",
                 rule(a, b, tangents).surface, rule(a, b).surface, 80);
}

/// [C] Figure 4: nothing helps.
std::string impossible() {
  const Curve a = Curve::bezier({{-3, -3}, {-1, 3}, {1, -3}, {3, 3}});
  const Curve b = Curve::bezier({{-3, 0}, {3, 0}});
  const Curve c = Curve::bezier({{0, 0}, {2, 3}, {4, 3}, {6, 0}});
  const Curve d = Curve::bezier({{0, 2}, {2, -1}, {4, 0}, {6, 3}});
  return pair_of("Curves that touch or cross: some of it folds over however they are matched",
                 rule(a, b).surface, rule(c, d).surface, 60);
}

/// [C] Figure 10.
std::string letters() {
  const std::vector<Curve> e_and_f = curves_of("letters_ef.json");
  return pair_of("E and F by parameter, and in step", naive(e_and_f[0], e_and_f[1]),
                 rule(e_and_f[0], e_and_f[1]).surface, 90);
}

/// A rail in space with one bump, at `place`.
Curve rail(double y, double z, double place) {
  Points points(3, 40);
  for (std::size_t i = 0; i < 40; ++i) {
    const double x = 0.3 * static_cast<double>(i);
    points[i][0] = x;
    points[i][1] = y;
    points[i][2] = z + 2.5 * std::exp(-2.0 * (x - place) * (x - place));
  }
  return Curve::clamped_uniform(3, std::move(points));
}

/// The Hermite surface by the parameters that the rails have.
Surface naive(const Rail& first, const Rail& second) {
  const std::vector<Curve> all = with_common_denominator(
      std::array<Curve, 4>{first.curve, first.tangents, second.tangents, second.curve});
  std::vector<Curve> rows = all;
  for (const std::size_t row : {1U, 2U}) {
    Points points = all[row].control_points();
    const std::span<const double> from = all[row == 1 ? 0 : 3].control_points().data();
    for (std::size_t i = 0; i < points.data().size(); ++i) {
      points.data()[i] = from[i] + (row == 1 ? 1.0 : -1.0) * points.data()[i] / 3.0;
    }
    rows[row] = Curve(all[row].degree(), all[row].knots(), std::move(points), all[row].weights());
  }
  return Surface::of_rows(rows, 3, {0, 0, 0, 0, 1, 1, 1, 1});
}

/// [C] Figures 1(b) and 7(b).
std::string blend() {
  const Rail first{rail(0.0, 0.0, 3.0), Curve::bezier({{0, 2, 4}, {0, 2, 4}})};
  const Rail second{rail(6.0, 0.5, 8.0), Curve::bezier({{0, 4, -4}, {0, 4, -4}})};
  std::vector<LineDrawing> drawings(2);
  const Surface surfaces[] = {naive(first, second), blend_rails(first, second).surface};
  for (std::size_t k = 0; k < 2; ++k) {
    drawings[k].add_lines_along(surfaces[k], 10);
    drawings[k].add_rulings(surfaces[k], 60);
  }
  Sheet sheet(kWidth, kHeight);
  sheet.add_svg("A blend of two rails by parameter, and in step", side_by_side(drawings), 2.0 * kWidth,
                kHeight);
  return sheet.svg();
}

}  // namespace

std::map<std::string, std::string> ruled_figures() {
  return {{"ruled-1.svg", u_shapes()},
          {"ruled-3.svg", tangents_are_not_enough()},
          {"ruled-4.svg", impossible()},
          {"ruled-7.svg", blend()},
          {"ruled-10.svg", letters()}};
}

}  // namespace tandem::figures
