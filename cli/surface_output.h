#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "messages.h"
#include "output.h"
#include "tandem/curve/curve.h"
#include "tandem/io/cad.h"
#include "tandem/surface/certificate.h"
#include "tandem/surface/mesh.h"
#include "tandem/surface/surface.h"
#include "tandem/surface/tessellate.h"

namespace cli {

/// Options of the commands that write surfaces, as text.
struct SurfaceFlags {
  std::string chord = "1e-3";
  std::string angle = "0.15";
  std::string size = "1024";
};

void add_surface_flags(CLI::App& app, SurfaceFlags& flags);

/// Where a surface goes and how, checked before there is one.
struct SurfaceOutput {
  std::string path;
  Format format = Format::json;
  tandem::TessellateOptions mesh;
  int size = 0;
};

/// What surfaces are written as.
[[nodiscard]] const std::vector<Format>& surface_formats();

/// The format as the CAD component knows it, if it is one of its own.
[[nodiscard]] std::optional<tandem::CadFormat> cad_format_of(Format format);

/// The endings that surfaces have, as a list for people.
[[nodiscard]] std::string surface_endings();

/// path: what was given as -o; to: what was given as --to.
/// @throws UsageError no path, an ending that is none of surfaces, or values that cannot be;
/// tandem::InvalidArgument a format of the CAD component, without that; tandem::IoError as check_writable()
[[nodiscard]] SurfaceOutput plan_surface_output(const CLI::App& app, const std::string& path,
                                                const std::string& to, const SurfaceFlags& flags);

/// The certificate of the surface, and of the tessellation that would be written where it is not planar.
[[nodiscard]] tandem::Certificate certify(const tandem::Surface& surface, const SurfaceOutput& output);
/// Says so when it is not certified.
void warn(const Messages& messages, const tandem::Certificate& certificate);

/// What is written.
struct SurfaceContent {
  const tandem::Surface* surface = nullptr;    ///< may be missing where there is a mesh
  const tandem::TriangleMesh* mesh = nullptr;  ///< instead of the tessellation; null: that
  std::string members;                         ///< of the JSON object besides: `"report": {...}`; empty: none
  std::vector<tandem::Curve> curves;           ///< drawn boldly in pictures
  std::string title;                           ///< of the page
};

/// @throws tandem::IoError; Interrupted; tandem::InvalidArgument a format that has no place for it (JSON
/// holds surfaces only)
void write_surface(const SurfaceOutput& output, const SurfaceContent& content);

}  // namespace cli
