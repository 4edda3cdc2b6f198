#include "tandem/surface/skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "cad_cases.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/io/load.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

using testing::cad_case;

// Heights (z) of a row of samples along u.
struct Ridge {
  double height = 0.0;
  int peaks = 0;
};

Ridge ridge_at(const Surface& surface, double v) {
  const Curve c = iso_curve(surface, Along::u, v);
  constexpr int n = 2000;
  std::vector<double> z;
  for (int i = 0; i <= n; ++i) z.push_back(c.evaluate(c.domain().lo + c.domain().length() * i / n)[2]);
  Ridge ridge;
  ridge.height = *std::max_element(z.begin(), z.end());
  for (int i = 1; i < n; ++i)
    ridge.peaks += z[i] > 1e-6 * ridge.height && z[i] > z[i - 1] && z[i] >= z[i + 1] ? 1 : 0;
  return ridge;
}

struct Bells {
  double worst_ratio = 1e300;
  double best_ratio = 0.0;
  int most_peaks = 0;
};

// In-between heights against the linear blend of the neighbouring sections' heights.
Bells measure_bells(const Surface& surface, const std::vector<double>& v) {
  Bells bells;
  for (std::size_t j = 0; j + 1 < v.size(); ++j) {
    const double h0 = ridge_at(surface, v[j]).height;
    const double h1 = ridge_at(surface, v[j + 1]).height;
    for (int k = 0; k <= 16; ++k) {
      const double s = k / 16.0;
      const Ridge r = ridge_at(surface, (1.0 - s) * v[j] + s * v[j + 1]);
      const double ratio = r.height / ((1.0 - s) * h0 + s * h1);
      bells.worst_ratio = std::min(bells.worst_ratio, ratio);
      bells.best_ratio = std::max(bells.best_ratio, ratio);
      bells.most_peaks = std::max(bells.most_peaks, r.peaks);
    }
  }
  return bells;
}

// [C] Figure 14: a bell that wanders from section to section stays one bell of the same height.
TEST(Skin, KeepsTheBellsOfFigure14) {
  const std::vector<Curve> sections = cad_case("bells_5");
  const SkinnedSurface skinned = skin(sections);
  const Bells bells = measure_bells(skinned.surface, skinned.parameters);
  const Loft plain = loft(sections);
  const Bells naive = measure_bells(plain.surface, plain.parameters);
  std::printf("heights %.5f .. %.5f, %d peaks; by parameter %.3f, %d peaks; %zu x %zu, degree %d\n",
              bells.worst_ratio, bells.best_ratio, bells.most_peaks, naive.worst_ratio, naive.most_peaks,
              skinned.surface.size(Along::u), skinned.surface.size(Along::v),
              skinned.surface.degree(Along::u));
  std::printf("valid %d crease %g law %g interpolation %g cost %g\n", skinned.report.valid,
              skinned.report.crease_angle, skinned.report.law_deviation, skinned.report.interpolation_error,
              skinned.report.total_cost);
  EXPECT_GE(bells.worst_ratio, 0.995);
  EXPECT_LE(bells.best_ratio, 1.005);
  EXPECT_EQ(bells.most_peaks, 1);
  EXPECT_LE(naive.worst_ratio, 0.8);
  EXPECT_LE(skinned.report.crease_angle, std::numbers::pi / 180.0);
  EXPECT_LE(skinned.report.interpolation_error, 1e-9);
}

// Sections that are no graphs: closed, each turned round, started elsewhere and run at its own speed.
Curve blob(int k, double z) {
  constexpr int n = 40;
  Points points(3, n + 3);
  for (int i = 0; i < n + 3; ++i) {
    const double turns = static_cast<double>((i + 7 * k) % n) / n;
    const double a = 2 * std::numbers::pi * (k % 2 == 0 ? turns : 1.0 - turns);
    const double r =
        2.0 + 0.4 * std::cos(3 * a + 0.1 * k) + 0.5 * std::exp(-8.0 * (1.0 - std::cos(a - 0.2 * k)));
    points[static_cast<std::size_t>(i)][0] = r * std::cos(a);
    points[static_cast<std::size_t>(i)][1] = r * std::sin(a);
    points[static_cast<std::size_t>(i)][2] = z;
  }
  std::vector<double> knots;
  for (int i = 0; i < n + 7; ++i) knots.push_back(i);
  return Curve(3, knots, points);
}

std::vector<Curve> blobs(int count) {
  std::vector<Curve> sections;
  for (int k = 0; k < count; ++k) sections.push_back(blob(k, 1.5 * k));
  return sections;
}

// The same blobs round a ring, each in a half plane through the z axis.
std::vector<Curve> ring_of_blobs(int count) {
  std::vector<Curve> sections;
  for (int k = 0; k < count; ++k) {
    const double phi = 2 * std::numbers::pi * k / count;
    const Curve flat = blob(k, 0.0);
    Points points(3, flat.size());
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const auto p = flat.control_points()[i];
      points[i][0] = (7 + p[0]) * std::cos(phi);
      points[i][1] = (7 + p[0]) * std::sin(phi);
      points[i][2] = p[1];
    }
    sections.emplace_back(3, flat.knots(), points);
  }
  return sections;
}

double distance(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return std::sqrt(sum);
}

// Every point of the given section lies on the surface's curve at its v, and in the order of its law.
void expect_interpolated(const SkinnedSurface& skinned, const std::vector<Curve>& given) {
  EXPECT_LE(skinned.report.interpolation_error, 1e-9);
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Reparametrization& law = skinned.laws[k];
    const Interval own = given[k].domain();
    for (int i = 0; i <= 100; ++i) {
      const Interval u = skinned.surface.domain(Along::u);
      const double at = u.lo + u.length() * i / 100;
      double v = law.v.evaluate(at)[0];
      if (given[k].is_closed()) v -= std::floor((v - own.lo) / own.length()) * own.length();
      if (law.reversed) v = own.lo + own.hi - v;
      EXPECT_LE(distance(skinned.surface.evaluate(at, skinned.parameters[k]), given[k].evaluate(v)),
                1e-9 * skinned.surface.extent());
    }
  }
}

TEST(Skin, InterpolatesItsSections) {
  for (const std::vector<Curve>& sections : {cad_case("bells_5"), blobs(4)}) {
    const SkinnedSurface skinned = skin(sections);
    expect_interpolated(skinned, sections);
    for (const int degree : {1, 2, 3, 5}) {
      for (const LoftParameters parameters :
           {LoftParameters::chord, LoftParameters::centripetal, LoftParameters::uniform}) {
        const Loft made = loft(skinned.sections, {.degree = degree, .parameters = parameters});
        EXPECT_EQ(made.surface.degree(Along::v), std::min(degree, static_cast<int>(sections.size()) - 1));
        EXPECT_LE(made.deviation, 1e-12 * made.surface.extent());
        for (std::size_t k = 0; k < sections.size(); ++k) {
          const double u = 0.3 * skinned.sections[k].domain().hi + 0.7 * skinned.sections[k].domain().lo;
          EXPECT_LE(distance(made.surface.evaluate(u, made.parameters[k]), skinned.sections[k].evaluate(u)),
                    1e-9 * made.surface.extent());
        }
      }
    }
  }
}

TEST(Skin, FindsSeamsAndDirections) {
  const std::vector<Curve> sections = blobs(4);
  const SkinnedSurface skinned = skin(sections);
  EXPECT_TRUE(skinned.report.valid);
  EXPECT_TRUE(skinned.surface.is_closed(Along::u));
  for (const SkinPair& pair : skinned.report.pairs) {
    EXPECT_EQ(pair.direction, Direction::reversed);
    EXPECT_GT(pair.validity.min_dot, 0.5);
  }
  EXPECT_LE(skinned.report.crease_angle, std::numbers::pi / 180.0);
  // By parameter they run against each other.
  EXPECT_FALSE(check_validity(sections[0], sections[1]).valid);
}

// By the normals themselves, on both sides of every knot of the surface.
TEST(Skin, HasNoCreases) {
  for (const std::vector<Curve>& sections : {cad_case("bells_5"), cad_case("letters_EF"), blobs(3)}) {
    const Surface surface = skin(sections).surface;
    double worst = 0.0;
    for (const double u : surface.knots(Along::u)) {
      if (!surface.domain(Along::u).contains(u)) continue;
      for (double v = 0.0; v <= 1.0; v += 0.0625) {
        const Point a = surface.normal(u, v, {Side::left, Side::right});
        worst = std::max(worst, distance(a, surface.normal(u, v, {Side::right, Side::right})));
      }
    }
    EXPECT_LE(worst, std::numbers::pi / 180.0);
  }
}

// A rectangle with round corners as drawings have it: a cubic per side and per corner, G1, each over one unit
// of the parameter, so that the speed jumps at every joint.
Curve rounded(double width, double height, double radius, double turn, double z) {
  const double k = radius * 0.5522847498;
  const double w = 0.5 * width;
  const double h = 0.5 * height;
  std::vector<std::array<double, 2>> p = {{w, -h + radius}};
  const auto to = [&](double x1, double y1, double x2, double y2, double x, double y) {
    p.insert(p.end(), {{x1, y1}, {x2, y2}, {x, y}});
  };
  const auto line = [&](double x, double y) {
    const auto [x0, y0] = p.back();
    to((2 * x0 + x) / 3, (2 * y0 + y) / 3, (x0 + 2 * x) / 3, (y0 + 2 * y) / 3, x, y);
  };
  line(w, h - radius);
  to(w, h - radius + k, w - radius + k, h, w - radius, h);
  line(-w + radius, h);
  to(-w + radius - k, h, -w, h - radius + k, -w, h - radius);
  line(-w, -h + radius);
  to(-w, -h + radius - k, -w + radius - k, -h, -w + radius, -h);
  line(w - radius, -h);
  to(w - radius + k, -h, w, -h + radius - k, w, -h + radius);
  Points points(3, p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    points[i][0] = std::cos(turn) * p[i][0] - std::sin(turn) * p[i][1];
    points[i][1] = std::sin(turn) * p[i][0] + std::cos(turn) * p[i][1];
    points[i][2] = z;
  }
  std::vector<double> knots{0.0};
  for (int i = 0; i <= 8; ++i) knots.insert(knots.end(), 3, i);
  knots.push_back(8.0);
  return Curve(3, knots, points);
}

TEST(Skin, EvensOutTheSpeedAtJoints) {
  const std::vector<Curve> sections = {rounded(6, 3, 1, 0.0, 0), rounded(5, 4, 0.7, 0.35, 2),
                                       rounded(4, 4, 1.5, 0.6, 4)};
  const auto crease = [](const Surface& surface) {
    double worst = 0.0;
    for (const double u : surface.knots(Along::u)) {
      if (!surface.domain(Along::u).contains(u)) continue;
      for (double v = 0.0; v <= 1.0; v += 0.125) {
        const Point a = surface.normal(u, v, {Side::left, Side::right});
        worst = std::max(worst, distance(a, surface.normal(u, v, {Side::right, Side::right})));
      }
    }
    return worst;
  };
  const SkinnedSurface skinned = skin(sections);
  expect_interpolated(skinned, sections);
  EXPECT_LE(crease(skinned.surface), 1e-6);
  EXPECT_LE(skinned.report.crease_angle, 1e-6);
  // What is at stake: matched, but with the jumps left in.
  std::vector<Curve> jumping{sections.front()};
  for (const Match& m : match_chain(sections)) jumping.push_back(m.curve);
  EXPECT_GE(crease(loft(jumping).surface), 0.05);
}

// Drawings have joints that turn by less than a corner and more than nothing, and very short segments; the
// antlers of the last one have no counterpart, so that its law is as steep there as may be.
TEST(Skin, TakesDrawings) {
  std::vector<Curve> sections;
  for (const char* name : {"crow", "kangaroo", "deer"}) {
    const Curve flat = load_shape(std::string(TANDEM_EXAMPLE_DATA) + "/" + name + ".svg").contours.front();
    Points points(3, flat.size());
    for (std::size_t i = 0; i < flat.size(); ++i) {
      points[i][0] = flat.control_points()[i][0];
      points[i][1] = flat.control_points()[i][1];
      points[i][2] = 300.0 * static_cast<double>(sections.size());
    }
    sections.emplace_back(flat.degree(), flat.knots(), points);
  }
  const SkinnedSurface skinned = skin(sections);
  expect_interpolated(skinned, sections);
  for (const SkinPair& pair : skinned.report.pairs) EXPECT_GE(pair.validity.valid_share, 0.9);
  // No crease comes from the laws; what is left are the sections' own joints, which turn by up to 0.05 rad.
  EXPECT_LE(skinned.report.crease_angle, 1e-6);
  EXPECT_GE(skinned.report.section_crease_angle, 0.01);
  EXPECT_LE(skinned.report.section_crease_angle, 0.2);
  const SkinnedSurface two = skin(std::span(sections).first(2));
  EXPECT_LE(two.report.crease_angle, 1e-6);
  EXPECT_LE(two.report.section_crease_angle, 0.06);
}

// From section to section a bell wanders off; what was left of it at first is soon a hair of the parameter.
TEST(Skin, FollowsTheMatchThroughManySections) {
  std::vector<Curve> sections;
  for (int k = 0; k < 32; ++k) {
    constexpr int n = 50;
    Points points(3, n);
    for (int i = 0; i < n; ++i) {
      const double x = 10.0 * i / (n - 1);
      points[static_cast<std::size_t>(i)][0] = x;
      points[static_cast<std::size_t>(i)][1] = std::exp(-std::pow(x - 3.0 - 4.0 * std::sin(0.03 * k), 2.0));
      points[static_cast<std::size_t>(i)][2] = 0.3 * k;
    }
    sections.push_back(Curve::clamped_uniform(3, std::move(points)));
  }
  const SkinnedSurface skinned = skin(sections);
  EXPECT_TRUE(skinned.report.valid);
  EXPECT_LE(skinned.report.law_deviation, 0.005);
}

TEST(Skin, ClosesARing) {
  const std::vector<Curve> sections = ring_of_blobs(5);
  const SkinnedSurface skinned = skin(sections, {.loft = {.closed = true}});
  expect_interpolated(skinned, sections);
  EXPECT_TRUE(skinned.surface.is_closed(Along::u));
  EXPECT_TRUE(skinned.surface.is_closed(Along::v));
  EXPECT_EQ(skinned.report.pairs.size(), sections.size());
  EXPECT_TRUE(skinned.report.valid);
  // As smooth from the last section to the first as elsewhere.
  for (double u = 0.03; u < 1.0; u += 0.1) {
    const double at = skinned.surface.domain(Along::u).lo + u * skinned.surface.domain(Along::u).length();
    const Points end = skinned.surface.derivatives(at, 1.0, 2, {Side::right, Side::left});
    const Points start = skinned.surface.derivatives(at, 0.0, 2);
    for (const std::size_t row : {0, 1, 2, 5}) {
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(end[row][c], start[row][c], 1e-6 * skinned.surface.extent());
    }
  }
}

TEST(Skin, JointlyNeverCostsMore) {
  const auto compare = [](const char* name, const std::vector<Curve>& sections, bool ring) {
    const SkinnedSurface sequence =
        skin(sections,
             {.match = {.samples = {64, 64}}, .matching = SkinMatching::sequence, .loft = {.closed = ring}});
    const SkinnedSurface joint =
        skin(sections,
             {.match = {.samples = {64, 64}}, .matching = SkinMatching::joint, .loft = {.closed = ring}});
    std::printf("%s: in sequence %.5f, jointly %.5f in %d sweeps\n", name, sequence.report.total_cost,
                joint.report.total_cost, joint.report.sweeps);
    EXPECT_LE(joint.report.total_cost, sequence.report.total_cost);
    EXPECT_DOUBLE_EQ(joint.report.sequence_cost, sequence.report.total_cost);
    EXPECT_DOUBLE_EQ(sequence.report.sequence_cost, sequence.report.total_cost);
    return joint.report.total_cost / sequence.report.total_cost;
  };
  // A chain has nothing to gain but what samples and fits have lost.
  EXPECT_GE(compare("bells", cad_case("bells_5"), false), 0.95);
  compare("blobs", blobs(3), false);
  compare("ring", ring_of_blobs(5), true);
}

double top_of(const Curve& section) {
  double top = 0.0;
  for (double u = 0.0; u <= 1.0; u += 1e-3) top = section.evaluate(u)[2] > section.evaluate(top)[2] ? u : top;
  return top;
}

TEST(Skin, GoesThroughPins) {
  const std::vector<Curve> sections = cad_case("bells_5");
  // Near the tops, but not at them.
  std::vector<double> pin;
  for (const Curve& section : sections)
    pin.push_back(top_of(section) + 0.003 * static_cast<double>(pin.size()));
  const SkinnedSurface skinned = skin(sections, {.pins = {pin}});
  expect_interpolated(skinned, sections);
  for (std::size_t k = 0; k < sections.size(); ++k) {
    EXPECT_NEAR(skinned.laws[k].v.evaluate(pin[0])[0], pin[k], 1e-12) << k;
    EXPECT_LE(distance(skinned.surface.evaluate(pin[0], skinned.parameters[k]), sections[k].evaluate(pin[k])),
              1e-9 * skinned.surface.extent());
  }
  EXPECT_LE(skinned.report.crease_angle, std::numbers::pi / 180.0);
}

TEST(Skin, ApproximatesWithFewerRows) {
  const SkinnedSurface skinned = skin(blobs(9), {.loft = {.rows = 5}});
  const std::vector<Curve>& sections = skinned.sections;
  EXPECT_EQ(skinned.surface.size(Along::v), 5u);
  EXPECT_GT(skinned.report.interpolation_error, 1e-6);
  double before = 1e300;
  for (const int rows : {4, 6, 8, 9}) {
    const Loft made = loft(sections, {.rows = rows});
    EXPECT_EQ(made.surface.size(Along::v), static_cast<std::size_t>(rows));
    EXPECT_LT(made.deviation, before);
    before = made.deviation;
  }
  EXPECT_LE(before, 1e-9);
  const Loft loose = loft(sections, {.tolerance = 0.01});
  EXPECT_LT(loose.surface.size(Along::v), sections.size());
  EXPECT_LE(loose.deviation, 0.01 * loose.surface.extent() * 1.5);
}

// A quarter of a circle as a rational quadratic whose middle weight is scaled.
Curve arc(double radius, double z, double stretch) {
  const double w = std::sqrt(0.5) * stretch;
  return Curve(2, {0, 0, 0, 1, 1, 1}, Points({{radius, 0, z}, {radius, radius, z}, {0, radius, z}}),
               {1, w, stretch * stretch});
}

TEST(Skin, TakesRationalSections) {
  const std::vector<Curve> few = {arc(1, 0, 1), arc(2, 1, 1.5), arc(1, 3, 0.7)};
  const SkinnedSurface skinned = skin(few);
  expect_interpolated(skinned, few);
  for (std::size_t k = 0; k < few.size(); ++k) {
    const Curve section = iso_curve(skinned.surface, Along::u, skinned.parameters[k]);
    for (double u = 0.0; u <= 1.0; u += 0.1) {
      const Point p = section.evaluate(u);
      EXPECT_NEAR(std::hypot(p[0], p[1]), few[k].control_points()[0][0], 1e-12);
    }
  }
  // So many weights that a common denominator would be of too high a degree.
  std::vector<Curve> many;
  for (int k = 0; k < 20; ++k) many.push_back(arc(1 + 0.1 * std::sin(k), 0.2 * k, 1 + 0.3 * std::sin(2 * k)));
  const SkinnedSurface tall = skin(many);
  expect_interpolated(tall, many);
  EXPECT_LE(tall.surface.degree(Along::u), 25);
  EXPECT_FALSE(loft(tall.sections).common_denominator);
  EXPECT_TRUE(loft(skinned.sections).common_denominator);
}

// In the plane equal tangents do not keep a ring from folding: circles beside each other.
TEST(Skin, TellsThatAPlanarRingFolds) {
  const auto circle = [](double x, double r) {
    Points points(2, 19);
    std::vector<double> knots;
    for (std::size_t i = 0; i < 19; ++i) {
      points[i][0] = x + r * std::cos(2 * std::numbers::pi * static_cast<double>(i % 16) / 16);
      points[i][1] = r * std::sin(2 * std::numbers::pi * static_cast<double>(i % 16) / 16);
    }
    for (int i = 0; i < 23; ++i) knots.push_back(i);
    return Curve(3, knots, points);
  };
  const SkinnedSurface beside = skin(std::array<Curve, 2>{circle(0, 1), circle(3, 1)});
  EXPECT_TRUE(beside.report.valid);
  // Translated circles: the whole is covered forwards on one half and backwards on the other.
  EXPECT_NEAR(beside.report.wrong_sign_share, 0.5, 0.02);
  EXPECT_EQ(skin(std::array<Curve, 2>{circle(0, 1), circle(0.5, 2)}).report.wrong_sign_share, 0.0);
}

TEST(Skin, CanBeCancelled) {
  SkinOptions options;
  options.match.progress = [](double) { return false; };
  EXPECT_TRUE(skin(cad_case("bells_5"), options).report.cancelled);
  // At any time: there is always an answer, and a request that keeps up is heard.
  const std::vector<Curve> rings[] = {cad_case("bells_5"), ring_of_blobs(4)};
  for (const std::vector<Curve>& sections : rings) {
    options.loft.closed = &sections == &rings[1];
    for (int most = 1; most < 400; most = 2 * most + 1) {
      int calls = 0;
      options.match.progress = [&](double) { return ++calls <= most; };
      const SkinnedSurface skinned = skin(sections, options);
      EXPECT_EQ(skinned.report.cancelled, calls > most) << most;
      EXPECT_EQ(skinned.sections.size(), sections.size());
    }
  }
}

std::string message(const std::vector<Curve>& sections, const SkinOptions& options = {}) {
  try {
    static_cast<void>(skin(sections, options));
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(Skin, RefusesWhatIsNoChain) {
  const std::vector<Curve> bells = cad_case("bells_5");
  EXPECT_EQ(message({}), "0 sections, expected at least 2");
  EXPECT_EQ(message({bells[0]}), "1 section, expected at least 2");
  EXPECT_EQ(message({bells[0], bells[1]}, {.loft = {.closed = true}}),
            "2 sections, expected at least 3 for a closed loft");
  EXPECT_EQ(message({bells[0], blob(0, 5)}),
            "section 1 is closed, section 0 is open; expected all open or all closed");
  EXPECT_EQ(message({bells[0], Curve(1, {0, 0, 1, 1}, Points({{0, 0}, {1, 0}}))}),
            "section 1 has dimension 2, section 0 has 3; expected the same");
  EXPECT_EQ(message({bells[0], bells[0], bells[1]}),
            "sections 0 and 1 coincide, expected distinct neighbours");
  // The same outline, though it starts elsewhere and has other knots.
  const Curve moved = insert_knot(move_seam(blob(0, 0), 12.3), 14.0);
  EXPECT_EQ(message({blob(1, 1), blob(0, 0), moved}),
            "sections 1 and 2 coincide, expected distinct neighbours");
  EXPECT_EQ(message(bells, {.loft = {.degree = 26}}),
            "the degree across the sections is 26, expected 1 .. 25");
  EXPECT_EQ(message(bells, {.loft = {.rows = 6}}), "6 rows for 5 sections and degree 3, expected 4 .. 5");
  EXPECT_EQ(message(bells, {.pins = {{0.1, 0.2}}}),
            "pin 0 has 2 parameters for 5 sections, expected one each");
  EXPECT_NE(message(bells, {.pins = {{0.1, 0.2, 7.0, 0.2, 0.1}}}).find("sections 1 and 2: "),
            std::string::npos);
}

// Share of the mean length on which the tangents of two rows of a surface are more than perpendicular: by
// samples, of the surface as it is.
double disagreement(const Surface& surface, double v0, double v1) {
  constexpr int n = 20000;
  const Interval u = surface.domain(Along::u);
  double invalid = 0.0;
  double whole = 0.0;
  for (int i = 0; i < n; ++i) {
    const double at = u.lo + u.length() * (i + 0.5) / n;
    const Points a = surface.derivatives(at, v0, 1);
    const Points b = surface.derivatives(at, v1, 1, {Side::right, Side::left});
    double dot = 0.0;
    double first = 0.0;
    double second = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      dot += a[1][c] * b[1][c];
      first += a[1][c] * a[1][c];
      second += b[1][c] * b[1][c];
    }
    const double way = std::sqrt(first) + std::sqrt(second);
    whole += way;
    if (dot < 0.0) invalid += way;
  }
  return invalid / whole;
}

TEST(Skin, LooksOnceMoreWhereLettersDisagree) {
  const std::vector<Curve> letters = cad_case("letters_EF");
  const SkinnedSurface two = skin(letters);
  EXPECT_LE(disagreement(two.surface, 0.0, 1.0), 0.002);
  EXPECT_GE(two.report.pairs[0].validity.valid_share, 0.998);
  EXPECT_EQ(two.report.refined, 1);
  EXPECT_LE(two.report.interpolation_error, 1e-9);
  // In a chain what is changed of one section is carried over to all that follow.
  const auto raised = [](const Curve& curve, double height) {
    Points points = curve.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) points[i][2] += height;
    return Curve(curve.degree(), curve.knots(), points, curve.weights());
  };
  const std::vector<Curve> chain = {letters[0], letters[1], move_seam(raised(letters[1], 2.0), 0.3),
                                    reverse(raised(letters[1], 4.0))};
  const SkinnedSurface four = skin(chain, {.loft = {.degree = 1}});
  expect_interpolated(four, chain);
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    EXPECT_GE(four.report.pairs[k].validity.valid_share, 0.998) << k;
    EXPECT_LE(disagreement(four.surface, four.parameters[k], four.parameters[k + 1]), 0.002) << k;
  }
  // A letter that comes back is as valid against the one that a law has moved.
  for (const std::array<std::size_t, 3>& order : {std::array<std::size_t, 3>{0, 1, 0}, {1, 0, 1}}) {
    const SkinnedSurface back =
        skin(std::array<Curve, 3>{letters[order[0]], letters[order[1]], raised(letters[order[2]], 12.0)});
    for (const SkinPair& pair : back.report.pairs) EXPECT_GE(pair.validity.valid_share, 0.998) << order[0];
  }
  // Whichever letter comes first: then it is the first curve that has to stand still.
  EXPECT_GE(skin(std::array<Curve, 2>{letters[1], letters[0]}).report.pairs[0].validity.valid_share, 0.998);
  // Pins stay where they are.
  const std::vector<double> pin = {0.1, 0.12};
  const SkinnedSurface pinned = skin(letters, {.pins = {pin}});
  EXPECT_NEAR(pinned.laws[1].v.evaluate(pin[0])[0], pin[1], 1e-9);
}

TEST(Skin, PutsLettersInStep) {
  const SkinnedSurface skinned = skin(cad_case("letters_EF"));
  std::printf("letters: valid %d, crease %g, min dot %g share %g, %zu control points\n", skinned.report.valid,
              skinned.report.crease_angle, skinned.report.pairs[0].validity.min_dot,
              skinned.report.pairs[0].validity.valid_share, skinned.surface.size(Along::u));
  EXPECT_LE(skinned.report.crease_angle, std::numbers::pi / 180.0);
  // Where E has an arm and F has none, tangents turn just past a right angle.
  EXPECT_GE(skinned.report.pairs[0].validity.valid_share, 0.998);
  EXPECT_TRUE(skinned.surface.is_closed(Along::u));
}

}  // namespace
}  // namespace tandem
