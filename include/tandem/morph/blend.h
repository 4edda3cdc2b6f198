#pragma once

namespace tandem {
inline namespace v0 {

/// How the in-betweens of two aligned planar shapes are made (spec B1). All but `bezier` are made in the
/// frame that turns with the shapes.
enum class BlendKind {
  automatic,   ///< what scores best on the in-betweens
  affine,      ///< (1 - s) A + s B ([C] eq. 1)
  bezier,      ///< the same where the shapes lie, whatever the turn ([D] 3.1)
  hermite,     ///< end points linear, tangents by direction and length ([D] 3.2): keeps smooth joints
  similarity,  ///< turn and scale factored out, the rest linear
  intrinsic,   ///< lengths and turning angles of the control polygon (Sederberg et al. 1993): bends limbs
  detour,      ///< affine; what would cross or fold is smoothed and kept apart on the way, as with automatic
};

}  // namespace v0
}  // namespace tandem
