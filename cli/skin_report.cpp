#include "skin_report.h"

#include <fmt/format.h>

#include <span>

#include "report.h"
#include "tandem/io/certificate_json.h"
#include "tandem/version.h"

namespace cli {
namespace {

std::string numbers(std::span<const double> values) {
  std::string list;
  for (const double x : values) list += (list.empty() ? "" : ", ") + json_number(x);
  return "[" + list + "]";
}

const char* word(bool value) {
  return value ? "true" : "false";
}

std::string format_pair(const tandem::SkinPair& pair) {
  return fmt::format(R"({{"valid": {}, "min_dot": {}, "valid_share": {}, "cost": {}, "direction": "{}"}})",
                     word(pair.validity.valid), json_number(pair.validity.min_dot),
                     json_number(pair.validity.valid_share), json_number(pair.cost),
                     pair.direction == tandem::Direction::reversed ? "reversed" : "forward");
}

std::string format_law(const tandem::Reparametrization& law) {
  return fmt::format(R"({{"degree": {}, "knots": {}, "points": {}, "reversed": {}}})", law.v.degree(),
                     numbers(law.v.knots()), numbers(law.v.control_points().data()), word(law.reversed));
}

}  // namespace

std::string format_skin_report(const tandem::SkinnedSurface& skinned,
                               const std::optional<tandem::Certificate>& certificate) {
  const tandem::SkinReport& report = skinned.report;
  std::string pairs;
  for (const tandem::SkinPair& pair : report.pairs) {
    pairs += (pairs.empty() ? "\n    " : ",\n    ") + format_pair(pair);
  }
  std::string laws;
  for (const tandem::Reparametrization& law : skinned.laws) {
    laws += (laws.empty() ? "\n    " : ",\n    ") + format_law(law);
  }
  return fmt::format(
      "{{\n  \"tandem\": \"{}\",\n  \"valid\": {},\n  \"total_cost\": {},\n  \"sequence_cost\": {},\n  "
      "\"sweeps\": {},\n  \"refined\": {},\n"
      "  \"crease_angle\": {},\n  \"section_crease_angle\": {},\n  \"wrong_sign_share\": {},\n  "
      "\"law_deviation\": {},\n  "
      "\"interpolation_error\": {},\n  \"parameters\": "
      "{},\n"
      "  \"pairs\": [{}],\n  \"laws\": [{}]{}\n}}",
      tandem::version(), word(report.valid), json_number(report.total_cost),
      json_number(report.sequence_cost), report.sweeps, report.refined, json_number(report.crease_angle),
      json_number(report.section_crease_angle), json_number(report.wrong_sign_share),
      json_number(report.law_deviation), json_number(report.interpolation_error), numbers(skinned.parameters),
      pairs, laws, certificate ? ",\n" + tandem::format_json_certificate(*certificate) : "");
}

std::string format_solid_report(const tandem::Solid& solid) {
  const tandem::SolidReport& report = solid.report;
  return fmt::format(
      "{{\n  \"tandem\": \"{}\",\n  \"triangles\": {},\n  \"vertices\": {},\n  \"volume\": {},\n  \"bands\": "
      "{},\n"
      "  \"branches\": {},\n  \"caps\": {},\n  \"left_out\": {},\n  \"valid_share\": {},\n  "
      "\"tessellation_simple\": \"{}\"\n}}",
      tandem::version(), solid.mesh.triangles.size(), solid.mesh.vertices.size(), json_number(report.volume),
      report.bands, report.branches, report.caps, report.left_out, json_number(report.valid_share),
      tandem::name(report.simple));
}

}  // namespace cli
