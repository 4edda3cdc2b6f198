#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tandem::test {

/// Big-endian bytes, as fonts have them.
class FontBytes {
 public:
  FontBytes& u8(unsigned value) {
    bytes_ += static_cast<char>(value & 0xFFU);
    return *this;
  }
  FontBytes& u16(unsigned value) { return u8(value >> 8U).u8(value); }
  FontBytes& i16(int value) { return u16(static_cast<unsigned>(value) & 0xFFFFU); }
  FontBytes& u32(std::uint32_t value) { return u16(value >> 16U).u16(value & 0xFFFFU); }
  FontBytes& text(const std::string& value) {
    bytes_ += value;
    return *this;
  }
  FontBytes& pad() {
    while (bytes_.size() % 4 != 0) u8(0);
    return *this;
  }
  [[nodiscard]] const std::string& get() const { return bytes_; }

 private:
  std::string bytes_;
};

struct FontPoint {
  int x;
  int y;
  bool on_curve = true;
};

/// One simple TrueType glyph.
inline std::string simple_glyph(const std::vector<std::vector<FontPoint>>& contours) {
  FontBytes glyph;
  glyph.i16(static_cast<int>(contours.size())).i16(0).i16(0).i16(1000).i16(1000);
  unsigned last = 0;
  for (const auto& contour : contours) glyph.u16((last += static_cast<unsigned>(contour.size())) - 1);
  glyph.u16(0);
  for (const auto& contour : contours) {
    for (const FontPoint& point : contour) glyph.u8(point.on_curve ? 1 : 0);
  }
  for (int axis = 0; axis < 2; ++axis) {
    int at = 0;
    for (const auto& contour : contours) {
      for (const FontPoint& point : contour) {
        const int value = axis == 0 ? point.x : point.y;
        glyph.i16(value - std::exchange(at, value));
      }
    }
  }
  return glyph.pad().get();
}

/// A TrueType font of 1000 units with four glyphs: a square for .notdef, a triangle for A, a ring of
/// quadratics called "ring" for U+00E9 (and U+1F600), and an empty one for the blank. Own work, made for the
/// tests.
inline std::string tiny_font() {
  const std::vector<std::string> glyphs = {simple_glyph({{{0, 0}, {0, 500}, {500, 500}, {500, 0}}}),
                                           simple_glyph({{{0, 0}, {250, 700}, {500, 0}}}),
                                           simple_glyph({{{0, 300},
                                                          {0, 600, false},
                                                          {300, 600},
                                                          {600, 600, false},
                                                          {600, 300},
                                                          {600, 0, false},
                                                          {300, 0},
                                                          {0, 0, false}},
                                                         {{200, 200}, {400, 200}, {400, 400}, {200, 400}}}),
                                           ""};
  const auto count = static_cast<unsigned>(glyphs.size());
  FontBytes glyf;
  FontBytes loca;
  for (const std::string& glyph : glyphs) {
    loca.u32(static_cast<std::uint32_t>(glyf.get().size()));
    glyf.text(glyph);
  }
  loca.u32(static_cast<std::uint32_t>(glyf.get().size()));
  FontBytes head;
  head.u32(0x10000).u32(0x10000).u32(0).u32(0x5F0F3CF5).u16(0).u16(1000).u32(0).u32(0).u32(0).u32(0);
  head.i16(0).i16(0).i16(1000).i16(1000).u16(0).u16(8).i16(2).i16(1).i16(0);
  FontBytes hhea;
  hhea.u32(0x10000).i16(800).i16(-200).i16(0).u16(600);
  for (int i = 0; i < 11; ++i) hhea.i16(0);
  hhea.u16(1);
  FontBytes hmtx;
  hmtx.u16(600).i16(0);
  for (unsigned i = 1; i < count; ++i) hmtx.i16(0);
  FontBytes maxp;
  maxp.u32(0x10000).u16(count).u16(20).u16(4).u16(0).u16(0).u16(1).u16(0);
  for (int i = 0; i < 7; ++i) maxp.u16(0);
  FontBytes cmap;  // format 12, four characters
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> characters = {
      {0x20, 3}, {0x41, 1}, {0xE9, 2}, {0x1F600, 2}};
  cmap.u16(0).u16(1).u16(3).u16(10).u32(12);
  cmap.u16(12).u16(0).u32(16 + 12 * static_cast<std::uint32_t>(characters.size())).u32(0);
  cmap.u32(static_cast<std::uint32_t>(characters.size()));
  for (const auto& [code, glyph] : characters) cmap.u32(code).u32(code).u32(glyph);
  FontBytes post;  // format 2: .notdef, A and space are among Apple's 258 names
  post.u32(0x20000).u32(0).i16(0).i16(0).u32(0).u32(0).u32(0).u32(0).u32(0);
  post.u16(count).u16(0).u16(36).u16(258).u16(3).u8(4).text("ring");

  const std::vector<std::pair<std::string, std::string>> tables = {
      {"cmap", cmap.get()}, {"glyf", glyf.get()}, {"head", head.get()}, {"hhea", hhea.get()},
      {"hmtx", hmtx.get()}, {"loca", loca.get()}, {"maxp", maxp.get()}, {"post", post.get()}};
  FontBytes font;
  font.u32(0x10000).u16(static_cast<unsigned>(tables.size())).u16(128).u16(3).u16(0);
  std::size_t offset = 12 + 16 * tables.size();
  FontBytes body;
  for (const auto& [name, table] : tables) {
    font.text(name).u32(0).u32(static_cast<std::uint32_t>(offset + body.get().size()));
    font.u32(static_cast<std::uint32_t>(table.size()));
    body.text(table).pad();
  }
  return font.get() + body.get();
}

}  // namespace tandem::test
