#include "morph/contour_blend.h"

#include <cstddef>

#include "morph/intrinsic_blend.h"
#include "tandem/morph/segment_blend.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

class AffineBlend final : public ContourBlend {
 public:
  AffineBlend(const CubicPath& a, const CubicPath& b) : a_(a.control_points()), b_(b.control_points()) {}

  void at(double s, std::span<double> points) const override {
    const std::span<const double> a = a_.data();
    const std::span<const double> b = b_.data();
    for (std::size_t i = 0; i < a.size(); ++i) points[i] = (1.0 - s) * a[i] + s * b[i];
  }
  [[nodiscard]] bool is_linear() const override { return true; }

 private:
  Points a_;
  Points b_;
};

class HermiteContour final : public ContourBlend {
 public:
  HermiteContour(const CubicPath& a, const CubicPath& b) : blend_(a, b) {}

  void at(double s, std::span<double> points) const override { blend_.at(s, points); }
  [[nodiscard]] bool keeps_line(std::size_t i) const override { return blend_.is_straight(i); }

 private:
  HermiteBlend blend_;
};

}  // namespace

std::unique_ptr<const ContourBlend> make_contour_blend(BlendKind kind, const CubicPath& a,
                                                       const CubicPath& b) {
  switch (kind) {
    case BlendKind::hermite:
      return std::make_unique<HermiteContour>(a, b);
    case BlendKind::intrinsic:
      return std::make_unique<IntrinsicBlend>(a, b);
    default:
      return std::make_unique<AffineBlend>(a, b);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
