// Makes the pictures of README.md and docs/.
//
//   make_figures DIR            writes them into DIR
//   make_figures --check DIR    fails if one of them differs from what it would write
//
// Run in the project's folder: it reads examples/data.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "certificate_figure.h"
#include "key_figures.h"
#include "morph_figures.h"
#include "ruled_figures.h"
#include "segment_figures.h"
#include "sheet.h"
#include "skin_figures.h"
#include "sweep_figure.h"
#include "tandem/io/files.h"
#include "tandem/io/load.h"
#include "tandem/io/match_picture.h"
#include "tandem/tandem.h"

namespace {

using namespace tandem;
using figures::Sheet;

const std::vector<double> kTimes = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};

std::vector<Shape> in_betweens(const Curve& a, const Curve& b, const MatchOptions& options) {
  const Morph morph(a, b, match(a, b, options));
  std::vector<Shape> shapes;
  shapes.reserve(kTimes.size());
  for (double s : kTimes) shapes.push_back(morph.at(s));
  return shapes;
}

Curve first_contour(const std::string& name) {
  return load_shape(name).contours.front();
}

/// Two silhouettes: the picture on the front page.
std::string front_page() {
  const Curve a = first_contour("examples/data/crow.svg");
  const Curve b = first_contour("examples/data/kangaroo.svg");
  Sheet sheet(150, 130);
  sheet.add_row("Point by point, as the files have it", figures::naive_in_betweens(a, b, kTimes));
  sheet.add_row("In step", in_betweens(a, b, {}));
  return sheet.svg();
}

/// [C] Figure 5: inner products, accumulated costs and the path, cell by cell.
std::string figure_5() {
  NodeTable table{4, 4, {.1, 0, .2, .4, .9, 0, .9, .2, .1, .3, .5, 0, 0, .2, 0, .4}, {}};
  table.invalid = {0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 1, 0};
  const std::vector<double> cost = accumulated_costs(table);
  const Path path = open_path(table);
  const auto on_path = [&](std::size_t i, std::size_t j) {
    for (const Node& n : path.nodes) {
      if (static_cast<std::size_t>(n.i) == i && static_cast<std::size_t>(n.j) == j) return true;
    }
    return false;
  };
  const auto grid = [&](double x0, const auto& text) {
    std::string svg;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const double x = x0 + 56.0 * static_cast<double>(j);
        const double y = 34.0 * static_cast<double>(i);
        svg += fmt::format(
            "<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"56\" height=\"34\" fill=\"{}\" stroke=\"#999\"/>"
            "<text class=\"middle\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n",
            x, y, on_path(i, j) ? "#f3d9a4" : "#fff", x + 28.0, y + 22.0, text(table.index(i, j)));
      }
    }
    return svg;
  };
  const std::string costs = grid(0.0, [&](std::size_t k) {
    return table.invalid[k] != 0 ? std::string("2m") : fmt::format("{:.1f}", table.cost[k]);
  });
  const std::string sums = grid(280.0, [&](std::size_t k) { return fmt::format("{:.1f}", cost[k]); });
  Sheet sheet(0, 0);
  sheet.add_svg("1 - &lt;T1,T2&gt; (2m = 8: invalid)  and  Cost(i,j); the optimal path is shaded",
                costs + sums, 504, 146);
  return sheet.svg();
}

/// [C] Figure 6: v(u) drawn over the discrete path, with the paper's own method and 30 coefficients.
std::string figure_6() {
  const Curve a = first_contour("examples/data/letter_e.json");
  const Curve b = first_contour("examples/data/letter_f.json");
  MatchOptions options;
  options.method = Method::paper;
  options.reduction = ReductionOptions{.coefficients = 30};
  return format_match_picture(a, b, match(a, b, options), options);
}

/// [C] Figure 9: E becomes F.
std::string figure_9() {
  const Curve a = first_contour("examples/data/letter_e.json");
  const Curve b = first_contour("examples/data/letter_f.json");
  // The F drawn with its start elsewhere, as an editor might leave it.
  const Curve shifted = with_domain(move_seam(b, b.domain().lo + 0.3 * b.domain().length()), b.domain());
  MatchOptions paper;
  paper.method = Method::paper;
  Sheet sheet(110, 140);
  sheet.add_row("Naive", figures::naive_in_betweens(a, shifted, kTimes));
  sheet.add_row("Matched as in the paper", in_betweens(a, shifted, paper));
  sheet.add_row("Matched elastically", in_betweens(a, shifted, {}));
  return sheet.svg();
}

/// A straight line with one wave in it: control points at the Greville abscissae of uniform cubic knots.
Curve wave(double start) {
  constexpr int kSpans = 100;
  std::vector<double> knots(3, 0.0);
  for (int k = 0; k <= kSpans; ++k) knots.push_back(static_cast<double>(k) / kSpans);
  knots.insert(knots.end(), 3, 1.0);
  Points points(2, kSpans + 3);
  for (std::size_t i = 0; i < kSpans + 3; ++i) {
    const double x = 10.0 * (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3.0;
    const double local = (x - start) / 2.0;
    points[i][0] = x;
    points[i][1] = local > 0.0 && local < 1.0 ? std::sin(2.0 * std::numbers::pi * local) : 0.0;
  }
  return Curve(3, knots, std::move(points));
}

/// [C] Figure 12: the wave is moved, not flattened and raised again.
std::string figure_12() {
  const Curve a = wave(1.5);
  const Curve b = wave(6.0);
  Sheet sheet(150, 60);
  sheet.add_row("Naive", figures::naive_in_betweens(a, b, kTimes));
  sheet.add_row("Matched elastically", in_betweens(a, b, {}));
  return sheet.svg();
}

/// Spec C11: an arrow that looks elsewhere, and grows a hook on its way.
std::string turn() {
  const Curve a = first_contour("M8 20V9H3L11 0L19 9H14V20Z");
  const Curve b = first_contour("M0 7H12V2L22 10L12 18V13H6V20H0Z");
  Sheet sheet(110, 100);
  sheet.add_row("As they lie", in_betweens(a, b, {}));
  sheet.add_row("In a frame that turns", in_betweens(a, b, {.rotate = true}));
  return sheet.svg();
}

/// Spec B2: one against several.
std::string cuts() {
  const auto row = [](const char* a, const char* b, bool cut) {
    const std::vector<Shape> keys = {load_shape(a), load_shape(b)};
    MorphOptions options;
    options.cuts = cut;
    const PathMorph morph(keys, options);
    std::vector<Shape> shapes;
    for (double s : kTimes) {
      shapes.emplace_back();
      for (const CubicPath& path : morph.at(s)) {
        const Curve contour = to_curve(path);
        if (contour.extent() > 1e-6) shapes.back().contours.push_back(contour);
      }
    }
    return shapes;
  };
  const char* play = "M6 4L20 12L6 20Z";
  const char* pause = "M5 4H10V20H5ZM14 4H19V20H14Z";
  Sheet sheet(110, 100);
  sheet.add_row("Cut", row(play, pause, true));
  sheet.add_row("--no-cut", row(play, pause, false));
  sheet.add_row("Cut in three", row("M2 10H22V14H2Z", "M2 10H6V14H2ZM10 10H14V14H10ZM18 10H22V14H18Z", true));
  return sheet.svg();
}

}  // namespace

int main(int argc, char** argv) {
  const bool check = argc == 3 && std::strcmp(argv[1], "--check") == 0;
  if (argc != 2 && !check) {
    std::fputs("usage: make_figures [--check] DIR\n", stderr);
    return 2;
  }
  const std::string folder = argv[argc - 1];
  try {
    std::map<std::string, std::string> pictures = {{"front-page.svg", front_page()},
                                                   {"figure-5.svg", figure_5()},
                                                   {"figure-6.svg", figure_6()},
                                                   {"figure-9.svg", figure_9()},
                                                   {"figure-12.svg", figure_12()},
                                                   {"turn.svg", turn()},
                                                   {"cuts.svg", cuts()}};
    pictures.merge(figures::segment_figures());
    pictures.merge(figures::key_figures());
    pictures.merge(figures::morph_figures());
    pictures.merge(figures::ruled_figures());
    pictures.merge(figures::skin_figures());
    pictures.merge(figures::sweep_figures());
    pictures.emplace("certificates.svg", figures::certificate_figure());
    int differ = 0;
    for (const auto& [name, svg] : pictures) {
      const std::string path = fmt::format("{}/{}", folder, name);
      if (!check) {
        write_file(path, svg);
      } else if (read_file(path) != svg) {
        fmt::print(stderr, "{} is not what the code draws now; look at it, and run ./dev docs\n", path);
        ++differ;
      }
    }
    return differ == 0 ? 0 : 1;
  } catch (const std::exception& e) {
    fmt::print(stderr, "make_figures: {}\n", e.what());
    return 1;
  }
}
