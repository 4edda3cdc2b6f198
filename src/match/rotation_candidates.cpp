#include "match/rotation_candidates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "match/nearest_rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Scores this close, relatively, are equal: symmetric shapes agree with themselves up to rounding only.
constexpr double kTie = 1e-9;

/// The numbers twice, so that every cyclic shift is a stretch of them.
std::vector<double> doubled(std::span<const double> x) {
  std::vector<double> twice(x.begin(), x.end());
  twice.insert(twice.end(), x.begin(), x.end());
  return twice;
}

/// Adds conj(a_i) b_(i + k) for two neighbours i to the sums over all shifts k: the sums are loaded and
/// stored half as often, and the loop runs over lanes.
struct ComplexRow {
  const double* bx;
  const double* by;
  double* re;
  double* im;
  std::size_t count;

  void add(double x0, double y0, double x1, double y1) const {
    for (std::size_t k = 0; k < count; ++k) {
      re[k] += (x0 * bx[k] + y0 * by[k]) + (x1 * bx[k + 1] + y1 * by[k + 1]);
      im[k] += (x0 * by[k] - y0 * bx[k]) + (x1 * by[k + 1] - y1 * bx[k + 1]);
    }
  }
};

struct ComplexSums {
  std::vector<double> re;
  std::vector<double> im;
};

/// Sums of conj(a_i) b_(i + k) over i: for every shift k, or (open) for k = 0 alone.
ComplexSums complex_correlation(std::span<const double> ax, std::span<const double> ay,
                                std::span<const double> bx, std::span<const double> by, bool cyclic) {
  const std::size_t m = ax.size();
  const std::size_t shifts = cyclic ? m : 1;
  std::vector<double> twice_x = doubled(bx);
  std::vector<double> twice_y = doubled(by);
  ComplexSums sums{std::vector<double>(shifts), std::vector<double>(shifts)};
  for (std::size_t i = 0; i < m; i += 2) {
    const ComplexRow row{twice_x.data() + i, twice_y.data() + i, sums.re.data(), sums.im.data(), shifts};
    const bool alone = i + 1 == m;
    row.add(ax[i], ay[i], alone ? 0.0 : ax[i + 1], alone ? 0.0 : ay[i + 1]);
  }
  return sums;
}

/// Sums of a_i b_(i + k) over i, likewise.
std::vector<double> correlation(std::span<const double> a, std::span<const double> b, bool cyclic) {
  std::vector<double> sums(cyclic ? a.size() : 1);
  const std::vector<double> twice = doubled(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += a[i] * twice[i + k];
  }
  return sums;
}

/// The shifts at which a positive score is a local maximum; all of a plateau.
std::vector<std::size_t> peaks(std::span<const double> scores) {
  std::vector<std::size_t> shifts;
  const std::size_t m = scores.size();
  for (std::size_t k = 0; k < m; ++k) {
    const double beside = std::max(scores[k > 0 ? k - 1 : m - 1], scores[k + 1 < m ? k + 1 : 0]);
    if (scores[k] > 0.0 && scores[k] >= (1.0 - kTie) * beside) shifts.push_back(k);
  }
  return shifts;
}

/// Best first, among equals the smaller turn, and no more than `most`. trace: falls as the turn grows.
template <class Candidate, class Trace>
std::vector<Candidate> best_of(std::vector<Candidate> candidates, int most, const Trace& trace) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& x, const Candidate& y) { return x.score > y.score; });
  for (auto first = candidates.begin(); first != candidates.end();) {
    const double limit = (1.0 - kTie) * first->score;
    const auto last =
        std::find_if(first, candidates.end(), [&](const Candidate& c) { return c.score < limit; });
    std::stable_sort(first, last,
                     [&](const Candidate& x, const Candidate& y) { return trace(x) > trace(y); });
    first = last;
  }
  if (candidates.size() > static_cast<std::size_t>(most)) {
    candidates.erase(candidates.begin() + most, candidates.end());
  }
  return candidates;
}

}  // namespace

std::vector<PlanarCandidate> planar_rotation_candidates(std::span<const double> ax,
                                                        std::span<const double> ay,
                                                        std::span<const double> bx,
                                                        std::span<const double> by, bool cyclic, int most) {
  const ComplexSums sums = complex_correlation(ax, ay, bx, by, cyclic);
  std::vector<double> scores(sums.re.size());
  for (std::size_t k = 0; k < scores.size(); ++k) {
    scores[k] = std::sqrt(sums.re[k] * sums.re[k] + sums.im[k] * sums.im[k]);
  }
  const double mean = 1.0 / static_cast<double>(std::max<std::size_t>(ax.size(), 1));
  std::vector<PlanarCandidate> candidates;
  for (const std::size_t k : peaks(scores)) {
    candidates.push_back(
        {sums.re[k] / scores[k], sums.im[k] / scores[k], static_cast<int>(k), scores[k] * mean});
  }
  return best_of(std::move(candidates), most, [](const PlanarCandidate& c) { return c.cosine; });
}

std::vector<RotationCandidate> rotation_candidates(std::span<const double> a, std::span<const double> b,
                                                   int dim, bool cyclic, int most) {
  const auto n = static_cast<std::size_t>(dim);
  const std::size_t m = a.size() / n;
  std::vector<RotationCandidate> candidates;
  const auto plane = [m](std::span<const double> x, std::size_t c) { return x.subspan(c * m, m); };
  if (dim == 2) {
    for (const PlanarCandidate& c :
         planar_rotation_candidates(plane(a, 0), plane(a, 1), plane(b, 0), plane(b, 1), cyclic, most)) {
      const double values[] = {c.cosine, c.sine};
      candidates.push_back({Rotation(2, values), c.shift, c.score});
    }
    return candidates;
  }
  std::vector<std::vector<double>> sums;
  for (std::size_t k = 0; k < n * n; ++k) {
    sums.push_back(correlation(plane(a, k % n), plane(b, k / n), cyclic));
  }
  std::vector<NearestRotation> nearest;
  std::vector<double> scores;
  std::vector<double> covariance(n * n);
  for (std::size_t shift = 0; shift < sums.front().size(); ++shift) {
    for (std::size_t k = 0; k < n * n; ++k) covariance[k] = sums[k][shift];
    nearest.push_back(nearest_rotation(covariance, dim));
    scores.push_back(nearest.back().score);
  }
  const double mean = 1.0 / static_cast<double>(std::max<std::size_t>(m, 1));
  for (const std::size_t k : peaks(scores)) {
    candidates.push_back({std::move(nearest[k].rotation), static_cast<int>(k), scores[k] * mean});
  }
  return best_of(std::move(candidates), most, [](const RotationCandidate& c) { return c.rotation.trace(); });
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
