#include "match/found_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "match/match_along.h"
#include "match/random_curves.h"

namespace tandem {
namespace {

using detail::find_match;
using detail::finish_match;
using detail::FoundMatch;
using testing_curves::closed_curve;
using testing_curves::open_curve;

void expect_equal(const Match& x, const Match& y) {
  EXPECT_EQ(x.correspondence.points, y.correspondence.points);
  EXPECT_TRUE(std::ranges::equal(x.curve.control_points().data(), y.curve.control_points().data()));
  EXPECT_EQ(x.samples_b.parameters, y.samples_b.parameters);
  EXPECT_EQ(x.report.invalid_nodes, y.report.invalid_nodes);
  EXPECT_EQ(x.report.validity.valid_share, y.report.validity.valid_share);
}

// Found on samples that were taken before, it is the same.
TEST(FoundMatch, OnSamplesThatAreThereIsTheMatch) {
  std::mt19937 random(21);
  for (int n = 0; n < 4; ++n) {
    const bool closed = n % 2 == 0;
    const Curve a = closed ? closed_curve(random) : open_curve(random);
    const Curve b = closed ? closed_curve(random) : open_curve(random);
    const MatchOptions options{.samples = {48, 48}, .coarse_to_fine = n > 1};
    const FoundMatch found = find_match(a, b, options, detail::sample_for_match(a, b, options));
    expect_equal(finish_match(a, b, found), match(a, b, options));
  }
}

// Another correspondence followed before the match is whole is the same as afterwards.
TEST(FoundMatch, FollowsAnotherCorrespondence) {
  std::mt19937 random(22);
  const Curve a = open_curve(random);
  const Curve b = open_curve(random);
  const MatchOptions options{.samples = {48, 48}};
  FoundMatch found = find_match(a, b, options);
  Correspondence along = found.path.correspondence;
  along.reversed = false;
  along.points = {{0.0, 0.0}, {0.3, 0.6}, {1.0, 1.0}};
  const Match whole = finish_match(a, b, found);
  follow(found, along);
  expect_equal(finish_match(a, b, found), detail::match_along(a, b, options, whole, along));
}

// The paper's test turns down nodes where the curves run against each other.
TEST(FoundMatch, CountsInvalidNodesWhenItIsWhole) {
  std::mt19937 random(23);
  const Curve a = open_curve(random);
  const Curve b = open_curve(random);
  MatchOptions options{.samples = {48, 48}};
  int invalid = 0;
  for (const Direction direction : {Direction::forward, Direction::reversed}) {
    options.direction = direction;
    invalid += match(a, b, options).report.invalid_nodes;
  }
  EXPECT_GT(invalid, 0);
}

}  // namespace
}  // namespace tandem
