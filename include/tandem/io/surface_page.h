#pragma once

#include <string>

#include "tandem/io/scene.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// A self-contained HTML page (no network) that shows the scene with WebGL: turned, moved and zoomed with mouse,
/// fingers or keys; iso-lines, triangles and the tint of back faces can be switched. Coordinates are floats of
/// 32 bits there. @throws InvalidArgument a scene without triangles
[[nodiscard]] TANDEM_IO_EXPORT std::string format_scene_page(const Scene& scene, const std::string& title);

}  // namespace v0
}  // namespace tandem
