#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {

/// A glyph of a font and what it is called.
struct NamedGlyph {
  std::string name;       ///< as read_glyph() takes it
  std::string character;  ///< UTF-8; empty when no character leads to it
  Shape outline;          ///< in font units, y up; no contours: a blank
};

/// All glyphs of a font, one after the other.
class FontReader {
 public:
  /// @throws IoError, ParseError as read_glyph()
  explicit FontReader(const std::string& path);
  FontReader(FontReader&&) noexcept;
  FontReader& operator=(FontReader&&) noexcept;
  ~FontReader();

  [[nodiscard]] std::size_t size() const;
  /// index < size(). @throws ParseError its outline cannot be read
  [[nodiscard]] NamedGlyph glyph(std::size_t index) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace v0
}  // namespace tandem
