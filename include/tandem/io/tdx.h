#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/rank/shape_descriptor.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// Index files (.tdx): shapes prepared for rank(). Binary, little-endian on every machine, version 2:
///
///   8 bytes   89 54 44 58 0D 0A 1A 0A: a file that was sent as text is noticed
///   u32 u32   version; 0
///   u64       number of records
///   record:   u32 bytes that follow, u64 included; u32 flags (1: closed); u32 dimension d; u32 chords m; u32
///   u32 bytes of
///             name and label; name; label (UTF-8); m * d floats, tangents; m floats, shares of the length;
///             u64 FNV-1a hash of the record so far, its first word left out
///
/// Descriptors hold floats, so they read back equal.

/// The head of a file with that many records.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_tdx_head(std::size_t records);
/// One record. @throws InvalidArgument name and label are too long (16 MiB)
[[nodiscard]] TANDEM_IO_EXPORT std::string format_tdx_record(const ShapeDescriptor& shape);
/// A whole file.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_tdx(std::span<const ShapeDescriptor> shapes);
/// @throws ParseError it is no index, of another version, damaged or cut off
[[nodiscard]] TANDEM_IO_EXPORT std::vector<ShapeDescriptor> parse_tdx(std::string_view content,
                                                                      const std::string& source = "tdx");

/// Reads an index file record by record, so that it may be larger than the memory.
class TANDEM_IO_EXPORT TdxReader {
 public:
  /// @throws IoError; ParseError it is no index or of another version
  explicit TdxReader(const std::string& path);
  TdxReader(TdxReader&&) noexcept;
  TdxReader& operator=(TdxReader&&) noexcept;
  ~TdxReader();

  [[nodiscard]] std::size_t size() const noexcept;
  /// Nothing: the end. @throws ParseError a record is damaged or cut off, or something follows the last one
  [[nodiscard]] std::optional<ShapeDescriptor> next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace v0
}  // namespace tandem
