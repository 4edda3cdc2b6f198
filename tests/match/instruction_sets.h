#pragma once

#include <hwy/targets.h>

#include <cstdint>

namespace tandem {

/// Calls body(name) once per instruction set that this machine can run, with the kernels confined to it.
template <class Body>
void for_each_instruction_set(const Body& body) {
  const auto confine = [](std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  confine(0);  // no restriction
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    confine(target);
    body(hwy::TargetName(target));
  }
  confine(0);
}

}  // namespace tandem
