#include <gtest/gtest.h>
#include <rlottie.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "io/painter.h"
#include "io/raster.h"
#include "io/timeline.h"
#include "tandem/io/load.h"
#include "tandem/io/lottie.h"
#include "tandem/io/svg.h"

/// What rlottie draws of our Lottie files, frame by frame, against our own pictures of the same moments.
namespace tandem {
namespace {

constexpr int kSize = 160;
// Mean difference of coverage, a share of 1, of pictures that show the same: rasterisers disagree on edges.
constexpr double kAlike = 0.004;

struct Played {
  int width = 0;
  int height = 0;
  std::vector<std::vector<std::uint32_t>> frames;
};

Played play(const std::string& json) {
  static int key = 0;  // rlottie keeps what it has loaded under it
  const auto animation = rlottie::Animation::loadFromData(json, std::to_string(key++), "", false);
  Played played;
  if (animation == nullptr) return played;
  std::size_t width = 0;
  std::size_t height = 0;
  animation->size(width, height);
  played.width = static_cast<int>(width);
  played.height = static_cast<int>(height);
  for (std::size_t i = 0; i < animation->totalFrame(); ++i) {
    std::vector<std::uint32_t> pixels(width * height);
    animation->renderSync(i, rlottie::Surface(pixels.data(), width, height, width * sizeof(std::uint32_t)));
    played.frames.push_back(std::move(pixels));
  }
  return played;
}

double difference(const std::vector<std::uint32_t>& pixels, const Raster& raster) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    sum += std::abs(static_cast<int>(pixels[i] >> 24) - static_cast<int>(raster.coverage[i])) / 255.0;
  }
  return sum / static_cast<double>(pixels.size());
}

void expect_the_same(const std::vector<std::string>& names, const AnimationOptions& options,
                     FillRule fill_rule = FillRule::nonzero, const MorphOptions& keys_at = {}) {
  std::vector<Shape> keys;
  for (const std::string& name : names) keys.push_back(load_shape(name, {.fill_rule = fill_rule}));
  const PathMorph morph = test::path_morph(keys, keys_at);
  const Played played = play(format_lottie(morph, names.front(), options, kSize));
  const View view = view_of(morph.box());
  const Canvas canvas = canvas_of(view, kSize);
  ASSERT_EQ(played.width, canvas.width);
  ASSERT_EQ(played.height, canvas.height);
  const auto count = static_cast<std::size_t>(loop_seconds(options) * 60);
  ASSERT_EQ(played.frames.size(), count);
  const Rasterizer rasterizer(canvas, morph.fill_rule(), stroke_width(view));
  const KeyFrames frames = key_frames(morph);
  const std::vector<TimelineStep> steps = loop_timeline(frames, options);
  const Raster first = rasterizer.draw(morph.at(0.0));
  double farthest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double s = played_at(frames, steps, static_cast<double>(i) / static_cast<double>(count));
    EXPECT_LE(difference(played.frames[i], rasterizer.draw(morph.at(s))), kAlike) << "frame " << i;
    farthest = std::max(farthest, difference(played.frames[i], first));
  }
  EXPECT_GT(farthest, 3 * kAlike);  // it moves, and the comparison notices
}

/// Largest of the mean differences of red, green, blue and opacity.
double difference(const std::vector<std::uint32_t>& pixels, const Painting& painting) {
  std::array<double, 4> sums{};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double line = painting.two_paints() ? painting.line.coverage[i] / 255.0 : 0.0;
    const std::array<double, 4> pixel = pixel_of(painting, painting.area.coverage[i] / 255.0, line);
    for (std::size_t k = 0; k < 4; ++k) {
      const double wanted = k < 3 ? pixel[k] * pixel[3] : pixel[3];  // rlottie's are premultiplied
      const unsigned shift = k < 3 ? 16U - 8U * static_cast<unsigned>(k) : 24U;
      sums[k] += std::fabs(((pixels[i] >> shift) & 0xFFU) / 255.0 - wanted);
    }
  }
  return *std::max_element(sums.begin(), sums.end()) / static_cast<double>(pixels.size());
}

void expect_the_look(const std::vector<Drawing>& drawings, const AnimationOptions& options) {
  std::vector<Shape> keys;
  for (const Drawing& drawing : drawings) keys.push_back(drawing.shape);
  const Look look = look_of(drawings);
  const PathMorph morph = test::path_morph(keys);
  const Played played = play(format_lottie(morph, "look", options, kSize, look));
  const View view = view_of(look, morph.box());
  const Canvas canvas = canvas_of(view, kSize);
  ASSERT_EQ(played.width, canvas.width);
  const Painter painter(morph, look, view, canvas);
  const KeyFrames frames = key_frames(morph);
  const std::vector<TimelineStep> steps = loop_timeline(frames, options);
  const Painting first = painter.draw(0.0, morph.at(0.0));
  const std::size_t count = played.frames.size();
  ASSERT_EQ(count, static_cast<std::size_t>(loop_seconds(options) * 60));
  double farthest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double s = played_at(frames, steps, static_cast<double>(i) / static_cast<double>(count));
    EXPECT_LE(difference(played.frames[i], painter.draw(s, morph.at(s))), kAlike) << "frame " << i;
    farthest = std::max(farthest, difference(played.frames[i], first));
  }
  EXPECT_GT(farthest, 3 * kAlike);
}

Drawing drawing(const std::string& attributes, const std::string& d) {
  const std::string path = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 24 24\"><path " +
                           attributes + " d=\"" + d + "\"/></svg>";
  const SvgElement element = parse_svg(path).front();
  return {element.shape, element.style, ViewBox{0, 0, 24, 24}, false};
}

const std::string kOutline =
    "fill='none' stroke='currentColor' stroke-width='2' stroke-linecap='round' stroke-linejoin='round'";

TEST(Rlottie, KeepsOutlines) {
  expect_the_look({drawing(kOutline, "M4 6H20M4 12H20"), drawing(kOutline, "M6 6L18 18M6 18L18 6")},
                  {.duration = 0.5});
  expect_the_look({drawing(kOutline, "M4 6H20V12H9Z"), drawing(kOutline, "M6 6L18 18L9 20Z")},
                  {.duration = 0.5});
}

TEST(Rlottie, MixesColors) {
  expect_the_look(
      {drawing("fill='#dd2e44'", "M4 4H20V20H4Z"), drawing("fill='rgb(59 136 195 / 60%)'", "M12 3L22 20H2Z")},
      {.duration = 0.5, .easing = "ease-in-out"});
}

TEST(Rlottie, FadesFillsAndWidensLines) {
  expect_the_look({drawing(kOutline, "M4 4H20V20H4Z"),
                   drawing("fill='gold' stroke='#226699' stroke-width='3'", "M5 6H19L12 21Z"),
                   drawing("fill='#dd2e44'", "M12 3L22 20H2Z")},
                  {.duration = 0.5});
}

std::string icon(const char* name) {
  return std::string(TANDEM_TEST_DATA) + "/icons/" + name + ".svg";
}

TEST(Rlottie, ShowsIcons) {
  expect_the_same({icon("heart"), icon("star")}, {.duration = 0.5});
}

TEST(Rlottie, ShowsHolesAndEasing) {
  expect_the_same({icon("cat"), icon("bird")}, {.duration = 0.5, .easing = "ease-in-out"});
}

TEST(Rlottie, ShowsTurnsOverSeveralKeys) {
  expect_the_same({"M0 0H9V2H3V5H0Z", "M0 0V9H-2V3H-5V0Z", "M0 0H9V9H0Z"},
                  {.duration = 0.5, .easing = "ease"});
}

TEST(Rlottie, ShowsTimesAndEasingsOfSteps) {
  expect_the_same({icon("heart"), icon("star"), icon("heart")}, {.duration = 0.5, .easing = "ease-in;linear"},
                  FillRule::nonzero, {.times = {0, 0.3, 1}});
}

TEST(Rlottie, ShowsSmoothKeys) {
  expect_the_same({"M0 0H9V2H3V5H0Z", "M0 0V9H-2V3H-5V0Z", "M0 0H9V9H0Z"},
                  {.duration = 0.5, .easing = "ease-in-out"}, FillRule::nonzero,
                  {.times = {0, 0.4, 1}, .smooth = true});
}

TEST(Rlottie, ShowsOpenLines) {
  expect_the_same({"M0 0C1 5 5 5 9 0M1 9L5 9", "M0 0C5 -5 5 5 9 9M0 9L5 9L6 6"},
                  {.duration = 0.5, .alternate = false});
}

TEST(Rlottie, ShowsEvenOddHoles) {
  expect_the_same({"M0 0H9V9H0ZM3 3H6V6H3Z", "M0 0H9V9H0ZM2 1H8V8H2Z"}, {.duration = 0.5}, FillRule::evenodd);
}

TEST(Rlottie, ShowsLoopsOfOneSegment) {
  expect_the_same({"M0 0C9 9 -9 9 0 0Z", "M0 0C9 -9 9 9 0 0Z"}, {.duration = 0.5});
}

}  // namespace
}  // namespace tandem
