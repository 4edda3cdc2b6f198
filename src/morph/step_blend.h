#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "morph/contour_blend.h"
#include "morph/detour.h"
#include "morph/planar_frame.h"
#include "tandem/morph/blend.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// One contour at both keys of a step, with the same segments.
struct ContourEnds {
  CubicPath a;
  CubicPath b;
};

/// What a contour does on the way, by a bump in s that is zero at both ends, to keep clear of itself and of
/// the others.
struct ContourDetour {
  double width = 0.0;   ///< of the filter, see Detour
  double shrink = 0.0;  ///< towards its centre, in [0, 1)
  Vec2 offset{};        ///< of its centre
  /// Whether it keeps small for longer: of a contour that grows from a point, or dies to one.
  bool late = false;
  [[nodiscard]] bool is_none() const noexcept {
    return width == 0.0 && shrink == 0.0 && offset == Vec2{} && !late;
  }
};

/// The in-betweens of all contours of one step.
class StepBlend {
 public:
  /// kind: any but automatic. scale: of the frame, used by `similarity` alone.
  StepBlend(BlendKind kind, const PlanarFrame& frame, std::span<const ContourEnds> contours);

  /// Sends a contour on a detour.
  void set_detour(std::size_t contour, const ContourDetour& detour);
  /// Lets a contour start and end as `drawn`, which has its segments, from and to where its blend is on its
  /// own: chords of pieces come in from the outline, and go out to it, fast but smoothly.
  void set_outlines(std::size_t contour, const ContourEnds& drawn);
  /// Lets detours begin and end at rest, and so without a break of velocity.
  void make_detours_gentle() noexcept { gentle_ = true; }

  [[nodiscard]] std::size_t contour_count() const noexcept { return contours_.size(); }
  /// Number of coordinates of a contour.
  [[nodiscard]] std::size_t size(std::size_t contour) const noexcept { return contours_[contour].size; }
  /// Coordinates of a contour's control points at s.
  void at(double s, std::size_t contour, std::span<double> points) const;
  [[nodiscard]] bool is_closed(std::size_t contour) const noexcept { return contours_[contour].closed; }
  /// Whether a segment that is a straight line in both keys is one all the way.
  [[nodiscard]] bool keeps_line(std::size_t contour, std::size_t segment) const {
    return !contours_[contour].filter && contours_[contour].blend->keeps_line(segment);
  }
  /// Both keys' contours as the frame sees them.
  [[nodiscard]] std::vector<ContourEnds> ends_in_frame() const;
  /// Whether the contour is drawn otherwise at the ends than it blends.
  [[nodiscard]] bool has_outlines(std::size_t contour) const noexcept {
    return !contours_[contour].off_first.empty();
  }
  /// How far the contours are at s. Pieces part late, when most of the way of their chords is done: a gap
  /// opens where it stays.
  [[nodiscard]] double progress(double s) const noexcept;
  /// How much is left at s of what is drawn at the ends alone.
  struct OutlineShares {
    double first;
    double last;
  };
  [[nodiscard]] static OutlineShares outline_shares(double s) noexcept;
  /// By how much the frame turns.
  [[nodiscard]] double degrees() const noexcept { return frame_.degrees(); }
  [[nodiscard]] const ContourDetour& detour(std::size_t contour) const noexcept {
    return contours_[contour].detour;
  }
  /// Whether all of it runs straight, but for the turn of the frame.
  [[nodiscard]] bool is_linear() const noexcept;

 private:
  struct Contour {
    std::unique_ptr<const ContourBlend> blend;
    std::size_t size;
    bool closed;
    bool born;         ///< grows from a point
    ContourEnds ends;  ///< as the frame sees them
    ContourDetour detour;
    std::optional<Detour> filter;
    std::vector<double> off_first;  ///< from what is blended to what is drawn at the ends, in the frame
    std::vector<double> off_last;
  };
  PlanarFrame frame_;
  std::vector<Contour> contours_;
  bool gentle_ = false;
  bool parts_first_ = false;  ///< whether pieces part from the first key on
  bool parts_last_ = false;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
