// In-betweens into the caller's memory.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "morph/icons.h"
#include "tandem/error.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Counted for this whole program; two of the four are enough, the arrays' call these. A sanitizer has its
// own, which cannot be replaced by halves: nothing is counted then.
#ifndef __SANITIZE_ADDRESS__
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
// Not inlined: the compiler would take free() for the wrong partner of new.
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
#endif

namespace tandem {
namespace {

PathMorph morph_of(std::size_t a, std::size_t b, BlendKind blend) {
  const std::vector<Shape> keys{to_shape(test::paths_of(test::kIcons[a])),
                                to_shape(test::paths_of(test::kIcons[b]))};
  MorphOptions options;
  options.match.samples = {32, 32};
  options.blend = blend;
  return PathMorph(keys, options);
}

constexpr BlendKind kKinds[] = {BlendKind::affine,     BlendKind::bezier,    BlendKind::hermite,
                                BlendKind::similarity, BlendKind::intrinsic, BlendKind::detour};

TEST(FrameBuffer, HoldsThePointsOfTheInBetween) {
  for (const BlendKind kind : kKinds) {
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{3, 9}, {22, 31}}) {
      const PathMorph morph = morph_of(a, b, kind);
      std::vector<double> buffer(morph.coordinate_count(), std::numeric_limits<double>::quiet_NaN());
      for (const double s : {0.0, 0.3, 0.5, 1.0, 1.2}) {
        morph.at(s, buffer);
        std::vector<double> expected;
        for (const CubicPath& path : morph.at(s)) {
          const auto points = path.control_points().data();
          expected.insert(expected.end(), points.begin(), points.end());
        }
        EXPECT_EQ(buffer, expected) << static_cast<int>(kind) << " at " << s;
      }
    }
  }
}

TEST(FrameBuffer, NeedsNoAllocation) {
  for (const BlendKind kind : kKinds) {
    const PathMorph morph = morph_of(15, 18, kind);
    std::vector<double> buffer(morph.coordinate_count());
    const long before = allocations;
    morph.at(0.4, buffer);
    EXPECT_EQ(allocations, before) << static_cast<int>(kind);
  }
}

TEST(FrameBuffer, RefusesAnotherSize) {
  const PathMorph morph = morph_of(0, 1, BlendKind::affine);
  std::vector<double> buffer(morph.coordinate_count() + 1);
  EXPECT_THROW(morph.at(0.5, buffer), InvalidArgument);
}

}  // namespace
}  // namespace tandem
