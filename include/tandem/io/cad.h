#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_io_export.h"

/// STEP, IGES and BREP, by way of OpenCASCADE: the optional component libtandem_cad.so, which is loaded when
/// it is first needed. Lengths are millimetres in all of them.
namespace tandem {
inline namespace v0 {

enum class CadFormat { step, iges, brep };

/// By the ending of the name: .step, .stp, .iges, .igs, .brep, without regard to case.
/// @throws InvalidArgument another ending
[[nodiscard]] TANDEM_IO_EXPORT CadFormat cad_format(std::string_view path);

/// Whether the component is there.
[[nodiscard]] TANDEM_IO_EXPORT bool has_cad() noexcept;

/// The wires and edges of a file as curves in R^3, exact: lines and polynomials as B-splines, conics as
/// rational ones, others (offset curves) within 1e-7.
///
/// An edge is a curve over its own domain; a wire is one curve whose edges follow each other, each over a
/// part of [0, length] as long as the edge is. Edges of one item that meet end to end, two at each point,
/// count as a wire, since STEP and IGES know no other. When there are faces, their edges count only if there
/// is nothing else.
/// @throws IoError no such file; InvalidArgument no component; ParseError not a file of its format, or no
/// edge in it
[[nodiscard]] TANDEM_IO_EXPORT std::vector<Curve> read_cad_curves(const std::string& path);

/// Curves as edges (or wires, where a degree is too high for one edge), surfaces as faces, of dimension 2 (z
/// = 0) or 3; each an item of its own. STEP is AP214.
/// @throws InvalidArgument no component, nothing to write, another dimension, or a degree above 25,
/// the highest that OpenCASCADE knows
[[nodiscard]] TANDEM_IO_EXPORT std::string format_cad(CadFormat format, std::span<const Curve> curves,
                                                      std::span<const Surface> surfaces = {});

}  // namespace v0
}  // namespace tandem
