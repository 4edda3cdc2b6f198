#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

enum class Format {
  json,
  json_lines,
  svg,
  html,
  css,
  lottie,
  animated_vector,
  gif,
  png,
  itd,
  index,
  npy,
  csv,
  obj,
  stl,
  ply,
  glb,
  step,
  iges,
  brep,
  directory
};

/// The format of an output: `to` when given, else by the ending of `path`; "-" is JSON, or what
/// else the command writes. A directory stays one when `to` says svg, png or csv: that is what its frames are
/// then. allowed: what the command can write.
/// @throws UsageError an ending that the command does not know
[[nodiscard]] Format output_format(const std::string& path, const std::string& to,
                                   const std::vector<Format>& allowed);

/// Before work whose result could not be written there. frames: to a directory of them.
/// @throws tandem::IoError a directory (but of frames), or in one that is not there or not to be written to
void check_writable(const std::string& path, bool frames = false);

/// tandem::write_file, and Ctrl-C waits until the file is whole. @throws tandem::IoError; Interrupted
void write_output(const std::string& path, std::string_view content);

/// Writes the files frame_000 + ending, ... with content(0..count-1) as a whole directory or not at all. An
/// existing directory is replaced if it is empty or holds nothing but frames of an earlier run.
/// ending: ".svg", ".png" or ".csv".
/// @throws tandem::IoError; Interrupted; and what `content` throws
void write_frame_directory(const std::string& path, std::size_t count, std::string_view ending,
                           const std::function<std::string(std::size_t)>& content);

}  // namespace cli
