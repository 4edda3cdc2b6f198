#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "match/cubic_paths.h"
#include "morph/icons.h"
#include "morph/loops.h"
#include "tandem/io/load.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/nesting.h"
#include "tandem/shape/path_builder.h"

// [D]'s four criteria of a good transformation (spec D7), through the whole chain from shapes to in-betweens:
// identity, translation at uniform speed, smoothness, and features kept.

namespace tandem {
namespace {

using cubics::largest_difference;
using test::largest_turn;
using test::smooth_star;
using test::turn_at;
using test::turned;

const std::vector<double> kTimes = {0.0, 1e-3, 0.2, 0.499, 0.5, 0.7, 0.999, 1.0};

struct Chain {
  const char* name;
  Method method;
  std::optional<BlendKind> blend;

  [[nodiscard]] MorphOptions options() const {
    MorphOptions options;
    options.match.method = method;
    // What is tested here does not depend on how good the match is.
    if (method == Method::elastic) options.match.samples = {40, 40};
    options.blend = blend;
    return options;
  }
  friend void PrintTo(const Chain& chain, std::ostream* out) { *out << chain.name; }
};

Shape shape_of(const std::vector<CubicPath>& paths) {
  Shape shape;
  for (const CubicPath& path : paths) shape.contours.push_back(to_curve(path));
  return shape;
}

PathMorph morph_of(const std::vector<CubicPath>& a, const std::vector<CubicPath>& b, const Chain& chain) {
  return PathMorph(std::vector<Shape>{shape_of(a), shape_of(b)}, chain.options());
}

std::vector<CubicPath> moved(std::vector<CubicPath> paths, double dx, double dy) {
  for (CubicPath& path : paths) path = turned(path, 0.0, dx, dy);
  return paths;
}

/// Icons of one contour and of several; all within a square of 24.
std::vector<std::vector<CubicPath>> some_icons() {
  std::vector<std::vector<CubicPath>> icons;
  for (const std::size_t i : {1, 8, 12, 15, 17, 19, 22, 27, 34}) {
    icons.push_back(orient(test::paths_of(test::kIcons[i]), FillRule::nonzero));
  }
  return icons;
}

class Criteria : public testing::TestWithParam<Chain> {};

// A shape against itself moved: it goes there at one speed, and against itself it stays.
TEST_P(Criteria, IdentityAndTranslation) {
  for (const std::vector<CubicPath>& icon : some_icons()) {
    for (const double dx : {0.0, 30.0}) {
      const PathMorph morph = morph_of(icon, moved(icon, dx, -0.5 * dx), GetParam());
      ASSERT_EQ(morph.contours().size(), icon.size());
      const std::vector<CubicPath> first = morph.at(0.0);
      for (std::size_t c = 0; c < icon.size(); ++c) {
        // The contour itself, from one of its joints.
        ASSERT_EQ(first[c].segment_count(), icon[c].segment_count());
        double off = INFINITY;
        for (std::size_t j = 0; j < icon[c].segment_count(); ++j) {
          off = std::min(off, largest_difference(first[c], cubics::from_joint(icon[c], j)));
        }
        EXPECT_LT(off, 1e-9) << "contour " << c;
        for (const double s : kTimes) {
          EXPECT_LT(largest_difference(morph.at(s)[c], turned(first[c], 0.0, s * dx, -0.5 * s * dx)), 1e-9)
              << "contour " << c << " moved by " << dx << " at " << s;
        }
      }
    }
  }
}

TEST_P(Criteria, FeaturesAreKept) {
  // A round-ended bar with a spike; the other one's spike is elsewhere, and its lower edge in more pieces.
  const auto body = [](double spike, int pieces) {
    PathBuilder builder;
    builder.move_to({2, 0});
    builder.line_to({spike - 0.7, 0});
    builder.line_to({spike, -2});
    builder.line_to({spike + 0.7, 0});
    builder.line_to({8, 0});
    builder.cubic_to({10.6, 0}, {10.6, 4}, {8, 4});
    for (int k = 1; k <= pieces; ++k) builder.line_to({8 - 6.0 * k / pieces, 4});
    builder.cubic_to({-0.6, 4}, {-0.6, 0}, {2, 0});
    builder.close();
    return builder.take();
  };
  const auto corners = [](const CubicPath& path) {
    std::vector<double> turns;
    for (std::size_t j = 0; j < path.segment_count(); ++j) {
      if (turn_at(path, j) > 0.2) turns.push_back(turn_at(path, j));
    }
    std::sort(turns.begin(), turns.end());
    return turns;
  };
  for (const double other : {4.5, 6.5}) {
    MorphOptions options = GetParam().options();
    options.match.rotate = false;
    const std::vector<Shape> keys{shape_of(body(3.2, 1)), shape_of(body(other, 3))};
    const PathMorph morph(keys, options);
    const std::vector<double> wanted = corners(body(3.2, 1).front());
    ASSERT_EQ(wanted.size(), 3u);
    for (const double s : kTimes) {
      const std::vector<double> turns = corners(morph.at(s).front());
      ASSERT_EQ(turns.size(), 3u) << "spike at " << other << ", s = " << s;
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(turns[k], wanted[k], 0.05 * wanted[k]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PathMorph, Criteria,
                         testing::Values(Chain{"default", Method::elastic, {}},
                                         Chain{"segments", Method::segments, {}},
                                         Chain{"segments_affine", Method::segments, BlendKind::affine},
                                         Chain{"segments_auto", Method::segments, BlendKind::automatic}),
                         [](const auto& chain) { return chain.param.name; });

class Smoothness : public testing::TestWithParam<Chain> {};

TEST_P(Smoothness, OfExactlySmoothLoopsIsKept) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 12; ++trial) {
    const std::vector<CubicPath> a{smooth_star(random, 5 + random() % 4)};
    const std::vector<CubicPath> b{smooth_star(random, 5 + random() % 4)};
    ASSERT_LE(largest_turn(a.front()), 1e-12);
    const PathMorph morph = morph_of(a, b, GetParam());
    for (const double s : kTimes) EXPECT_LE(largest_turn(morph.at(s).front()), 1e-9) << "at " << s;
  }
}

// Real icons are smooth to about 1e-3: there no joint is worse than it is in the worse key. Nothing is cut
// here: a chord that comes in from a smooth outline makes corners at its ends.
TEST_P(Smoothness, OfIconsIsNoWorseThanTheWorseInput) {
  const std::vector<std::string> names = {"account", "bell", "bird",     "cat",
                                          "cog",     "leaf", "umbrella", "heart"};
  const auto load = [](const std::string& name) {
    return load_shape(std::string(TANDEM_TEST_DATA) + "/icons/" + name + ".svg");
  };
  std::size_t smooth = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<Shape> keys{load(names[i]), load(names[(i + 1) % names.size()])};
    MorphOptions options = GetParam().options();
    options.cuts = false;
    const PathMorph morph(keys, options);
    const std::vector<CubicPath> first = morph.at(0.0);
    const std::vector<CubicPath> last = morph.at(1.0);
    for (const double s : {0.1, 0.3, 0.5, 0.8, 0.95}) {
      const std::vector<CubicPath> now = morph.at(s);
      for (std::size_t c = 0; c < now.size(); ++c) {
        for (std::size_t j = now[c].is_closed() ? 0 : 1; j < now[c].segment_count(); ++j) {
          const double worse = std::max(turn_at(first[c], j), turn_at(last[c], j));
          if (worse > 0.05) continue;
          ++smooth;
          EXPECT_LE(turn_at(now[c], j), worse + 1e-9)
              << names[i] << ", contour " << c << ", joint " << j << " at " << s;
        }
      }
    }
  }
  EXPECT_GT(smooth, 500u);
}

INSTANTIATE_TEST_SUITE_P(PathMorph, Smoothness,
                         testing::Values(Chain{"hermite", Method::elastic, BlendKind::hermite},
                                         Chain{"intrinsic", Method::elastic, BlendKind::intrinsic},
                                         Chain{"segments", Method::segments, {}},
                                         Chain{"segments_intrinsic", Method::segments, BlendKind::intrinsic}),
                         [](const auto& chain) { return chain.param.name; });

}  // namespace
}  // namespace tandem
