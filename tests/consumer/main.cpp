#include <cstdio>
#include <string>

#include "tandem/io/json.h"
#include "tandem/tandem.h"

int main() {
  const tandem::Curve line = tandem::Curve::bezier({{0, 0}, {1, 2}, {3, 2}, {4, 0}});
  const tandem::Curve bow = tandem::Curve::bezier({{0, 1}, {1, 4}, {3, 1}, {4, 1}});
  const tandem::Match match = tandem::match(line, bow);
  const std::string text = tandem::format_json_curves(std::span(&match.curve, 1));
  const bool same = tandem::parse_json_curves(text).at(0) == match.curve;
  std::printf("tandem %s: cost %g, read back %s\n", std::string(tandem::version()).c_str(), match.report.cost,
              same ? "equal" : "different");
  return tandem::version() == tandem::kVersion && same ? 0 : 1;
}
