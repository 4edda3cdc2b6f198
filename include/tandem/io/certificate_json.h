#pragma once

#include <string>
#include <string_view>

#include "tandem/surface/certificate.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// "certified", "violated", "undecided".
[[nodiscard]] TANDEM_IO_EXPORT std::string_view name(Verdict verdict) noexcept;

/// A certificate as members of a JSON object, one a line, without braces: `"certificate": "violated"`, the
/// verdicts behind it, and the witness as docs/interface.md has it.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_json_certificate(const Certificate& certificate);

}  // namespace v0
}  // namespace tandem
