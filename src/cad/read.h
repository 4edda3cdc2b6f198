#pragma once

#include <string>
#include <vector>

#include "tandem/io/cad.h"

namespace tandem {
inline namespace v0 {
namespace cad {

/// As read_cad_curves().
[[nodiscard]] std::vector<Curve> read_curves(const std::string& path, CadFormat format);

}  // namespace cad
}  // namespace v0
}  // namespace tandem
