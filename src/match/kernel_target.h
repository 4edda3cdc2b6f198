#pragma once

/// Run-time dispatch of Highway's kernels without its shared library, which calibrates a clock for 5 ms
/// whenever a program starts that is linked with it. Include it behind <hwy/highway.h>, in the part under
/// HWY_ONCE.

#include <hwy/targets.h>

#include <cstdint>

namespace tandem {
inline namespace v0 {
namespace detail {

/// The instruction sets that Highway knows and this processor has, as HWY_* bits.
[[nodiscard]] std::int64_t processor_targets() noexcept;

/// Which one runs the kernels: the best at first. Tests narrow it down by Update().
[[nodiscard]] hwy::ChosenTarget& kernel_target() noexcept;

}  // namespace detail
}  // namespace v0
}  // namespace tandem

// TANDEM_KERNEL(f) at namespace scope, then TANDEM_DISPATCH(f)(arguments), as with HWY_EXPORT and
// HWY_DYNAMIC_DISPATCH.
#define TANDEM_KERNEL_TABLE(FUNCTION) HWY_CONCAT(FUNCTION, KernelTable)
#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
#define TANDEM_KERNEL(FUNCTION)                                                      \
  constexpr decltype(&HWY_STATIC_DISPATCH(FUNCTION)) TANDEM_KERNEL_TABLE(FUNCTION) = \
      &HWY_STATIC_DISPATCH(FUNCTION)
#define TANDEM_DISPATCH(FUNCTION) TANDEM_KERNEL_TABLE(FUNCTION)
#else
// ChosenTarget counts from 1, and behind Highway's list stands what runs everywhere.
#define TANDEM_KERNEL(FUNCTION)                                                          \
  constexpr decltype(&HWY_STATIC_DISPATCH(FUNCTION)) TANDEM_KERNEL_TABLE(FUNCTION)[] = { \
      nullptr, HWY_CHOOSE_TARGET_LIST(FUNCTION), HWY_CHOOSE_FALLBACK(FUNCTION)}
#define TANDEM_DISPATCH(FUNCTION) (*TANDEM_KERNEL_TABLE(FUNCTION)[detail::kernel_target().GetIndex()])
#endif
