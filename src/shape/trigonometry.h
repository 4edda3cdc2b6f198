#pragma once

namespace tandem {
inline namespace v0 {

/// An angle by its cosine and sine.
struct CosSin {
  double cosine = 1.0;
  double sine = 0.0;
};

/// Cosine and sine of an angle of any size, the same on every platform (only + - * / and the exact fmod);
/// exact at multiples of 90 degrees, elsewhere within 2e-16. NaN for an angle that is not finite.
[[nodiscard]] CosSin cos_sin_degrees(double degrees);

/// The angle in [0, 360) whose cosine and sine are (re, im) / |(re, im)|, the same on every platform; 0 for
/// (0, 0).
[[nodiscard]] double angle_degrees(double re, double im);

}  // namespace v0
}  // namespace tandem
