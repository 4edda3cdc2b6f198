#pragma once

#include <span>
#include <string>
#include <vector>

#include "tandem/io/cad.h"

namespace tandem {
inline namespace v0 {

/// What libtandem_cad.so gives to tandem::io: the functions of io/cad.h.
struct CadComponent {
  std::vector<Curve> (*read_curves)(const std::string& path, CadFormat format);
  std::string (*format)(CadFormat format, std::span<const Curve> curves, std::span<const Surface> surfaces);
};

/// The symbols of the component: its version, asked for before anything else since the rest is C++ of that
/// very version, and the functions.
inline constexpr const char* kCadLibrary = "libtandem_cad.so";
inline constexpr const char* kCadVersionSymbol = "tandem_cad_version";
inline constexpr const char* kCadComponentSymbol = "tandem_cad_component";
using CadVersionFunction = const char*();
using CadComponentFunction = const CadComponent*();

}  // namespace v0
}  // namespace tandem
