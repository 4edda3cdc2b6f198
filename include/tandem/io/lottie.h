#pragma once

#include <string>

#include "tandem/io/animation.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// A Lottie animation (JSON, as bodymovin 5.7 writes it) of 60 frames a second: one shape layer, one path per
/// contour with the same vertices in all key frames; closed contours are filled, open ones stroked, unless
/// `look` says otherwise (its currentColor is black). A turning
/// frame turns the layer. It holds one run, there and, when options.alternate, back: whether it repeats is
/// for the player to say. size: pixels of the longer side. @throws InvalidArgument duration, easing or size
/// that cannot be
[[nodiscard]] TANDEM_IO_EXPORT std::string format_lottie(const PathMorph& morph, const std::string& title,
                                                         const AnimationOptions& options = {}, int size = 512,
                                                         const Look& look = {});

}  // namespace v0
}  // namespace tandem
