#include "tandem/io/tdx.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "io/scratch_directory.h"
#include "rank/fnv.h"
#include "tandem/error.h"
#include "tandem/io/files.h"

namespace {

using tandem::Curve;
using tandem::describe;
using tandem::ParseError;
using tandem::ShapeDescriptor;

std::vector<ShapeDescriptor> three_shapes() {
  return {describe(Curve::clamped_uniform(1, {{0, 0}, {4, 0}, {4, 3}, {0, 0}}),
                   {.samples = 7, .name = "triangle \xC3\xA9", .label = "t"}),
          describe(Curve::bezier({{0, 0, 1}, {1, 2, 5}, {3, 1, 0}}), {.samples = 4}),
          describe(Curve::bezier({{0}, {1}, {-3}, {7}}), {.samples = 30, .name = std::string(300, 'x')})};
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const ParseError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Tdx, ReadsBackEqual) {
  const std::vector<ShapeDescriptor> shapes = three_shapes();
  EXPECT_EQ(tandem::parse_tdx(tandem::format_tdx(shapes)), shapes);
  EXPECT_TRUE(tandem::parse_tdx(tandem::format_tdx({})).empty());
}

class TdxFile : public tandem::test::ScratchDirectory {};

TEST_F(TdxFile, IsReadRecordByRecord) {
  const std::string path = this->path("a.tdx");
  const std::vector<ShapeDescriptor> shapes = three_shapes();
  tandem::write_file(path, tandem::format_tdx(shapes));
  tandem::TdxReader reader(path);
  EXPECT_EQ(reader.size(), 3U);
  for (const ShapeDescriptor& shape : shapes) EXPECT_EQ(reader.next(), shape);
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.next());
  EXPECT_THROW(tandem::TdxReader("no such file.tdx"), tandem::IoError);
}

/// Every prefix is refused, by both readers, and so is anything behind the end.
TEST_F(TdxFile, IsRefusedWhenCutOffOrTooLong) {
  const std::string path = this->path("cut.tdx");
  const std::string whole = tandem::format_tdx(three_shapes());
  const auto refused = [&](const std::string& content) {
    EXPECT_THROW((void)tandem::parse_tdx(content), ParseError) << content.size();
    tandem::write_file(path, content);
    EXPECT_THROW(
        {
          tandem::TdxReader reader(path);
          while (reader.next()) {
          }
        },
        ParseError)
        << content.size();
  };
  for (std::size_t size = 0; size < whole.size(); size += size < 100 ? 1 : 17) refused(whole.substr(0, size));
  refused(whole + '\0');
}

TEST(Tdx, SaysWhatIsWrong) {
  const std::string whole = tandem::format_tdx(three_shapes());
  const auto with = [&](std::size_t at, char byte) {
    std::string changed = whole;
    changed[at] = byte;
    return message_of([&] { (void)tandem::parse_tdx(changed, "a.tdx"); });
  };
  EXPECT_EQ(with(0, 'x'), "a.tdx: is a .tdx index damaged by being sent as text");
  EXPECT_EQ(message_of([] { (void)tandem::parse_tdx("", "a.tdx"); }), "a.tdx: is no .tdx index");
  EXPECT_EQ(message_of([] { (void)tandem::parse_tdx("PK", "a.tdx"); }), "a.tdx: is no .tdx index");
  EXPECT_EQ(with(8, 3), "a.tdx: is an index of version 3, expected 2: make it anew with tandem index");
  EXPECT_EQ(with(16, 4), "a.tdx: is cut off: it has 3 of 4 records");
  EXPECT_EQ(with(16, 2), "a.tdx: goes on after its 2 records");
  EXPECT_EQ(with(23, 127),
            "a.tdx: is cut off: it has 3 of " + std::to_string((127ULL << 56U) + 3) + " records");
  EXPECT_NE(with(24, 5).find("record 0 is damaged: it cannot have 5 bytes"), std::string::npos);
  EXPECT_EQ(with(36, 8), "a.tdx: record 0 is damaged: its checksum is wrong");
  // Damage that the checksum agrees with.
  const auto signed_with = [&](std::size_t at, char byte) {
    std::string changed = whole;
    changed[at] = byte;
    const auto size = static_cast<unsigned char>(whole[24]) + 256U * static_cast<unsigned char>(whole[25]);
    tandem::detail::Fnv hash;
    hash.add_bytes(std::string_view(changed).substr(28, size - 8));
    for (std::size_t k = 0; k < 8; ++k)
      changed[28 + size - 8 + k] = static_cast<char>(hash.value() >> (8 * k) & 0xFFU);
    return message_of([&] { (void)tandem::parse_tdx(changed, "a.tdx"); });
  };
  EXPECT_NE(signed_with(28, 3).find("record 0 is damaged: flags"), std::string::npos);
  EXPECT_NE(signed_with(36, 8).find("record 0 is damaged: it has"), std::string::npos);
  EXPECT_NE(signed_with(63, 0).find("record 0 tangent 0 has length"), std::string::npos);
}

TEST(Tdx, NoticesEveryDamagedByte) {
  const std::string whole = tandem::format_tdx(three_shapes());
  for (std::size_t at = 28; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    EXPECT_THROW((void)tandem::parse_tdx(changed), ParseError) << at;
  }
}

}  // namespace
