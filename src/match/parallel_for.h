#pragma once

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

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
  const int most = tbb::info::default_concurrency();
  tbb::task_arena arena(threads > 0 ? std::min(threads, most) : most);
  arena.execute([&] { tbb::parallel_for(0, count, [&](int k) { body(k); }); });
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
