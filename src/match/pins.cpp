#include "match/pins.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

bool loop_a(Layout layout) {
  return layout == Layout::toroidal || layout == Layout::cut_a;
}
bool loop_b(Layout layout) {
  return layout == Layout::toroidal || layout == Layout::cut_b;
}

std::string describe(const ParameterPair& pin) {
  return fmt::format("(u = {}, v = {})", pin.u, pin.v);
}

/// The parameter inside the domain; on a loop its end is its start.
double inside(double t, const Interval& domain, bool loop, const ParameterPair& pin, const char* which) {
  if (!std::isfinite(t) || (!loop && !domain.contains(t))) {
    throw InvalidArgument(fmt::format("pin {} lies outside the {} curve's domain [{}, {}]", describe(pin),
                                      which, domain.lo, domain.hi));
  }
  if (!loop) return t;
  t -= std::floor((t - domain.lo) / domain.length()) * domain.length();
  return t >= domain.hi || t < domain.lo ? domain.lo : t;
}

/// How a path may not run: pin k and the next one, or nothing where all is well.
struct Crossing {
  bool found = false;
  ParameterPair first;
  ParameterPair second;
};

/// Pins by u. On an open pair v must rise (fall when reversed) from end to end; on a loop it does so once
/// round.
Crossing find_crossing(const std::vector<ParameterPair>& pins, Layout layout, const Interval& a,
                       const Interval& b, bool reversed) {
  std::vector<ParameterPair> order = pins;
  if (layout == Layout::open) {
    const ParameterPair first{a.lo, reversed ? b.hi : b.lo};
    const ParameterPair last{a.hi, reversed ? b.lo : b.hi};
    if (!(order.front() == first)) order.insert(order.begin(), first);
    if (!(order.back() == last)) order.push_back(last);
  }
  const auto rises = [&](const ParameterPair& p, const ParameterPair& q) {
    return reversed ? q.v < p.v : p.v < q.v;
  };
  int turns = 0;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const ParameterPair& p = order[k];
    const ParameterPair& q = order[k + 1];
    if (p.u == q.u || p.v == q.v) return {true, p, q};
    if (!rises(p, q) && (layout == Layout::open || ++turns > 1)) return {true, p, q};
  }
  const bool closes =
      layout == Layout::open || order.size() < 2 || rises(order.back(), order.front()) || turns == 0;
  if (!closes) return {true, order.back(), order.front()};
  // Pins that are not neighbours may share a v.
  std::vector<ParameterPair> by_v = order;
  std::sort(by_v.begin(), by_v.end(),
            [](const ParameterPair& p, const ParameterPair& q) { return p.v < q.v; });
  for (std::size_t k = 0; k + 1 < by_v.size(); ++k) {
    if (by_v[k].v == by_v[k + 1].v) return {true, by_v[k], by_v[k + 1]};
  }
  return {};
}

}  // namespace

MatchOptions settle_pins(const Curve& a, const Curve& b, MatchOptions options, Layout layout) {
  if (options.pins.empty()) return options;
  if (layout == Layout::pinned) {
    throw InvalidArgument("pins do not go with the pinned form of closed curves, which pins the ends");
  }
  if (options.reduction && options.reduction->coefficients) {
    throw InvalidArgument(
        "pins do not go with a number of coefficients: v could not pass through them; reduce by a tolerance");
  }
  for (ParameterPair& pin : options.pins) {
    pin = {inside(pin.u, a.domain(), loop_a(layout), pin, "first"),
           inside(pin.v, b.domain(), loop_b(layout), pin, "second")};
  }
  std::sort(options.pins.begin(), options.pins.end(), [](const ParameterPair& p, const ParameterPair& q) {
    return p.u != q.u ? p.u < q.u : p.v < q.v;
  });
  options.pins.erase(std::unique(options.pins.begin(), options.pins.end()), options.pins.end());
  Crossing crossing;
  std::vector<bool> allowed;
  for (const bool reversed : {false, true}) {
    if (options.direction == (reversed ? Direction::forward : Direction::reversed)) continue;
    const Crossing here = find_crossing(options.pins, layout, a.domain(), b.domain(), reversed);
    if (!here.found) allowed.push_back(reversed);
    if (!crossing.found) crossing = here;
  }
  if (allowed.empty()) {
    throw InvalidArgument(fmt::format("no path runs through pins {} and {} and all the others: they cross",
                                      describe(crossing.first), describe(crossing.second)));
  }
  if (allowed.size() == 1) options.direction = allowed[0] ? Direction::reversed : Direction::forward;
  return options;
}

std::vector<PinnedStretch> stretches(const MatchOptions& options, Layout layout, const Interval& domain_a,
                                     const Interval& domain_b, bool reversed) {
  std::vector<ParameterPair> nodes = options.pins;
  if (layout == Layout::open) {
    const ParameterPair first{domain_a.lo, reversed ? domain_b.hi : domain_b.lo};
    const ParameterPair last{domain_a.hi, reversed ? domain_b.lo : domain_b.hi};
    if (!(nodes.front() == first)) nodes.insert(nodes.begin(), first);
    if (!(nodes.back() == last)) nodes.push_back(last);
  }
  std::vector<PinnedStretch> result;
  const auto add = [&](const ParameterPair& p, const ParameterPair& q) {
    PinnedStretch stretch{{p.u, q.u}, reversed ? Interval{q.v, p.v} : Interval{p.v, q.v}};
    if (loop_a(layout) && stretch.u.hi <= stretch.u.lo) stretch.u.hi += domain_a.length();
    if (loop_b(layout) && stretch.v.hi <= stretch.v.lo) stretch.v.hi += domain_b.length();
    result.push_back(stretch);
  };
  if (layout == Layout::cut_b) {
    // The open curve's pins are in order already; those of the loop follow.
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) add(nodes[k], nodes[k + 1]);
    add(nodes.back(), nodes.front());
    return result;
  }
  if (layout == Layout::cut_a) {
    // In the order of the open curve.
    std::sort(nodes.begin(), nodes.end(), [&](const ParameterPair& p, const ParameterPair& q) {
      return reversed ? q.v < p.v : p.v < q.v;
    });
  }
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) add(nodes[k], nodes[k + 1]);
  if (layout != Layout::open) add(nodes.back(), nodes.front());
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
