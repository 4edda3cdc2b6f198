#include "curve_pairs.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "tandem/io/path_data.h"

namespace tandem::bench {

namespace {

constexpr double kTurn = 6.283185307179586;

Curve polygon(const std::vector<std::pair<double, double>>& corners) {
  Points points(2, 0);
  for (const auto& [x, y] : corners) points.push_back(std::vector<double>{x, y});
  points.push_back(std::vector<double>{corners.front().first, corners.front().second});
  std::vector<double> knots = {0.0};
  for (std::size_t k = 0; k <= corners.size(); ++k) knots.push_back(static_cast<double>(k));
  knots.push_back(static_cast<double>(corners.size()));
  return Curve(1, std::move(knots), std::move(points));
}

Curve regular(int corners) {
  std::vector<std::pair<double, double>> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = kTurn * k / corners;
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  return polygon(points);
}

/// A periodic cubic B-spline whose control points have these radii.
template <class Radius>
Curve loop(int n, const Radius& radius) {
  std::vector<double> radii;
  for (int i = 0; i < n; ++i) radii.push_back(radius(i));
  Points points(2, 0);
  for (int i = 0; i < n + 3; ++i) {
    const double angle = kTurn * (i % n) / n;
    const double r = radii[static_cast<std::size_t>(i % n)];
    points.push_back(std::vector<double>{r * std::cos(angle), r * std::sin(angle)});
  }
  std::vector<double> knots;
  for (int k = 0; k < n + 7; ++k) knots.push_back((k - 3.0) / n);
  return Curve(3, std::move(knots), std::move(points));
}

Curve random_loop(std::mt19937& random, double roughness) {
  const int n = 8 + static_cast<int>(random() % 33);
  return loop(n, [&](int) { return 1.0 + roughness * (2.0 * (random() / 4294967296.0) - 1.0); });
}

}  // namespace

Curve random_open(unsigned seed) {
  std::mt19937 random(seed);
  Points points(2, 0);
  for (int i = 0; i < 40; ++i) {
    points.push_back(std::vector<double>{i + random() / 4294967296.0, 4.0 * (random() / 4294967296.0)});
  }
  return Curve::clamped_uniform(3, std::move(points));
}

std::vector<Pair> random_pairs() {
  std::mt19937 random(7);
  std::vector<Pair> pairs;
  for (int k = 0; k < 100; ++k) {
    const double roughness = 0.1 + 0.6 * (k / 100.0);
    Curve a = random_loop(random, roughness);
    pairs.push_back({std::move(a), random_loop(random, roughness)});
  }
  return pairs;
}

std::vector<Pair> hard_pairs() {
  const auto circle = [](int n) { return loop(n, [](int) { return 1.0; }); };
  const auto star = [](int n, double in) {
    return loop(2 * n, [=](int k) { return k % 2 == 0 ? 1.0 : in; });
  };
  const auto box = [](double width) { return polygon({{0, 0}, {width, 0}, {width, 1}, {0, 1}}); };
  std::vector<Pair> pairs = {
      {circle(16), circle(23)},     {circle(16), regular(7)},     {regular(5), regular(5)},
      {regular(5), regular(6)},     {regular(16), regular(17)},   {box(30.0), box(10.0)},
      {box(1.0), circle(16)},       {star(8, 0.9), star(8, 0.9)}, {star(8, 0.9), star(9, 0.9)},
      {star(16, 0.97), circle(20)}, {star(5, 0.4), star(6, 0.4)}, {star(12, 0.5), star(13, 0.5)},
      {star(9, 0.3), circle(16)},   {star(12, 0.5), box(8.0)}};
  return pairs;
}

std::vector<PathPair> file_paths() {
  std::vector<PathPair> pairs;
  const char* name = std::getenv("TANDEM_PAIRS");
  if (name == nullptr) return pairs;
  std::ifstream file(name);
  const nlohmann::json json = nlohmann::json::parse(file);
  for (const auto& pair : json.at("pairs")) {
    if (pair.at("set").get<std::string>() != "closed1") continue;
    const auto data = [&](const char* which) { return pair.at(which).at("d").get<std::string>(); };
    pairs.push_back({data("a"), data("b")});
  }
  return pairs;
}

std::vector<Pair> file_pairs() {
  std::vector<Pair> pairs;
  for (const PathPair& pair : file_paths()) {
    pairs.push_back({to_curve(parse_path_data(pair.a).front()), to_curve(parse_path_data(pair.b).front())});
  }
  return pairs;
}

}  // namespace tandem::bench
