#include "tandem/io/surface_picture.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "surface/solids.h"
#include "tandem/error.h"
#include "tandem/io/surface_page.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  [[nodiscard]] std::array<int, 4> at(double x, double y) const {
    const auto column = static_cast<std::size_t>(x * width);
    const auto row = static_cast<std::size_t>(y * height);
    const std::uint8_t* p = pixels.data() + 4 * (row * static_cast<std::size_t>(width) + column);
    return {p[0], p[1], p[2], p[3]};
  }
  /// Share of the pixels for which `is` holds.
  template <class F>
  [[nodiscard]] double share(F is) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) count += is(&pixels[i]) ? 1 : 0;
    return static_cast<double>(4 * count) / static_cast<double>(pixels.size());
  }
};

Picture read(const std::string& content) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, content.data(), content.size()), 0);
  image.format = PNG_FORMAT_RGBA;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.pixels.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr), 0);
  return picture;
}

bool is_blue(const std::uint8_t* p) {
  return p[3] == 255 && p[2] > p[0] + 20;
}
bool is_warm(const std::uint8_t* p) {
  return p[3] == 255 && p[0] > p[2] + 20;
}
bool is_red(const std::uint8_t* p) {
  return p[3] == 255 && p[0] > 150 && p[1] < 120 && p[2] < 120;
}

Scene bare(Scene scene) {
  scene.iso_lines.clear();
  scene.edges.clear();
  return scene;
}

TEST(SurfacePicture, ASphereIsADisc) {
  const Picture picture = read(format_scene_png(bare(scene_of(testing::sphere())), 200));
  EXPECT_EQ(picture.width, 200);
  EXPECT_EQ(picture.height, 200);
  EXPECT_EQ(picture.at(0.01, 0.01)[3], 0);
  // pi / 4 of the square within the margins.
  const double disc = picture.share([](const std::uint8_t* p) { return p[3] > 127; });
  EXPECT_NEAR(disc, 0.7854 / (1.06 * 1.06), 0.01);
  EXPECT_NEAR(picture.share(is_blue), disc, 0.03);
  // Lit from above to the left.
  const auto brightness = [&](double x, double y) {
    const auto p = picture.at(x, y);
    return p[0] + p[1] + p[2];
  };
  EXPECT_GT(brightness(0.35, 0.3), brightness(0.65, 0.7) + 60);
}

TEST(SurfacePicture, TheFrontIsWhatIsSeenMost) {
  // Turned inside out, a closed surface looks the same.
  const std::string out = format_scene_png(bare(scene_of(testing::torus(0.4))), 120);
  const Picture in = read(format_scene_png(bare(scene_of(transpose(testing::torus(0.4)))), 120));
  EXPECT_EQ(in.share(is_warm), 0.0);
  EXPECT_GT(in.share(is_blue), 0.2);
  EXPECT_EQ(read(out).share(is_warm), 0.0);
}

TEST(SurfacePicture, BackFacesHaveAnotherTone) {
  // A can without lids: its inside is seen over the rim.
  const Surface tube = testing::revolve({{1, -1, 1}, {1, 1, 1}}, 1, {0, 0, 1, 1});
  const Picture picture = read(format_scene_png(bare(scene_of(tube)), 200));
  EXPECT_GT(picture.share(is_blue), 0.3);
  EXPECT_GT(picture.share(is_warm), 0.1);
}

TEST(SurfacePicture, FoldsOfPlanarSurfacesAreRed) {
  const auto planar = [](double x) {
    return Surface({1, 1}, {std::vector<double>{0, 0, 1, 1}, {0, 0, 1, 1}},
                   Points({{0, 0}, {0, 1}, {1, 0}, {x, 1}}));
  };
  EXPECT_EQ(read(format_scene_png(scene_of(planar(1.5)), 100)).share(is_red), 0.0);
  // The second rail runs backwards: a triangle of 4/9 by 0.8 in a picture of 1.8 by 1 and its margins.
  const double fold = 4.0 / 9.0 * 0.8 / 2.0 / ((1.8 + 0.06 * 1.8) * (1.0 + 0.06 * 1.8));
  EXPECT_NEAR(read(format_scene_png(bare(scene_of(planar(-0.8))), 200)).share(is_red), fold, 0.005);
}

TEST(SurfacePicture, PlanarOnesHaveYDown) {
  const Surface roof({1, 1}, {std::vector<double>{0, 0, 1, 1}, {0, 0, 1, 1}},
                     Points({{0, 0}, {0, 1}, {1, 0.9}, {1, 1}}));
  const Picture picture = read(format_scene_png(bare(scene_of(roof)), 100));
  EXPECT_EQ(picture.at(0.1, 0.2)[3], 255);
  EXPECT_EQ(picture.at(0.9, 0.2)[3], 0);
  EXPECT_EQ(picture.at(0.9, 0.95)[3], 255);
}

TEST(SurfacePicture, HiddenLinesAreLeftOut) {
  // A ring round the sphere's waist, just outside: its half behind the sphere is hidden.
  Scene scene = bare(scene_of(testing::sphere()));
  const auto stroke_length = [](const std::string& svg) {
    const std::size_t from = svg.find(R"(class="curve")");
    const std::size_t data = svg.find(" d=\"", from) + 4;
    std::size_t moves = 0;
    for (std::size_t i = data; svg[i] != '"'; ++i) moves += svg[i] == 'M' ? 1 : 0;
    return moves;
  };
  Points ring(3, 361);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double a = static_cast<double>(i) * 3.14159265358979 / 180.0;
    ring[i][0] = 1.05 * std::cos(a);
    ring[i][1] = 1.05 * std::sin(a);
  }
  scene.curves = {ring};
  const std::string svg = format_scene_svg(scene, 400);
  const std::size_t start = svg.find(R"(class="curve")");
  ASSERT_NE(start, std::string::npos);
  EXPECT_GE(stroke_length(svg), 2U) << "interrupted at least once";
  // Above the middle of the picture there is the far half alone.
  const Picture picture = read(format_scene_png(scene, 400));
  const auto is_ink = [](const std::array<int, 4>& p) { return p[3] > 200 && p[0] + p[1] + p[2] < 200; };
  bool above = false;
  bool below = false;
  for (double y = 0.2; y < 0.8; y += 1.0 / 400) {
    if (is_ink(picture.at(0.5, y))) (y < 0.5 ? above : below) = true;
  }
  EXPECT_TRUE(below);
  EXPECT_FALSE(above);
}

TEST(SurfacePicture, SvgHasTheLinesAsPaths) {
  const std::vector<Curve> curves = {iso_curve(testing::torus(0.4), Along::u, 0.0)};
  const std::string svg = format_scene_svg(scene_of(testing::torus(0.4), curves), 300);
  EXPECT_NE(svg.find(R"(<image width="300")"), std::string::npos);
  EXPECT_NE(svg.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(svg.find(R"(<path class="iso")"), std::string::npos);
  EXPECT_NE(svg.find(R"(<path class="curve")"), std::string::npos);
  // Closed both ways: it ends nowhere.
  EXPECT_EQ(svg.find(R"(<path class="edge")"), std::string::npos);
}

TEST(SurfacePicture, MeshesAreDrawnToo) {
  TriangleMesh mesh;
  mesh.vertices = Points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}});
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  const Scene scene = scene_of(mesh);
  ASSERT_EQ(scene.edges.size(), 1U);
  EXPECT_EQ(scene.edges[0].size(), 5U) << "four edges in one line that is closed";
  EXPECT_GT(read(format_scene_png(scene, 100)).share(is_blue), 0.1);
}

TEST(SurfacePicture, SizesAndNothingAtAllAreRefused) {
  const Scene scene = scene_of(testing::sphere());
  EXPECT_THROW(static_cast<void>(format_scene_png(scene, 0)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(format_scene_svg(scene, 9000)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(format_scene_png(Scene{}, 100)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(format_scene_page(Scene{}, "nothing")), InvalidArgument);
  EXPECT_NO_THROW(static_cast<void>(format_scene_png(scene, 1)));
}

TEST(SurfacePage, IsSelfContained) {
  const std::string page = format_scene_page(scene_of(testing::torus(0.4)), "<a> & b");
  EXPECT_NE(page.find("<title>&lt;a&gt; &amp; b</title>"), std::string::npos);
  EXPECT_EQ(page.find("%TITLE%"), std::string::npos);
  for (const char* address : {"http://", "https://", "src=", "@import", "url("}) {
    EXPECT_EQ(page.find(address), std::string::npos) << address;
  }
  EXPECT_NE(page.find("prefers-reduced-motion"), std::string::npos);
  EXPECT_NE(page.find("\"front\":1"), std::string::npos);
  EXPECT_NE(format_scene_page(scene_of(transpose(testing::torus(0.4))), "t").find("\"front\":-1"),
            std::string::npos);
}

}  // namespace
}  // namespace tandem
