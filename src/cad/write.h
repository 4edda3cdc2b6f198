#pragma once

#include <span>
#include <string>

#include "tandem/io/cad.h"

namespace tandem {
inline namespace v0 {
namespace cad {

/// As format_cad().
[[nodiscard]] std::string format(CadFormat format, std::span<const Curve> curves,
                                 std::span<const Surface> surfaces);

}  // namespace cad
}  // namespace v0
}  // namespace tandem
