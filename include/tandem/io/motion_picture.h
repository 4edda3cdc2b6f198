#pragma once

#include <string>
#include <vector>

#include "tandem/io/animation.h"
#include "tandem/morph/motion_morph.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// What a picture of motions shows beside the motions.
struct MotionPicture {
  std::vector<std::string> columns;  ///< names of the time and of each coordinate
  std::string title;
  std::vector<double> in_betweens;  ///< s of each; empty: three of every step
};

/// Every coordinate over time, one small plot each: the motions from blue to orange, in-betweens thin.
/// @throws InvalidArgument other numbers of names than coordinates and time; s that is not finite
[[nodiscard]] TANDEM_IO_EXPORT std::string format_motion_svg(const MotionMorph& morph,
                                                             const MotionPicture& picture);

/// The same plots as a page with a slider from the first motion to the last; it needs no network. It plays as
/// `options` say. @throws InvalidArgument as above, and as check of the options
[[nodiscard]] TANDEM_IO_EXPORT std::string format_motion_html(const MotionMorph& morph,
                                                              const MotionPicture& picture,
                                                              const AnimationOptions& options = {});

}  // namespace v0
}  // namespace tandem
