#pragma once

#include <string>

#include "tandem/io/animation.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// One in-between as PNG, on transparent ground: closed contours filled, open ones stroked, unless `look`
/// says otherwise (its currentColor is black). All s in [0,1] show the same part of the plane; beyond, it
/// grows to hold the in-between. size: pixels of the longer side, 1 to 8192. @throws InvalidArgument size, or
/// more than 32,767 control points
[[nodiscard]] TANDEM_IO_EXPORT std::string format_png(const PathMorph& morph, double s, int size = 512,
                                                      const Look& look = {});

/// The animation as GIF on white ground; it repeats for ever or not at all, as options.repeat says.
/// frame_count: in-betweens from the first key to the last, at least 2; 0: 25 a second, 1000 at most. Delays
/// are hundredths of a second, and they add up to the duration.
/// @throws InvalidArgument as format_png(); a duration, easing or frame_count that cannot be; frames that are
/// less than two hundredths of a second apart, which no viewer shows as fast
[[nodiscard]] TANDEM_IO_EXPORT std::string format_gif(const PathMorph& morph,
                                                      const AnimationOptions& options = {},
                                                      int frame_count = 0, int size = 512,
                                                      const Look& look = {});

}  // namespace v0
}  // namespace tandem
