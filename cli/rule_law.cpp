#include "rule_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "surface_output.h"
#include "tandem/error.h"
#include "usage_error.h"

namespace cli {
namespace {

constexpr int kHighestCadDegree = 25;
/// Beyond it the report alone takes minutes, and the coefficients of a composition lose most of their digits.
constexpr int kHighestDegree = 100;

std::string too_high(int degree, int order, int most, bool cad) {
  return fmt::format("the surface would be of degree {} along u, with a law of order {}: {} is the highest{}",
                     degree, order, most, cad ? " of STEP, IGES and BREP" : "");
}

}  // namespace

tandem::LawOptions law_options(const Command& command, tandem::LawOptions usual) {
  if (!command.match.reduce.empty()) {
    throw UsageError(
        fmt::format("{} makes its laws to a tolerance: it takes --tolerance and --order, not --reduce",
                    command.app->get_name()));
  }
  const tandem::MatchOptions match = to_match_options(command.match);
  if (!command.match.order.empty()) usual.order = match.reduction->order;
  if (!command.match.tolerance.empty()) usual.tolerance = match.reduction->tolerance;
  return usual;
}

void warn_of_deviation(const Messages& messages, std::string_view whose, double deviation, double tolerance) {
  if (!(deviation > tolerance)) return;
  messages.warning(fmt::format("{} is {:.3g} of its domain away from the match, {:.3g} was asked for", whose,
                               deviation, tolerance));
}

void warn_of_deviation(const Messages& messages, const std::vector<tandem::Reparametrization>& laws,
                       double tolerance) {
  // The first one has no match.
  const auto furthest = std::max_element(laws.begin() + 1, laws.end(), [](const auto& a, const auto& b) {
    return a.max_deviation < b.max_deviation;
  });
  warn_of_deviation(messages, fmt::format("the law of section {}", furthest - laws.begin()),
                    furthest->max_deviation, tolerance);
}

int ruled_degree(const std::vector<const tandem::Curve*>& kept,
                 const std::vector<const tandem::Curve*>& composed, int q) {
  int highest = 1;
  int all = 0;
  bool rational = false;
  const auto add = [&](const std::vector<const tandem::Curve*>& curves, int factor) {
    for (const tandem::Curve* curve : curves) {
      highest = std::max(highest, factor * curve->degree());
      all += curve->is_rational() ? factor * curve->degree() : 0;
      rational = rational || curve->is_rational();
    }
  };
  add(kept, 1);
  add(composed, q);
  // Over a common denominator degrees add up: those of all weights, and the numerator's own.
  return rational ? std::max(all, highest) : highest;
}

int skinned_degree(const std::vector<tandem::Curve>& sections, int q) {
  int highest = 1;
  for (const tandem::Curve& section : sections) highest = std::max(highest, q * section.degree());
  return highest;
}

void describe_skin_laws(CLI::App& app) {
  app.get_option("--reduce")->group("");  // law_options() says what there is instead
  app.get_option("--order")->description("Order of the laws v: 3 is C1 (default), 2 piecewise linear");
  app.get_option("--tolerance")
      ->description("Error of the laws allowed, as a share of a section's domain (0.002)");
}

void fit_order(const Command& command, Format format, const std::function<int(int)>& degree_with,
               tandem::LawOptions& law, const Messages& messages) {
  const bool cad = cad_format_of(format).has_value();
  const int most = cad ? kHighestCadDegree : kHighestDegree;
  const int usual = law.order;
  const bool given = !command.match.order.empty();
  while (degree_with(law.order - 1) > most) {
    if (law.order == 2) {
      throw tandem::InvalidArgument(too_high(degree_with(1), 2, most, cad) +
                                    ", and no law has a lower order; approximate the curves first");
    }
    if (given) {
      throw tandem::InvalidArgument(too_high(degree_with(law.order - 1), law.order, most, cad) +
                                    "; leave --order out, and it is chosen to fit");
    }
    --law.order;
  }
  if (law.order == usual) return;
  messages.note(
      fmt::format("laws of order {} instead of {}: the surface is of degree {} along u, {} is the highest{}",
                  law.order, usual, degree_with(law.order - 1), most, cad ? " of STEP, IGES and BREP" : ""));
}

}  // namespace cli
