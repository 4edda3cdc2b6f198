#include "surface/check_loft.h"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

void check_sections(std::span<const Curve> sections, const LoftOptions& options) {
  const std::size_t least = options.closed ? 3 : 2;
  if (sections.size() < least) {
    throw InvalidArgument(fmt::format("{} section{}, expected at least {}{}", sections.size(),
                                      sections.size() == 1 ? "" : "s", least,
                                      options.closed ? " for a closed loft" : ""));
  }
  const Curve& first = sections.front();
  for (std::size_t j = 0; j < sections.size(); ++j) {
    if (sections[j].dim() != first.dim()) {
      throw InvalidArgument(fmt::format("section {} has dimension {}, section 0 has {}; expected the same", j,
                                        sections[j].dim(), first.dim()));
    }
    if (sections[j].is_closed() != first.is_closed()) {
      throw InvalidArgument(fmt::format("section {} is {}, section 0 is {}; expected all open or all closed", j,
                                        sections[j].is_closed() ? "closed" : "open",
                                        first.is_closed() ? "closed" : "open"));
    }
  }
}

void check_options(std::size_t sections, int degree, const LoftOptions& options) {
  if (options.degree < 1 || options.degree > kHighestDegree) {
    throw InvalidArgument(fmt::format("the degree across the sections is {}, expected 1 .. {}",
                                      options.degree, kHighestDegree));
  }
  if (options.closed && (options.rows || options.tolerance)) {
    throw InvalidArgument("a closed loft interpolates: expected neither rows nor a tolerance");
  }
  if (options.rows && options.tolerance) {
    throw InvalidArgument("both rows and a tolerance are given, expected one of them");
  }
  if (options.rows && (*options.rows <= degree || static_cast<std::size_t>(*options.rows) > sections)) {
    throw InvalidArgument(fmt::format("{} rows for {} sections and degree {}, expected {} .. {}",
                                      *options.rows, sections, degree, degree + 1, sections));
  }
  if (options.tolerance && !(*options.tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("the tolerance is {}, expected > 0", *options.tolerance));
  }
}

}  // namespace

int check_loft(std::span<const Curve> sections, const LoftOptions& options) {
  check_sections(sections, options);
  const int degree = std::min(options.degree, static_cast<int>(sections.size()) - 1);
  check_options(sections.size(), degree, options);
  return degree;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
