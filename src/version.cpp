#include "tandem/version.h"

namespace tandem {
inline namespace v0 {

std::string_view version() {
  return kVersion;
}

}  // namespace v0
}  // namespace tandem
