#include "tandem/io/picture.h"

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "io/raster.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"

namespace tandem {
namespace {

// A view of 10 x 10 units, ten pixels each.
constexpr View kView{0, 0, 10, 10};

Raster drawn(const std::string& d, FillRule rule = FillRule::nonzero, double line_width = 0.5) {
  return Rasterizer(canvas_of(kView, 100), rule, line_width).draw(parse_path_data(d, "d", false));
}

/// In square units.
double area(const Raster& raster) {
  double sum = 0.0;
  for (const std::uint8_t c : raster.coverage) sum += c / 255.0;
  return sum / 100.0;
}

std::uint8_t at(const Raster& raster, int x, int y) {
  return raster.coverage[static_cast<std::size_t>(y * raster.width + x)];
}

TEST(Raster, CoversWhatIsInside) {
  const Raster raster = drawn("M1 2H4V8H1Z");
  EXPECT_NEAR(area(raster), 18.0, 1e-9);
  EXPECT_EQ(at(raster, 10, 20), 255);
  EXPECT_EQ(at(raster, 39, 79), 255);
  EXPECT_EQ(at(raster, 9, 20), 0);
  EXPECT_EQ(at(raster, 10, 19), 0);
  EXPECT_EQ(at(raster, 40, 79), 0);
}

TEST(Raster, CoversPartsOfPixelsByTheirShare) {
  EXPECT_NEAR(at(drawn("M1.025 2H4V8H1.025Z"), 10, 50), 0.75 * 255, 1);
  const double k = 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0) * 4.0;
  const std::string n = std::to_string(5 - k), p = std::to_string(5 + k);
  const std::string disc = "M5 1C" + p + " 1 9 " + n + " 9 5C9 " + p + " " + p + " 9 5 9C" + n + " 9 1 " + p +
                           " 1 5C1 " + n + " " + n + " 1 5 1Z";
  EXPECT_NEAR(area(drawn(disc)), 16.0 * std::numbers::pi, 0.1);  // curves within 0.04 pixels
}

TEST(Raster, FillsByTheRule) {
  const std::string same = "M1 1H9V9H1ZM3 3H7V7H3Z";
  const std::string other = "M1 1H9V9H1ZM3 3V7H7V3Z";
  EXPECT_NEAR(area(drawn(same)), 64.0, 1e-9);
  EXPECT_NEAR(area(drawn(same, FillRule::evenodd)), 48.0, 1e-9);
  EXPECT_NEAR(area(drawn(other)), 48.0, 1e-9);
  EXPECT_NEAR(area(drawn(other, FillRule::evenodd)), 48.0, 1e-9);
}

TEST(Raster, StrokesOpenLines) {
  EXPECT_NEAR(area(drawn("M1 5H9")), 4.0, 0.02);
  // A round joint adds a quarter disc of half the width outside of the two rectangles' union.
  const double corner = 0.25 * 0.25 * (std::numbers::pi / 4.0 + 3.0);
  EXPECT_NEAR(area(drawn("M1 1H6V6")), 2 * 0.5 * 4.75 + corner, 0.02);
  // Lines add up to no more than full coverage, over shapes as well.
  EXPECT_NEAR(area(drawn("M1 5H9M1 5H9", FillRule::nonzero, 0.4)), 3.2, 0.02);
  EXPECT_NEAR(area(drawn("M1 5H9M2 1V9M9 5H1", FillRule::nonzero, 0.4)), 6.4 - 0.16, 0.02);
  EXPECT_NEAR(area(drawn("M1 1H9V9H1ZM2 5H8")), 64.0, 1e-9);
  // More of them than are stroked at once.
  std::string many;
  for (int i = 0; i < 3000; ++i) many += "M1 5H9";
  EXPECT_NEAR(area(drawn(many + "M5 6V8", FillRule::nonzero, 0.4)), 4.0, 0.02);
  // What has shrunk to a point draws nothing.
  EXPECT_EQ(area(drawn("M5 5L5 5.000001")), 0.0);
}

TEST(Raster, CutsOffWhatIsOutside) {
  EXPECT_NEAR(area(drawn("M5 -1e9H1e9V1e9H5Z")), 50.0, 1e-9);
  EXPECT_EQ(area(drawn("M20 20H30V30H20Z")), 0.0);
}

TEST(Raster, RejectsWhatFreeTypeCannotHold) {
  std::string d = "M0 0";
  for (int i = 0; i < 11'000; ++i) d += "L" + std::to_string(i % 10) + " " + std::to_string(i % 7);
  EXPECT_THROW((void)drawn(d + "Z"), InvalidArgument);
}

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

Picture read_png(const std::string& content) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, content.data(), content.size()), 0) << image.message;
  image.format = PNG_FORMAT_RGBA;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr), 0) << image.message;
  return picture;
}

TEST(Png, HoldsCoverageAsOpacity) {
  const PathMorph morph = test::box_to_disc();
  const Picture picture = read_png(format_png(morph, 0.5, 110));
  ASSERT_EQ(picture.width, 110);
  ASSERT_EQ(picture.height, 110);
  const View view = view_of(morph.box());
  const Raster raster =
      Rasterizer(canvas_of(view, 110), FillRule::nonzero, stroke_width(view)).draw(morph.at(0.5));
  for (std::size_t i = 0; i < raster.coverage.size(); ++i) {
    ASSERT_EQ(picture.rgba[4 * i + 3], raster.coverage[i]);
    if (raster.coverage[i] > 0) {
      ASSERT_EQ(picture.rgba[4 * i], 0x1f);
    }
  }
  EXPECT_GT(area(raster), 10.0);
}

TEST(Png, GrowsBeyondTheKeys) {
  const PathMorph morph = test::morph_of({"M0 0H10V10H0Z", "M0 0H20V10H0Z"});
  const Picture within = read_png(format_png(morph, 1.0, 100));
  const Picture beyond = read_png(format_png(morph, 3.0, 100));
  EXPECT_EQ(within.height, 55);
  EXPECT_LT(beyond.height, 40);
  EXPECT_THROW((void)format_png(morph, 0.0, 0), InvalidArgument);
  EXPECT_THROW((void)format_png(morph, 0.0, 9000), InvalidArgument);
}

struct Film {
  int width = 0;
  int height = 0;
  bool loops = false;
  std::vector<int> delays;
  std::vector<std::vector<std::uint8_t>> frames;  ///< put together, red of every pixel
};

Film read_gif(const std::string& content) {
  struct Source {
    const std::string* text;
    std::size_t at = 0;
  } source{&content};
  const auto read = [](GifFileType* file, GifByteType* bytes, int count) {
    auto& from = *static_cast<Source*>(file->UserData);
    const std::size_t n = std::min(static_cast<std::size_t>(count), from.text->size() - from.at);
    std::memcpy(bytes, from.text->data() + from.at, n);
    from.at += n;
    return static_cast<int>(n);
  };
  int error = 0;
  GifFileType* const file = DGifOpen(&source, read, &error);
  Film film;
  if (file == nullptr || DGifSlurp(file) == GIF_ERROR) {
    ADD_FAILURE() << "no GIF: " << error;
    return film;
  }
  film.width = file->SWidth;
  film.height = file->SHeight;
  film.loops = content.find("NETSCAPE2.0") != std::string::npos;
  std::vector<std::uint8_t> canvas(static_cast<std::size_t>(film.width * film.height));
  for (int i = 0; i < file->ImageCount; ++i) {
    GraphicsControlBlock control;
    EXPECT_EQ(DGifSavedExtensionToGCB(file, i, &control), GIF_OK);
    film.delays.push_back(control.DelayTime);
    const SavedImage& image = file->SavedImages[i];
    const GifImageDesc& part = image.ImageDesc;
    for (int y = 0; y < part.Height; ++y) {
      for (int x = 0; x < part.Width; ++x) {
        canvas[static_cast<std::size_t>((part.Top + y) * film.width + part.Left + x)] =
            file->SColorMap->Colors[image.RasterBits[y * part.Width + x]].Red;
      }
    }
    film.frames.push_back(canvas);
  }
  DGifCloseFile(file, &error);
  return film;
}

int sum(const std::vector<int>& numbers) {
  int total = 0;
  for (const int n : numbers) total += n;
  return total;
}

TEST(Gif, HoldsEveryFrameExactly) {
  const PathMorph morph = test::mixed();
  const Film film = read_gif(format_gif(morph, {.duration = 0.4, .alternate = false}, 0, 90));
  ASSERT_EQ(film.frames.size(), 11u);  // 25 a second, both ends
  EXPECT_TRUE(film.loops);
  const View view = view_of(morph.box());
  const Canvas canvas = canvas_of(view, 90);
  EXPECT_EQ(film.width, canvas.width);
  EXPECT_EQ(film.height, canvas.height);
  const Rasterizer rasterizer(canvas, FillRule::nonzero, stroke_width(view));
  for (std::size_t i = 0; i < film.frames.size(); ++i) {
    const Raster raster = rasterizer.draw(morph.at(static_cast<double>(i) / 10.0));
    for (std::size_t k = 0; k < raster.coverage.size(); ++k) {
      const double wanted = 255.0 + (0x1f - 255.0) * raster.coverage[k] / 255.0;
      ASSERT_NEAR(film.frames[i][k], wanted, 0.51) << "frame " << i << ", pixel " << k;
    }
  }
}

TEST(Gif, TakesAsLongAsAsked) {
  const PathMorph morph = test::box_to_disc();
  const Film film = read_gif(format_gif(morph, {.duration = 1.0}, 8, 40));
  ASSERT_EQ(film.frames.size(), 14u);  // there and back, the ends once
  EXPECT_EQ(sum(film.delays), 200);
  for (const int delay : film.delays) EXPECT_TRUE(delay == 14 || delay == 15);
  const Film once = read_gif(format_gif(morph, {.duration = 1.0, .repeat = false}, 8, 40));
  EXPECT_FALSE(once.loops);
  ASSERT_EQ(once.frames.size(), 15u);
  EXPECT_EQ(once.frames.front(), once.frames.back());
  EXPECT_NE(once.frames.front(), once.frames[7]);
}

TEST(Gif, EasesFromKeyToKey) {
  const PathMorph morph = test::box_to_disc();
  const Film film =
      read_gif(format_gif(morph, {.duration = 1.0, .easing = "ease-in-out", .alternate = false}, 5, 40));
  const Film linear = read_gif(format_gif(morph, {.duration = 1.0, .alternate = false}, 5, 40));
  ASSERT_EQ(film.frames.size(), 5u);
  EXPECT_EQ(film.frames[2], linear.frames[2]);
  EXPECT_NE(film.frames[1], linear.frames[1]);
}

TEST(Gif, RejectsNonsense) {
  const PathMorph morph = test::box_to_disc();
  EXPECT_THROW((void)format_gif(morph, {.duration = 0.0}), InvalidArgument);
  EXPECT_THROW((void)format_gif(morph, {.duration = 1.0}, 60), InvalidArgument);
  EXPECT_THROW((void)format_gif(morph, {}, 1), InvalidArgument);
  EXPECT_THROW((void)format_gif(morph, {}, 0, 0), InvalidArgument);
}

}  // namespace
}  // namespace tandem
