#pragma once

#include <string>

#include "tandem/io/scene.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// A lit picture: in space seen from above at an angle, back faces in another tone; planar scenes from above,
/// folds in red. Lines that something hides are left out. size: of the longer side, 1 to 8192.

/// SVG: the lines as paths over the faces, which are an image of pixels.
/// @throws InvalidArgument size, or a scene without triangles
[[nodiscard]] TANDEM_IO_EXPORT std::string format_scene_svg(const Scene& scene, int size = 1024);
/// PNG on transparent ground. @throws InvalidArgument as format_scene_svg()
[[nodiscard]] TANDEM_IO_EXPORT std::string format_scene_png(const Scene& scene, int size = 1024);

}  // namespace v0
}  // namespace tandem
