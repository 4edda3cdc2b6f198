#include "match/kernel_target.h"

#include <hwy/highway.h>

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

#if HWY_ARCH_X86

// What __builtin_cpu_supports() of clang 14 has no names for; the bits are those of the processors' manuals.
struct NamelessFeatures {
  bool f16c = false;
  bool lzcnt = false;
  bool vaes = false;

  NamelessFeatures() {
    unsigned a = 0;
    unsigned b = 0;
    unsigned c = 0;
    unsigned d = 0;
    if (__get_cpuid(1, &a, &b, &c, &d) != 0) f16c = (c >> 29U & 1U) != 0;
    if (__get_cpuid(0x80000001, &a, &b, &c, &d) != 0) lzcnt = (c >> 5U & 1U) != 0;
    if (__get_cpuid_count(7, 0, &a, &b, &c, &d) != 0) vaes = (c >> 9U & 1U) != 0;
  }
};

// What Highway lets the compiler use in each of them (hwy/set_macros-inl.h), each with all of the one before;
// of avx and avx512 the builtin also asks whether the system saves their registers.
std::int64_t find_targets() {
  const NamelessFeatures nameless;
  std::int64_t targets = 0;
  if (!__builtin_cpu_supports("ssse3")) return targets;
  targets |= HWY_SSSE3;
  if (!__builtin_cpu_supports("sse4.1") || !__builtin_cpu_supports("sse4.2") ||
      !__builtin_cpu_supports("pclmul") || !__builtin_cpu_supports("aes")) {
    return targets;
  }
  targets |= HWY_SSE4;
  if (!__builtin_cpu_supports("avx") || !__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") ||
      !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2") || !nameless.f16c ||
      !nameless.lzcnt) {
    return targets;
  }
  targets |= HWY_AVX2;
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
      !__builtin_cpu_supports("avx512dq") || !__builtin_cpu_supports("avx512bw") ||
      !__builtin_cpu_supports("avx512cd")) {
    return targets;
  }
  targets |= HWY_AVX3;
  if (__builtin_cpu_supports("avx512vnni") && __builtin_cpu_supports("vpclmulqdq") &&
      __builtin_cpu_supports("avx512vbmi") && __builtin_cpu_supports("avx512vbmi2") &&
      __builtin_cpu_supports("avx512vpopcntdq") && __builtin_cpu_supports("avx512bitalg") &&
      __builtin_cpu_supports("gfni") && nameless.vaes) {
    targets |= HWY_AVX3_DL;
  }
  return targets;
}

#else

// Highway picks at run time on x86 only; elsewhere the compiler's own target is the one there is.
std::int64_t find_targets() {
  return 0;
}

#endif

}  // namespace

std::int64_t processor_targets() noexcept {
  static const std::int64_t targets = find_targets();
  return targets;
}

hwy::ChosenTarget& kernel_target() noexcept {
  struct Best : hwy::ChosenTarget {
    Best() { Update(processor_targets()); }
  };
  static Best best;
  return best;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
