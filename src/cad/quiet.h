#pragma once

namespace tandem {
inline namespace v0 {
namespace cad {

/// While it lives, OpenCASCADE writes nothing to standard output, which belongs to the program.
class Quiet {
 public:
  Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet();
};

}  // namespace cad
}  // namespace v0
}  // namespace tandem
