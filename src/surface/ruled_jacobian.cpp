#include "surface/ruled_jacobian.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include "surface/bernstein_enclosure.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Halvings of one span, one after the other: pieces are then 1e-12 of the span, their coefficients differ by
// as little, and what they do not decide is due to rounding.
constexpr int kLargestDepth = 40;
// Pieces in all, for surfaces whose Jacobian is nearly zero along a whole stretch.
constexpr int kMostPieces = 20000;

using Vector = std::vector<Enclosures>;  // a polynomial each

Vector components(const Enclosures& coefficients, std::size_t stride) {
  Vector result;
  for (std::size_t c = 0; c < stride; ++c) result.push_back(component(coefficients, stride, c));
  return result;
}

Enclosures cross(const Vector& f, const Vector& g) {
  return difference(product(f[0], g[1]), product(f[1], g[0]));
}

// The determinant of three vectors of polynomials.
Enclosures determinant(const Vector& f, const Vector& g, const Vector& h) {
  Enclosures result;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t x = (c + 1) % 3;
    const std::size_t y = (c + 2) % 3;
    const Enclosures minor = difference(product(f[x], g[y]), product(f[y], g[x]));
    Enclosures term = product(minor, h[c]);
    result = result.empty() ? std::move(term) : sum(std::move(result), term);
  }
  return result;
}

// d = b - a over a part of a common span, of polynomial rails.
Vector rulings(const Rails& rails, Interval part) {
  if (rails.d) return components(rails.d->bezier(part), 2);
  const Vector a = components(rails.a.bezier(part), 2);
  const Vector b = components(rails.b.bezier(part), 2);
  const auto degree = static_cast<std::size_t>(std::max(rails.a.degree(), rails.b.degree()));
  Vector d;
  for (std::size_t c = 0; c < 2; ++c) d.push_back(difference(elevated(b[c], degree), elevated(a[c], degree)));
  return d;
}

// J_0 and J_1 over a part of a common span, up to positive factors.
std::array<Enclosures, 2> jacobians(const Rails& rails, Interval part) {
  const std::size_t stride = rails.a.stride();
  const Vector da = components(rails.a.hodograph(part), stride);
  const Vector db = components(rails.b.hodograph(part), stride);
  std::array<Enclosures, 2> result;
  if (rails.rational) {
    const Vector a = components(rails.a.bezier(part), stride);
    const Vector b = components(rails.b.bezier(part), stride);
    result = {determinant(a, da, b), determinant(a, db, b)};
  } else {
    const Vector d = rulings(rails, part);
    result = {cross(da, d), cross(db, d)};
  }
  const Interval domain = rails.a.domain();
  for (Enclosures& j : result) {
    if (rails.pole[0] && part.lo == domain.lo) {
      j.front() = {};
      j = without_zero_at_0(j);
    }
    if (rails.pole[1] && part.hi == domain.hi) {
      j.back() = {};
      j = without_zero_at_1(j);
    }
  }
  return result;
}

/// Looks for both signs, and for places where there is none.
class SignScan {
 public:
  explicit SignScan(const Rails& rails) : rails_(rails) {}

  // Level by level: where the sign changes, wider pieces tell so before narrow ones are asked.
  JacobianSign run() {
    std::vector<Piece> level = whole_spans();
    for (int depth = 0; !level.empty() && !has_both_signs(depth); ++depth) {
      std::vector<Piece> next;
      for (const Piece& piece : level) {
        if (decides(piece)) continue;
        if (depth == kLargestDepth || !piece.can_split() || ++pieces_ > kMostPieces) {
          undecided_ = true;
          continue;
        }
        auto [left, right] = halves(piece.j);
        const double middle = 0.5 * piece.part.lo + 0.5 * piece.part.hi;
        next.push_back({std::move(left), {piece.part.lo, middle}, piece.rail, piece.span});
        next.push_back({std::move(right), {middle, piece.part.hi}, piece.rail, piece.span});
      }
      level = std::move(next);
    }
    return conclude();
  }

 private:
  struct Piece {
    Enclosures j;
    Interval part;
    int rail = 0;
    double span = 0.0;  // length of the span of which it is a part

    // The places are doubles, and rounded; a piece shorter than a few of them has no place of its own.
    [[nodiscard]] bool can_split() const noexcept {
      const double middle = 0.5 * part.lo + 0.5 * part.hi;
      return part.lo < middle && middle < part.hi;
    }
  };

  struct Best {
    RailPlace place;
    double size = 0.0;
    double share = 0.0;  // of the domain of both rails, with that sign
  };

  [[nodiscard]] std::vector<Piece> whole_spans() const {
    std::vector<double> breaks;
    const std::vector<double> of_a = rails_.a.breaks();
    const std::vector<double> of_b = rails_.b.breaks();
    std::set_union(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(breaks));
    std::vector<Piece> result;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const Interval part{breaks[i], breaks[i + 1]};
      std::array<Enclosures, 2> j = jacobians(rails_, part);
      for (const int rail : {0, 1})
        result.push_back({std::move(j[static_cast<std::size_t>(rail)]), part, rail, part.length()});
    }
    return result;
  }

  // Both signs are known: not at the first levels, so that witnesses are good ones.
  [[nodiscard]] bool has_both_signs(int depth) const noexcept {
    constexpr int kDepthOfWitnesses = 6;
    return depth > kDepthOfWitnesses && best_[0].size > 0.0 && best_[1].size > 0.0;
  }

  void note(int sign, const Piece& piece) {
    Best& best = best_[sign > 0 ? 0 : 1];
    best.share += piece.part.length();
    // The derivative was taken by the span's own parameter.
    const double size = std::abs(piece.j[piece.j.size() / 2].middle()) / piece.span;
    if (best.size > 0.0 && !(size > best.size)) return;
    best.size = std::max(size, std::numeric_limits<double>::min());
    best.place = {0.5 * piece.part.lo + 0.5 * piece.part.hi, piece.rail};
  }

  void note_zeros(const Enclosures& j, Interval part, int rail) {
    const auto note_zero = [&](double u) {
      if (!zero_) zero_ = RailPlace{u, rail};
      const Interval domain = rails_.a.domain();
      if (domain.lo < u && u < domain.hi) zeros_[static_cast<std::size_t>(rail)].push_back(u);
    };
    if (j.front().is_zero()) note_zero(part.lo);
    if (j.back().is_zero()) note_zero(part.hi);
  }

  bool decides(const Piece& piece) {
    if (const int sign = common_sign(piece.j); sign != 0) {
      note(sign, piece);
      note_zeros(piece.j, piece.part, piece.rail);
      return true;
    }
    if (!std::all_of(piece.j.begin(), piece.j.end(), [](const Enclosure& c) { return c.is_zero(); }))
      return false;
    if (!zero_) zero_ = RailPlace{0.5 * piece.part.lo + 0.5 * piece.part.hi, piece.rail};
    flat_ = true;
    return true;
  }

  // Places are told by doubles, which the dyadic parts of a span are only nearly: the sign is proved anew, at
  // just that parameter, by the last coefficient of the part that ends there.
  [[nodiscard]] bool has_sign(RailPlace place, int sign) const {
    const std::vector<double> of_a = rails_.a.breaks();
    const std::vector<double> of_b = rails_.b.breaks();
    const double lo = std::max(*std::prev(std::lower_bound(of_a.begin(), of_a.end(), place.u)),
                               *std::prev(std::lower_bound(of_b.begin(), of_b.end(), place.u)));
    const Enclosures j = jacobians(rails_, {lo, place.u})[static_cast<std::size_t>(place.rail)];
    return sign > 0 ? j.back().is_positive() : j.back().is_negative();
  }

  [[nodiscard]] JacobianSign conclude() const {
    JacobianSign result;
    result.zero = zero_;
    const bool both = best_[0].size > 0.0 && best_[1].size > 0.0;
    if (both && has_sign(best_[0].place, 1) && has_sign(best_[1].place, -1)) {
      result.verdict = Verdict::violated;
      result.positive = best_[0].place;
      result.negative = best_[1].place;
      result.rarer = best_[0].share < best_[1].share ? 1 : -1;
    } else {
      if (!undecided_ && !both) result.sign = best_[0].size > 0.0 ? 1 : (best_[1].size > 0.0 ? -1 : 0);
      if (zero_) {
        result.verdict = Verdict::violated;
        if (flat_ || zero_on_a_ruling()) result.sign = 0;
      } else if (result.sign != 0) {
        result.verdict = Verdict::certified;
      }
    }
    return result;
  }

  // Zero on both rails at once: all along the ruling.
  [[nodiscard]] bool zero_on_a_ruling() const {
    return std::any_of(zeros_[0].begin(), zeros_[0].end(), [&](double u) {
      return std::find(zeros_[1].begin(), zeros_[1].end(), u) != zeros_[1].end();
    });
  }

  const Rails& rails_;
  std::array<Best, 2> best_;  // positive, negative
  std::optional<RailPlace> zero_;
  std::array<std::vector<double>, 2> zeros_;  // on either rail, within the domain
  bool flat_ = false;                         // zero along a stretch of a rail
  bool undecided_ = false;
  int pieces_ = 0;
};

// Control points are end points exactly where the knots have full multiplicity.
bool is_clamped(const Curve& curve) {
  const auto p = static_cast<std::ptrdiff_t>(curve.degree());
  const std::vector<double>& knots = curve.knots();
  return knots[1] == curve.domain().lo && *(knots.end() - 2) == curve.domain().hi && p >= 1;
}

bool same(std::span<const double> p, std::span<const double> q) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end());
}

}  // namespace

Rails make_rails(const Curve& a, const Curve& b) {
  const std::array<const Points*, 2> clouds = {&a.control_points(), &b.control_points()};
  const Frame frame = frame_of(clouds);
  const bool rational = a.is_rational() || b.is_rational();
  const auto rail = [&](const Curve& curve) {
    return EnclosedSpline(curve.degree(), curve.knots(),
                          homogeneous(curve.control_points(), curve.weights(), rational, frame),
                          rational ? 3 : 2);
  };
  Rails rails{rail(a), rail(b), {}, rational};
  const Points& p = a.control_points();
  const Points& q = b.control_points();
  if (!rational && a.knots() == b.knots() && a.degree() == b.degree()) {
    Enclosures d(2 * p.size());
    for (std::size_t i = 0; i < d.size(); ++i)
      d[i] = scaled(Enclosure(q.data()[i]) - p.data()[i], frame.exponent);
    rails.d = EnclosedSpline(a.degree(), a.knots(), std::move(d), 2);
  }
  rails.closed = a.is_closed() && b.is_closed();
  if (rails.closed) {
    const auto last_break = [](const EnclosedSpline& spline) { return *(spline.breaks().end() - 2); };
    const double from = std::max(last_break(rails.a), last_break(rails.b));
    const bool sewn_a = is_clamped(a) && same(p.front(), p.back());
    const bool sewn_b = is_clamped(b) && same(q.front(), q.back());
    if (!sewn_a) rails.a.weld(2, rational, from);
    if (!sewn_b) rails.b.weld(2, rational, from);
    if (rails.d && !(sewn_a && sewn_b)) rails.d->weld(2, false, from);
  } else if (is_clamped(a) && is_clamped(b)) {
    rails.pole = {same(p.front(), q.front()), same(p.back(), q.back())};
  }
  return rails;
}

JacobianSign ruled_jacobian_sign(const Rails& rails) {
  return SignScan(rails).run();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
