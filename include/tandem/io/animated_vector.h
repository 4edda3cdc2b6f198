#pragma once

#include <string>

#include "tandem/io/animation.h"
#include "tandem/io/look.h"
#include "tandem/morph/path_morph.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// An Android animated vector drawable in one file (<aapt:attr>), for res/drawable; 24 dp on its longer side.
/// Closed contours are filled, open ones stroked, unless `look` says otherwise (its currentColor is black); a
/// turning frame is an animated group.
///
/// Android animates a path from one value to another, so every frame but the last has an animator of its own,
/// and only single animators repeat: with two frames (two keys and an affine blend) the drawable runs for
/// ever as `options` say; with more it runs from the first key to the last, once, and stays there.
/// @throws InvalidArgument duration or easing that cannot be
[[nodiscard]] TANDEM_IO_EXPORT std::string format_animated_vector(const PathMorph& morph,
                                                                  const AnimationOptions& options = {},
                                                                  const Look& look = {});

}  // namespace v0
}  // namespace tandem
