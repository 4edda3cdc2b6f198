#include "cad_cases.h"

#include <nlohmann/json.hpp>

#include "tandem/io/files.h"
#include "tandem/io/json.h"

namespace tandem::testing {

std::vector<Curve> cad_case(const std::string& name) {
  const std::string path = std::string(TANDEM_TEST_DATA) + "/cad-cases.json";
  return parse_json_curves(nlohmann::json::parse(read_file(path)).at(name).dump(), path);
}

}  // namespace tandem::testing
