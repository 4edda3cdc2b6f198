#include "tandem/io/cad.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

#include "io/cad_component.h"
#include "tandem/error.h"
#include "tandem/version.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr std::array<std::pair<std::string_view, CadFormat>, 5> kEndings = {{{".step", CadFormat::step},
                                                                             {".stp", CadFormat::step},
                                                                             {".iges", CadFormat::iges},
                                                                             {".igs", CadFormat::iges},
                                                                             {".brep", CadFormat::brep}}};

// A function of the component, or nothing.
template <class Function>
Function* find(void* library, const char* name) {
  return library == nullptr ? nullptr : reinterpret_cast<Function*>(dlsym(library, name));
}

/// The component, or why there is none.
struct Loaded {
  const CadComponent* component = nullptr;
  std::string reason;
};

Loaded load_component() {
  // Never closed: OpenCASCADE keeps tables that live as long as the process.
  void* library = dlopen(kCadLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return {nullptr, dlerror()};
  auto* version = find<CadVersionFunction>(library, kCadVersionSymbol);
  auto* component = find<CadComponentFunction>(library, kCadComponentSymbol);
  if (version == nullptr || component == nullptr)
    return {nullptr, fmt::format("{} is none of ours", kCadLibrary)};
  if (version() != kVersion) {
    return {nullptr, fmt::format("{} belongs to tandem {}, this is {}", kCadLibrary, version(), kVersion)};
  }
  return {component(), {}};
}

const Loaded& loaded() {
  static const Loaded once = load_component();
  return once;
}

const CadComponent& component() {
  if (loaded().component != nullptr) return *loaded().component;
  throw InvalidArgument(fmt::format(
      "STEP, IGES and BREP need the CAD component ({}); build with TANDEM_BUILD_CAD=ON and OpenCASCADE",
      loaded().reason));
}

}  // namespace

CadFormat cad_format(std::string_view path) {
  std::string lower(path);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const auto& [ending, format] : kEndings) {
    if (lower.size() > ending.size() &&
        lower.compare(lower.size() - ending.size(), ending.size(), ending) == 0)
      return format;
  }
  throw InvalidArgument(fmt::format("{}: expected the ending .step, .stp, .iges, .igs or .brep", path));
}

bool has_cad() noexcept {
  return loaded().component != nullptr;
}

std::vector<Curve> read_cad_curves(const std::string& path) {
  const CadFormat format = cad_format(path);
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0)
    throw IoError(fmt::format("cannot read {}: there is no such file", path));
  return component().read_curves(path, format);
}

std::string format_cad(CadFormat format, std::span<const Curve> curves, std::span<const Surface> surfaces) {
  return component().format(format, curves, surfaces);
}

}  // namespace v0
}  // namespace tandem
