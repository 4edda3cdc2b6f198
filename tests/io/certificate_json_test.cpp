#include "tandem/io/certificate_json.h"

#include <gtest/gtest.h>

#include "io/json_value.h"

namespace tandem {
namespace {

TEST(CertificateJson, SaysWhatWasProved) {
  Certificate certificate;
  certificate.verdict = Verdict::certified;
  certificate.regular = Verdict::certified;
  certificate.one_to_one = Verdict::certified;
  EXPECT_EQ(
      format_json_certificate(certificate),
      "  \"certificate\": \"certified\",\n  \"regular\": \"certified\",\n  \"one_to_one\": \"certified\"");
}

TEST(CertificateJson, HasTheWitness) {
  Certificate certificate;
  certificate.verdict = Verdict::violated;
  certificate.tessellation_simple = Verdict::violated;
  certificate.witness =
      Witness{WitnessKind::triangles, {{0.5, 0.25, {1, 2, 3}, 0.0}, {0.75, 1.0, {1, 2, 4}, 0.0}}, {7, 12}};
  const JsonValue json = parse_json("{" + format_json_certificate(certificate) + "}", "test");
  EXPECT_EQ(*json.member("certificate")->text(), "violated");
  EXPECT_EQ(*json.member("regular")->text(), "undecided");
  EXPECT_EQ(*json.member("tessellation_simple")->text(), "violated");
  EXPECT_EQ(json.member("one_to_one"), nullptr);
  const JsonValue* witness = json.member("witness");
  ASSERT_NE(witness, nullptr);
  EXPECT_EQ(*witness->member("kind")->text(), "triangles");
  const JsonValue::Array& places = *witness->member("places")->array();
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(*places[1].member("u")->number(), 0.75);
  EXPECT_EQ(*(*places[1].member("point")->array())[2].number(), 4.0);
  EXPECT_EQ(*(*witness->member("triangles")->array())[1].number(), 12.0);
}

}  // namespace
}  // namespace tandem
