#include "certificate_figure.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "sheet.h"
#include "tandem/curve/curve.h"
#include "tandem/io/certificate_json.h"
#include "tandem/surface/certificate.h"
#include "tandem/surface/edit.h"
#include "tandem/surface/ruled.h"

namespace tandem::figures {

namespace {

constexpr double kWidth = 220.0;
constexpr double kHeight = 230.0;

/// Where the picture of one surface stands on the sheet.
struct Place {
  double x = 0.0;
  double y = 0.0;
  double scale = 1.0;

  [[nodiscard]] std::string at(const Point& p) const {
    return fmt::format("{:.2f} {:.2f}", x + scale * p[0], y - scale * p[1]);
  }
};

std::string stroke(std::string_view path, std::string_view color, double width) {
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path, color,
                     width);
}

double jacobian(const Surface& surface, double u, double v) {
  const Points d = surface.derivatives(u, v, 1);
  return d[1][0] * d[2][1] - d[1][1] * d[2][0];
}

/// Rulings, those with a Jacobian of the rarer sign in red, rails, and the witness's places.
std::string draw(const Surface& surface, const Place& place) {
  const Certificate certificate = certify(surface);
  const int wrong = certificate.witness && certificate.witness->places[0].jacobian < 0.0 ? -1 : 1;
  const bool folds = certificate.regular == Verdict::violated;
  std::string svg;
  const Interval domain = surface.domain(Along::u);
  constexpr int kRulings = 72;
  for (int i = 0; i <= kRulings; ++i) {
    const double u = domain.lo + domain.length() * i / kRulings;
    const bool red =
        folds && (wrong * jacobian(surface, u, 0.0) > 0.0 || wrong * jacobian(surface, u, 1.0) > 0.0);
    svg += stroke("M" + place.at(surface.evaluate(u, 0.0)) + "L" + place.at(surface.evaluate(u, 1.0)),
                  red ? "#e03131" : "#9db8cc", 0.8);
  }
  for (const double v : {0.0, 1.0}) {
    std::string path;
    for (int i = 0; i <= 240; ++i) {
      const double u = domain.lo + domain.length() * i / 240;
      path += (i == 0 ? "M" : "L") + place.at(surface.evaluate(u, v));
    }
    svg += stroke(path, "#1c3b54", 2.0);
  }
  if (certificate.witness) {
    for (const SurfacePlace& w : certificate.witness->places) {
      svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"#e8590c\" stroke=\"#fff\"/>\n",
                         place.x + place.scale * w.point[0], place.y - place.scale * w.point[1]);
    }
  }
  return svg + fmt::format(
                   "<text x=\"{:.0f}\" y=\"{:.0f}\" font-family=\"sans-serif\" font-size=\"13\" "
                   "text-anchor=\"middle\">{}</text>\n",
                   place.x, kHeight - 6.0, name(certificate.verdict));
}

Curve u_shape(bool outer) {
  const Points points = outer ? Points({{-3, 6},
                                        {-3, 5.2},
                                        {-3, 4.4},
                                        {-3, 3.6},
                                        {-3, 2.6},
                                        {-3, 1.2},
                                        {-2.6, -0.6},
                                        {0, -1.2},
                                        {3, -0.8},
                                        {3, 2.4},
                                        {3, 6}})
                              : Points({{-1.4, 6},
                                        {-1.4, 2.6},
                                        {-1.4, 0.9},
                                        {0, 0.5},
                                        {1.2, 0.8},
                                        {1.4, 1.8},
                                        {1.4, 2.8},
                                        {1.4, 3.7},
                                        {1.4, 4.5},
                                        {1.4, 5.3},
                                        {1.4, 6}});
  return Curve::clamped_uniform(3, points);
}

/// A strip that comes round and overlaps its own beginning: [C] Figure 4, right.
Curve spiral(double radius) {
  constexpr std::size_t kPoints = 30;
  Points points(2, kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double turn = 7.4 * static_cast<double>(i) / (kPoints - 1);
    const double r = radius + 0.04 * turn;
    points[i][0] = r * std::cos(turn);
    points[i][1] = r * std::sin(turn);
  }
  return Curve::clamped_uniform(3, points);
}

}  // namespace

std::string certificate_figure() {
  const Curve a = u_shape(true);
  const Curve b = u_shape(false);
  const Surface by_parameter = Surface::of_rows(std::array{a, b}, 1, {0, 0, 1, 1});
  const Surface around = Surface::of_rows(std::array{spiral(1.0), spiral(1.5)}, 1, {0, 0, 1, 1});
  const std::string svg = draw(by_parameter, {0.5 * kWidth, 170, 25}) +
                          draw(rule(a, b).surface, {1.5 * kWidth, 170, 25}) +
                          draw(around, {2.5 * kWidth, 105, 52});
  Sheet sheet(3 * kWidth, kHeight);
  sheet.add_svg("Paired by parameter; matched; regular, but its ends overlap", svg, 3 * kWidth, kHeight);
  return sheet.svg();
}

}  // namespace tandem::figures
