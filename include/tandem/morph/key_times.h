#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Position of s among n keys: between key `key` and `key + 1`, at `local` (outside [0,1] when
/// extrapolating).
struct KeyPosition {
  std::size_t key = 0;
  double local = 0.0;
};

/// Among keys that stand at even times. @throws InvalidArgument fewer than two keys, s not finite
[[nodiscard]] TANDEM_EXPORT KeyPosition locate_key(double s, std::size_t key_count);

/// Among keys at these times. @throws InvalidArgument as check_key_times(), s not finite
[[nodiscard]] TANDEM_EXPORT KeyPosition locate_key(double s, std::span<const double> times);

/// i / (n - 1), for n >= 2 keys.
[[nodiscard]] TANDEM_EXPORT std::vector<double> even_times(std::size_t key_count);

/// @throws InvalidArgument fewer than two times, or times that do not rise from 0 to 1
TANDEM_EXPORT void check_key_times(std::span<const double> times);

}  // namespace v0
}  // namespace tandem
