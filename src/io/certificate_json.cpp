#include "tandem/io/certificate_json.h"

#include <fmt/format.h>

#include <iterator>

#include "io/json_writer.h"

namespace tandem {
inline namespace v0 {
namespace {

std::string_view name(WitnessKind kind) noexcept {
  switch (kind) {
    case WitnessKind::sign_change:
      return "sign_change";
    case WitnessKind::crossing:
      return "crossing";
    case WitnessKind::triangles:
      return "triangles";
    case WitnessKind::zero:
      break;
  }
  return "zero";
}

void append_place(std::string& out, const SurfacePlace& place) {
  out += R"({"u": )";
  append_json_number(out, place.u);
  out += R"(, "v": )";
  append_json_number(out, place.v);
  out += R"(, "point": )";
  append_json_numbers(out, place.point);
  out += R"(, "jacobian": )";
  append_json_number(out, place.jacobian);
  out += '}';
}

void append_witness(std::string& out, const Witness& witness) {
  fmt::format_to(std::back_inserter(out), R"({{"kind": "{}", "places": [)", name(witness.kind));
  for (const SurfacePlace& place : witness.places) {
    if (&place != &witness.places.front()) out += ", ";
    append_place(out, place);
  }
  out += ']';
  if (witness.kind == WitnessKind::triangles)
    fmt::format_to(std::back_inserter(out), R"(, "triangles": [{}, {}])", witness.triangles[0],
                   witness.triangles[1]);
  out += '}';
}

}  // namespace

std::string_view name(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::certified:
      return "certified";
    case Verdict::violated:
      return "violated";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

std::string format_json_certificate(const Certificate& certificate) {
  std::string out;
  const auto member = [&](std::string_view key, Verdict verdict) {
    fmt::format_to(std::back_inserter(out), "{}  \"{}\": \"{}\"", out.empty() ? "" : ",\n", key,
                   name(verdict));
  };
  member("certificate", certificate.verdict);
  member("regular", certificate.regular);
  if (certificate.one_to_one) member("one_to_one", *certificate.one_to_one);
  if (certificate.tessellation_simple) member("tessellation_simple", *certificate.tessellation_simple);
  if (certificate.witness) {
    out += ",\n  \"witness\": ";
    append_witness(out, *certificate.witness);
  }
  return out;
}

}  // namespace v0
}  // namespace tandem
