#include "match/matched_covariance.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

class Covariance {
 public:
  explicit Covariance(int dim) : n_(static_cast<std::size_t>(dim)), sums_(n_ * n_) {}

  void add(double weight, std::span<const double> x, std::span<const double> y) {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < n_; ++k) sums_[i * n_ + k] += weight * y[i] * x[k];
    }
  }
  [[nodiscard]] std::vector<double> take() && { return std::move(sums_); }

 private:
  std::size_t n_;
  std::vector<double> sums_;
};

/// The chords of one curve under an edge, run through at constant speed from share 0 to share 1.
class EdgeWalk {
 public:
  EdgeWalk(const Samples& samples, int from, int to) : samples_(samples), chord_(from), last_(to - 1) {
    for (int k = from; k < to; ++k) length_ += samples_.chord_lengths[index(k)];
    enter();
  }

  [[nodiscard]] double length() const { return length_; }
  /// Share at which the present chord ends.
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] std::span<const double> tangent() const { return samples_.chord_tangents[index(chord_)]; }
  [[nodiscard]] bool at_last() const { return chord_ == last_; }
  void next() {
    ++chord_;
    enter();
  }

 private:
  [[nodiscard]] std::size_t index(int k) const {
    const int count = static_cast<int>(samples_.chords());
    return static_cast<std::size_t>(((k % count) + count) % count);
  }
  void enter() {
    walked_ += samples_.chord_lengths[index(chord_)];
    end_ = at_last() || !(length_ > 0.0) ? 1.0 : walked_ / length_;
  }

  const Samples& samples_;
  int chord_;
  int last_;
  double length_ = 0.0;
  double walked_ = 0.0;
  double end_ = 1.0;
};

void add_edge(Covariance& covariance, EdgeWalk a, EdgeWalk b) {
  const double length = 0.5 * (a.length() + b.length());
  for (double at = 0.0;;) {
    const double end = std::max(at, std::min(a.end(), b.end()));
    covariance.add((end - at) * length, a.tangent(), b.tangent());
    if (a.at_last() && b.at_last()) return;
    at = end;
    const bool next_a = !a.at_last() && (a.end() <= end || b.at_last());
    const bool next_b = !b.at_last() && (b.end() <= end || a.at_last());
    if (next_a) a.next();
    if (next_b) b.next();
  }
}

}  // namespace

std::vector<double> matched_covariance(const Samples& a, const Samples& b, const Path& path, Method method) {
  Covariance covariance(a.dim());
  if (method == Method::elastic) {
    for (std::size_t n = 1; n < path.nodes.size(); ++n) {
      const Node& from = path.nodes[n - 1];
      const Node& to = path.nodes[n];
      add_edge(covariance, EdgeWalk(a, from.i, to.i), EdgeWalk(b, from.j, to.j));
    }
    return std::move(covariance).take();
  }
  for (const Node& node : path.nodes) {
    covariance.add(1.0, a.tangents_out[static_cast<std::size_t>(node.i) % a.size()],
                   b.tangents_out[static_cast<std::size_t>(node.j) % b.size()]);
  }
  return std::move(covariance).take();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
