#include "rule_report.h"

#include <fmt/format.h>

#include <string>

#include "report.h"
#include "tandem/io/certificate_json.h"
#include "tandem/io/json.h"

namespace cli {
namespace {

using tandem::Certificate;
using tandem::LawOutcome;
using tandem::RulingReport;
using tandem::Validity;

const char* word(bool value) {
  return value ? "true" : "false";
}

const char* name(LawOutcome outcome) {
  switch (outcome) {
    case LawOutcome::finer:
      return "finer";
    case LawOutcome::lower_order:
      return "lower_order";
    case LawOutcome::least_bad:
      return "least_bad";
    case LawOutcome::beyond_tolerance:
      return "beyond_tolerance";
    case LawOutcome::as_asked:
      break;
  }
  return "as_asked";
}

std::string format_validity(const Validity& validity) {
  return fmt::format(R"({{"valid": {}, "min_dot": {}, "valid_share": {}, "worst_u": {}}})",
                     word(validity.valid), json_number(validity.min_dot), json_number(validity.valid_share),
                     json_number(validity.worst_u));
}

std::string format_law(const tandem::LawReport& law) {
  return fmt::format(
      R"({{"outcome": "{}", "order": {}, "tolerance": {}, "max_deviation": {}, "refined": {}}})",
      name(law.outcome), law.order, json_number(law.tolerance), json_number(law.max_deviation),
      word(law.refined));
}

std::string format_rulings(const RulingReport& rulings) {
  return fmt::format(
      "  \"warp_angle\": {},\n  \"mean_warp_angle\": {},\n  \"inclination\": {},\n"
      "  \"mean_inclination\": {},\n  \"twisted_share\": {}",
      json_number(rulings.warp_angle), json_number(rulings.mean_warp_angle), json_number(rulings.inclination),
      json_number(rulings.mean_inclination), json_number(rulings.twisted_share));
}

/// The match report, and `fields` before its closing brace.
std::string with_fields(const tandem::Match& match, const std::string& fields) {
  std::string text = trimmed(tandem::format_json_report(match));
  text.pop_back();
  return trimmed(std::move(text)) + ",\n" + fields + "\n}";
}

}  // namespace

std::string format_rule_report(const tandem::RuledSurface& ruled,
                               const std::optional<Certificate>& certificate) {
  const tandem::RuledReport& report = ruled.report;
  std::string fields = fmt::format(
      "  \"planar\": {},\n  \"tangents\": {},\n  \"wrong_sign_share\": {},\n  \"crease_angle\": {},\n{},\n"
      "  \"law\": {}",
      word(report.planar), format_validity(report.tangents), json_number(report.wrong_sign_share),
      json_number(report.rulings.crease_angle), format_rulings(report.rulings), format_law(report.law));
  if (certificate) fields += ",\n" + tandem::format_json_certificate(*certificate);
  return with_fields(ruled.match, fields);
}

std::string format_blend_report(const tandem::HermiteSurface& blend) {
  const tandem::HermiteReport& report = blend.report;
  return with_fields(blend.match, fmt::format("  \"crease_angle\": {},\n{},\n  \"law\": {}",
                                              json_number(report.crease_angle),
                                              format_rulings(report.rulings), format_law(report.law)));
}

}  // namespace cli
