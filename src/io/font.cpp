#include "tandem/io/font.h"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/font_reader.h"
#include "tandem/error.h"
#include "tandem/io/files.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
inline namespace v0 {
namespace {

class Library {
 public:
  Library() {
    if (FT_Init_FreeType(&library_) != 0) throw IoError("cannot start FreeType");
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { FT_Done_FreeType(library_); }
  [[nodiscard]] FT_Library get() const noexcept { return library_; }

 private:
  FT_Library library_ = nullptr;
};

class Face {
 public:
  Face(const Library& library, const std::string& content, const std::string& path) {
    const FT_Error error = FT_New_Memory_Face(library.get(), reinterpret_cast<const FT_Byte*>(content.data()),
                                              static_cast<FT_Long>(content.size()), 0, &face_);
    if (error == 0) return;
    const char* reason = FT_Error_String(error);
    throw ParseError(path, 0, 0,
                     fmt::format("is no font that can be read{}{}", reason == nullptr ? "" : ": ",
                                 reason == nullptr ? "" : reason));
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() { FT_Done_Face(face_); }
  [[nodiscard]] FT_Face get() const noexcept { return face_; }

 private:
  FT_Face face_ = nullptr;
};

/// The code point that all of `text` is, in UTF-8.
std::optional<std::uint32_t> single_character(std::string_view text) {
  if (text.empty()) return std::nullopt;
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length == 0 || text.size() != length) return std::nullopt;
  std::uint32_t code = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0U) != 0x80U) return std::nullopt;
    code = (code << 6U) | (next & 0x3FU);
  }
  return code;
}

std::optional<std::uint32_t> number_after(std::string_view text, std::string_view prefix, std::uint32_t base,
                                          std::size_t fewest, std::size_t most) {
  if (text.substr(0, prefix.size()) != prefix) return std::nullopt;
  text.remove_prefix(prefix.size());
  if (text.size() < fewest || text.size() > most) return std::nullopt;
  std::uint32_t value = 0;
  for (const char c : text) {
    const bool letter = (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
    if (!(c >= '0' && c <= '9') && !(base == 16 && letter)) return std::nullopt;
    const auto digit = static_cast<std::uint32_t>(c <= '9' ? c - '0' : (c & 0x5F) - 'A' + 10);
    value = value * base + digit;
  }
  return value;
}

/// uniXXXX, uXXXX to uXXXXXX (Adobe's glyph naming), or U+XXXX.
std::optional<std::uint32_t> named_character(std::string_view name) {
  if (const auto code = number_after(name, "uni", 16, 4, 4)) return code;
  if (const auto code = number_after(name, "u", 16, 4, 6)) return code;
  return number_after(name, "U+", 16, 4, 6);
}

FT_UInt index_of_character(FT_Face face, std::uint32_t code) {
  if (const FT_UInt index = FT_Get_Char_Index(face, code)) return index;
  // Symbol fonts keep their characters in a private area.
  constexpr std::uint32_t kSymbols = 0xF000;
  if (code >= 0x100 || FT_Select_Charmap(face, FT_ENCODING_MS_SYMBOL) != 0) return 0;
  return FT_Get_Char_Index(face, kSymbols + code);
}

FT_UInt index_of_name(FT_Face face, const std::string& name) {
  return FT_HAS_GLYPH_NAMES(face) ? FT_Get_Name_Index(face, const_cast<FT_String*>(name.c_str())) : 0;
}

FT_UInt find_glyph(FT_Face face, const std::string& path, const std::string& glyph) {
  if (const auto code = single_character(glyph)) {
    if (const FT_UInt index = index_of_character(face, *code)) return index;
    throw ParseError(path, 0, 0, fmt::format("has no glyph for '{}' (U+{:04X})", glyph, *code));
  }
  if (const FT_UInt index = index_of_name(face, glyph)) return index;
  if (const auto code = named_character(glyph)) {
    if (const FT_UInt index = index_of_character(face, *code)) return index;
    throw ParseError(path, 0, 0, fmt::format("has no glyph for U+{:04X}", *code));
  }
  if (glyph == ".notdef") return 0;
  const auto index = number_after(glyph, "glyph", 10, 1, 6);
  if (index && *index < static_cast<std::uint32_t>(face->num_glyphs)) return *index;
  throw ParseError(path, 0, 0,
                   fmt::format("has no glyph '{}'; expected a character, uniXXXX, or a glyph name", glyph));
}

Vec2 point(const FT_Vector* p) {
  return {static_cast<double>(p->x), static_cast<double>(p->y)};
}

/// FreeType's walk along an outline; each contour is closed without being told so.
struct Pen {
  PathBuilder builder;

  static int move_to(const FT_Vector* to, void* pen) {
    PathBuilder& builder = static_cast<Pen*>(pen)->builder;
    if (builder.has_current()) builder.close();
    builder.move_to(point(to));
    return 0;
  }
  static int line_to(const FT_Vector* to, void* pen) {
    static_cast<Pen*>(pen)->builder.line_to(point(to));
    return 0;
  }
  static int quad_to(const FT_Vector* control, const FT_Vector* to, void* pen) {
    static_cast<Pen*>(pen)->builder.quad_to(point(control), point(to));
    return 0;
  }
  static int cubic_to(const FT_Vector* control1, const FT_Vector* control2, const FT_Vector* to, void* pen) {
    static_cast<Pen*>(pen)->builder.cubic_to(point(control1), point(control2), point(to));
    return 0;
  }
};

std::vector<CubicPath> trace(FT_Outline& outline) {
  FT_Outline_Funcs functions{};
  functions.move_to = Pen::move_to;
  functions.line_to = Pen::line_to;
  functions.conic_to = Pen::quad_to;
  functions.cubic_to = Pen::cubic_to;
  Pen pen;
  if (FT_Outline_Decompose(&outline, &functions, &pen) != 0) return {};
  if (pen.builder.has_current()) pen.builder.close();
  return pen.builder.take();
}

/// The outline as it was drawn, y up; no contours: a blank.
Shape outline(FT_Face face, FT_UInt index, const std::string& path, const std::string& glyph) {
  if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0 ||
      face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
    throw ParseError(path, 0, 0, fmt::format("the glyph '{}' has no outline that can be read", glyph));
  }
  return to_shape(trace(face->glyph->outline));
}

std::string utf8(std::uint32_t code) {
  const auto tail = [&](unsigned shift) { return static_cast<char>(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U | (code >> 6U)), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0U | (code >> 12U)), tail(6), tail(0)};
  return {static_cast<char>(0xF0U | (code >> 18U)), tail(12), tail(6), tail(0)};
}

}  // namespace

Shape read_glyph(const std::string& path, const std::string& glyph) {
  const std::string content = read_file(path);
  const Library library;
  const Face face(library, content, path);
  Shape shape = outline(face.get(), find_glyph(face.get(), path, glyph), path, glyph);
  if (shape.contours.empty())
    throw ParseError(path, 0, 0, fmt::format("the glyph '{}' has no outline", glyph));
  return shape;
}

struct FontReader::Impl {
  std::string path;
  std::string content;
  Library library;
  Face face;
  std::vector<std::uint32_t> characters;  ///< per glyph, the smallest that leads to it; 0: none

  explicit Impl(const std::string& file)
      : path(file),
        content(read_file(file)),
        face(library, content, file),
        characters(static_cast<std::size_t>(face.get()->num_glyphs)) {
    FT_UInt index = 0;
    for (FT_ULong code = FT_Get_First_Char(face.get(), &index); index != 0;
         code = FT_Get_Next_Char(face.get(), code, &index)) {
      if (index < characters.size() && characters[index] == 0)
        characters[index] = static_cast<std::uint32_t>(code);
    }
  }

  /// The name in the font where that leads back to the glyph, else the character, else the index.
  [[nodiscard]] std::string name_of(FT_UInt index) const {
    if (FT_HAS_GLYPH_NAMES(face.get())) {
      std::array<char, 128> name{};
      if (FT_Get_Glyph_Name(face.get(), index, name.data(), name.size()) == 0 && name[0] != '\0' &&
          !single_character(name.data()) && index_of_name(face.get(), name.data()) == index) {
        return name.data();
      }
    }
    const std::uint32_t code = characters[index];
    if (code > 0x20 && code < 0x7F) return utf8(code);
    if (code != 0) return code < 0x10000 ? fmt::format("uni{:04X}", code) : fmt::format("u{:04X}", code);
    return fmt::format("glyph{}", index);
  }
};

FontReader::FontReader(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
FontReader::FontReader(FontReader&&) noexcept = default;
FontReader& FontReader::operator=(FontReader&&) noexcept = default;
FontReader::~FontReader() = default;

std::size_t FontReader::size() const {
  return impl_->characters.size();
}

NamedGlyph FontReader::glyph(std::size_t index) const {
  const auto id = static_cast<FT_UInt>(index);
  NamedGlyph glyph{impl_->name_of(id), {}, {}};
  if (impl_->characters[index] != 0) glyph.character = utf8(impl_->characters[index]);
  glyph.outline = outline(impl_->face.get(), id, impl_->path, glyph.name);
  return glyph;
}

}  // namespace v0
}  // namespace tandem
