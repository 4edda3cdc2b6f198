#pragma once

#include <cstdint>

#include "match/kernel_target.h"

namespace tandem {

/// Calls body(name) once per instruction set that this machine can run, and for the one that any can, with
/// the kernels confined to it.
template <class Body>
void for_each_instruction_set(const Body& body) {
  const std::int64_t supported = detail::processor_targets();
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    detail::kernel_target().Update(target);
    body(hwy::TargetName(target));
  }
  detail::kernel_target().Update(0);
  body("what runs everywhere");
  detail::kernel_target().Update(supported);
}

}  // namespace tandem
