#pragma once

#include <functional>

namespace tandem {
inline namespace v0 {

/// Called now and then by long work with the fraction done, in [0,1]; return false to cancel.
/// An empty function means: never asked, never cancelled.
using Progress = std::function<bool(double fraction)>;

}  // namespace v0
}  // namespace tandem
