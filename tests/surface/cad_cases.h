#pragma once

#include <string>
#include <vector>

#include "tandem/curve/curve.h"

namespace tandem::testing {

/// The curves of a case of tests/data/cad-cases.json.
std::vector<Curve> cad_case(const std::string& name);

}  // namespace tandem::testing
