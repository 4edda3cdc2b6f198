#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/morph/path_morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// Reads SVG path data (the whole grammar of SVG 2, section 9.3). `source` names it in errors; `fill`:
/// subpaths without Z count as closed when their ends meet within 1e-3 of the diagonal, and are closed by a
/// line. Unlike a browser, which draws what it could read, malformed data is an error.
/// @throws ParseError with line and column
[[nodiscard]] TANDEM_IO_EXPORT std::vector<CubicPath> parse_path_data(std::string_view text,
                                                                      const std::string& source = "path data",
                                                                      bool fill = true,
                                                                      const Transform& transform = {});

/// Path data with absolute M, C, L and Z only. lines[i][k]: segment k of path i is written as L; empty: none
/// is. precision: decimals kept; < 0: shortest text that reads back equal.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_path_data(std::span<const CubicPath> paths,
                                                            std::span<const std::vector<bool>> lines = {},
                                                            int precision = -1);

/// The in-between of `morph` at s as path data: the same commands for every s.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_path_data(const PathMorph& morph, double s,
                                                            int precision = -1);

/// Writes in-betweens of a morph as path data, over and over: an animation needs no allocation for a frame
/// once it has written one. Not for several threads at once.
class TANDEM_IO_EXPORT PathDataWriter {
 public:
  /// precision: see format_path_data. The morph must outlive the writer.
  explicit PathDataWriter(const PathMorph& morph, int precision = -1);

  /// format_path_data(morph, s, precision); valid until the next call.
  [[nodiscard]] std::string_view operator()(double s);

 private:
  const PathMorph* morph_;
  int precision_;
  std::vector<double> points_;
  std::string text_;
};

/// The keys of `morph`, where they are drawn, as path data that is alike but for its numbers, so that any
/// program which blends number by number morphs them. precision < 0: as many decimals as keep rounding below
/// 1e-5 of the larger side.
[[nodiscard]] TANDEM_IO_EXPORT std::vector<std::string> format_key_paths(const PathMorph& morph,
                                                                         int precision = -1);

}  // namespace v0
}  // namespace tandem
