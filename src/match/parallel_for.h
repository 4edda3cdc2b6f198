#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace tandem {
inline namespace v0 {
namespace detail {

/// Calls body(0) .. body(count - 1), on up to `threads` threads (0: all). The calls must not depend on one
/// another.
template <class Body>
void parallel_for(int count, int threads, const Body& body) {
  if (count <= 1 || threads == 1) {
    for (int k = 0; k < count; ++k) body(k);
    return;
  }
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(0, count, [&](int k) { body(k); }); });
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
