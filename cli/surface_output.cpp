#include "surface_output.h"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/error.h"
#include "tandem/io/cad.h"
#include "tandem/io/certificate_json.h"
#include "tandem/io/glb.h"
#include "tandem/io/obj.h"
#include "tandem/io/ply.h"
#include "tandem/io/scene.h"
#include "tandem/io/stl.h"
#include "tandem/io/surface_json.h"
#include "tandem/io/surface_page.h"
#include "tandem/io/surface_picture.h"
#include "usage_error.h"
#include "values.h"

namespace cli {
namespace {

constexpr int kLargestPicture = 8192;
constexpr double kFinestChord =
    1e-9;  // shares of the extent: below it vertices count in hundreds of millions
constexpr double kFinestAngle = 1e-3;  // radians
constexpr double kCoarsestAngle = 1.57;

// Said before the work begins.
void need_cad(const std::string& path) {
  if (tandem::has_cad()) return;
  throw tandem::InvalidArgument(fmt::format(
      "{}: this program has no CAD component (libtandem_cad.so), which reads and writes STEP, IGES and BREP",
      path));
}

tandem::TriangleMesh mesh_of(const SurfaceOutput& output, const SurfaceContent& content, bool shaded) {
  if (content.mesh != nullptr) return *content.mesh;
  tandem::TessellateOptions options = output.mesh;
  options.joints = shaded ? tandem::Joints::split : tandem::Joints::welded;
  tandem::TriangleMesh mesh = tandem::tessellate(*content.surface, options);
  if (mesh.triangles.empty()) throw tandem::InvalidArgument("the surface has no area, it makes no triangles");
  return mesh;
}

tandem::Scene scene(const SurfaceOutput& output, const SurfaceContent& content) {
  if (content.mesh != nullptr) return tandem::scene_of(*content.mesh, content.curves);
  return tandem::scene_of(*content.surface, content.curves, output.mesh);
}

std::string format(const SurfaceOutput& output, const SurfaceContent& content) {
  if (const std::optional<tandem::CadFormat> cad = cad_format_of(output.format)) {
    if (content.surface == nullptr) {
      throw tandem::InvalidArgument(
          "a mesh of triangles has no place in STEP, IGES or BREP; there is .stl, .glb");
    }
    return tandem::format_cad(*cad, {}, {content.surface, 1});
  }
  switch (output.format) {
    case Format::obj:
      return tandem::format_obj(mesh_of(output, content, true));
    case Format::stl:
      return tandem::format_stl(mesh_of(output, content, false));
    case Format::ply:
      return tandem::format_ply(mesh_of(output, content, false));
    case Format::glb:
      return tandem::format_glb(mesh_of(output, content, true));
    case Format::svg:
      return tandem::format_scene_svg(scene(output, content), output.size);
    case Format::png:
      return tandem::format_scene_png(scene(output, content), output.size);
    case Format::html:
      return tandem::format_scene_page(scene(output, content), content.title);
    default:
      if (content.surface == nullptr) {
        throw tandem::InvalidArgument(
            "a mesh of triangles has no place in .json; there is .obj, .stl, .ply, .glb");
      }
      return tandem::format_json_surface(*content.surface, content.members);
  }
}

}  // namespace

std::optional<tandem::CadFormat> cad_format_of(Format format) {
  switch (format) {
    case Format::step:
      return tandem::CadFormat::step;
    case Format::iges:
      return tandem::CadFormat::iges;
    case Format::brep:
      return tandem::CadFormat::brep;
    default:
      return std::nullopt;
  }
}

const std::vector<Format>& surface_formats() {
  static const std::vector<Format> all = {Format::json, Format::obj,  Format::stl, Format::ply,
                                          Format::glb,  Format::svg,  Format::png, Format::html,
                                          Format::step, Format::iges, Format::brep};
  return all;
}

void add_surface_flags(CLI::App& app, SurfaceFlags& flags) {
  app.add_option("--chord", flags.chord,
                 "Largest distance of triangles and surface, as a share of its extent (1e-3)")
      ->type_name("X");
  app.add_option("--angle", flags.angle, "Largest angle between triangles and surface, in radians (0.15)")
      ->type_name("X");
  app.add_option("--size", flags.size, "Longer side of .svg and .png, in pixels (1024)")->type_name("N");
}

std::string surface_endings() {
  return ".json, .obj, .stl, .ply, .glb, .svg, .png, .html, .step, .iges, .brep, or - for JSON on standard "
         "output";
}

SurfaceOutput plan_surface_output(const CLI::App& app, const std::string& path, const std::string& to,
                                  const SurfaceFlags& flags) {
  if (path.empty()) throw UsageError(fmt::format("{} needs -o OUT: {}", app.get_name(), surface_endings()));
  SurfaceOutput output;
  output.path = path;
  output.format = output_format(path, to, surface_formats());
  output.mesh.chord = parse_number("--chord", flags.chord, kFinestChord, 1.0);
  output.mesh.angle = parse_number("--angle", flags.angle, kFinestAngle, kCoarsestAngle);
  output.size = parse_count("--size", flags.size, 1, kLargestPicture);
  if (cad_format_of(output.format)) need_cad(path);
  check_writable(path);
  return output;
}

tandem::Certificate certify(const tandem::Surface& surface, const SurfaceOutput& output) {
  if (surface.dim() != 3) return tandem::certify(surface);
  return tandem::certify(surface, tandem::tessellate(surface, output.mesh));
}

void warn(const Messages& messages, const tandem::Certificate& certificate) {
  if (certificate.verdict == tandem::Verdict::certified) return;
  messages.warning(fmt::format("not certified: {}", name(certificate.verdict)));
}

void write_surface(const SurfaceOutput& output, const SurfaceContent& content) {
  write_output(output.path, format(output, content));
}

}  // namespace cli
