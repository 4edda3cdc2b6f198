#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {

/// The times a caller chose (MorphOptions::times), one per key; even ones where there are none.
/// @throws InvalidArgument another number of times, or times that do not rise from 0 to 1
[[nodiscard]] std::vector<double> chosen_times(std::span<const double> times, std::size_t key_count);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
