#pragma once

#include <optional>
#include <string>

#include "tandem/surface/certificate.h"
#include "tandem/surface/skin.h"
#include "tandem/surface/solid.h"

namespace cli {

/// docs/interface.md, "The report of a skin": a JSON object.
[[nodiscard]] std::string format_skin_report(const tandem::SkinnedSurface& skinned,
                                             const std::optional<tandem::Certificate>& certificate = {});
[[nodiscard]] std::string format_solid_report(const tandem::Solid& solid);

}  // namespace cli
