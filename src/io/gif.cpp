#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

#include "io/ink.h"
#include "io/raster.h"
#include "io/svg_parts.h"
#include "io/timeline.h"
#include "tandem/error.h"
#include "tandem/io/picture.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr double kFramesPerSecond = 25.0;
constexpr int kMostDefaultFrames = 1000;
constexpr double kTicks = 100.0;  // of GIF's clock in a second
constexpr int kLeastDelay = 2;    // viewers take less for a tenth of a second
constexpr double kLongestDelay = 65'535.0;

/// Appends to a string in memory; C code calls it, so that nothing may be thrown.
int append(GifFileType* file, const GifByteType* bytes, int count) {
  try {
    static_cast<std::string*>(file->UserData)
        ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
  } catch (const std::bad_alloc&) {
    return 0;
  }
}

class GifWriter {
 public:
  GifWriter(int width, int height) : width_(width) {
    int error = 0;
    file_ = EGifOpen(&content_, append, &error);
    if (file_ == nullptr) throw IoError(fmt::format("gif: {}", GifErrorString(error)));
    EGifSetGifVersion(file_, true);
    // A colour per coverage, from the ground to the ink, so that smooth edges are exact.
    std::array<GifColorType, 256> colors{};
    const auto mixed = [](int ink, int coverage) {
      return static_cast<GifByteType>((255 * (255 - coverage) + ink * coverage + 127) / 255);
    };
    for (int c = 0; c < 256; ++c) {
      colors[static_cast<std::size_t>(c)] = {mixed(kInkColor[0], c), mixed(kInkColor[1], c),
                                             mixed(kInkColor[2], c)};
    }
    ColorMapObject* const map = GifMakeMapObject(256, colors.data());
    if (map == nullptr) {
      close();
      throw std::bad_alloc();
    }
    const int status = EGifPutScreenDesc(file_, width, height, 8, 0, map);
    GifFreeMapObject(map);
    check(status);
  }
  ~GifWriter() { close(); }
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  void repeat_for_ever() {
    constexpr std::array<GifByteType, 3> kForEver = {1, 0, 0};
    check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
    check(EGifPutExtensionBlock(file_, 3, kForEver.data()));
    check(EGifPutExtensionTrailer(file_));
  }

  /// Writes the part of the picture that is not as in the frame before. delay: hundredths of a second.
  void add(const Raster& raster, int delay) {
    const Rect rect = before_.coverage.empty() ? Rect{0, 0, raster.width, raster.height} : changes(raster);
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay, NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, 4, bytes.data()));
    check(EGifPutImageDesc(file_, rect.left, rect.top, rect.width, rect.height, false, nullptr));
    std::vector<GifPixelType> line(static_cast<std::size_t>(rect.width));
    for (int y = rect.top; y < rect.top + rect.height; ++y) {
      const auto row = raster.coverage.begin() + static_cast<std::ptrdiff_t>(y) * width_ + rect.left;
      std::copy_n(row, rect.width, line.begin());
      check(EGifPutLine(file_, line.data(), rect.width));
    }
    before_ = raster;
  }

  [[nodiscard]] std::string take() {
    close();
    return std::move(content_);
  }

 private:
  struct Rect {
    int left = 0;
    int top = 0;
    int width = 1;
    int height = 1;
  };

  [[nodiscard]] Rect changes(const Raster& raster) const {
    int left = raster.width, right = -1, top = raster.height, bottom = -1;
    for (int y = 0; y < raster.height; ++y) {
      for (int x = 0; x < raster.width; ++x) {
        const auto i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
        if (raster.coverage[i] == before_.coverage[i]) continue;
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = y;
      }
    }
    return right < 0 ? Rect{} : Rect{left, top, right - left + 1, bottom - top + 1};
  }

  void check(int status) {
    if (status == GIF_ERROR) throw IoError(fmt::format("gif: {}", GifErrorString(file_->Error)));
  }

  void close() {
    int error = 0;
    if (file_ != nullptr) EGifCloseFile(file_, &error);
    file_ = nullptr;
  }

  std::string content_;
  GifFileType* file_ = nullptr;
  int width_;
  Raster before_;
};

int count_of(const AnimationOptions& options, int frame_count) {
  if (frame_count == 0) {
    const double frames = std::min(options.duration * kFramesPerSecond, kMostDefaultFrames - 1.0);
    return std::max(1, static_cast<int>(std::lround(frames))) + 1;
  }
  if (frame_count < 2) {
    throw InvalidArgument(fmt::format("gif: {} frames, expected at least 2", frame_count));
  }
  return frame_count;
}

// Of each frame but the last; they add up to the duration.
std::vector<int> delays_of(const AnimationOptions& options, int count) {
  const double each = options.duration * kTicks / (count - 1);
  if (count > 2 && each < kLeastDelay) {
    throw InvalidArgument(fmt::format("gif: {} frames in {} s, expected at most {} a second", count,
                                      options.duration, kTicks / kLeastDelay));
  }
  std::vector<int> delays;
  double ticks = 0.0;
  for (int i = 1; i < count; ++i) {
    const double next = std::round(i * each);
    delays.push_back(static_cast<int>(std::clamp(next - ticks, 1.0 * kLeastDelay, kLongestDelay)));
    ticks = next;
  }
  return delays;
}

}  // namespace

std::string format_gif(const PathMorph& morph, const AnimationOptions& options, int frame_count, int size) {
  check_animation(options);
  const int count = count_of(options, frame_count);
  const std::vector<int> delays = delays_of(options, count);
  const View view = view_of(morph.box());
  const Canvas canvas = canvas_of(view, size);
  const Rasterizer rasterizer(canvas, morph.fill_rule(), stroke_width(view));
  const KeyFrames frames = key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false});
  const std::vector<TimelineStep> steps = forward_timeline(frames, options);
  const auto draw = [&](int i) {
    return rasterizer.draw(morph.at(played_at(frames, steps, i / (count - 1.0))));
  };

  GifWriter writer(canvas.width, canvas.height);
  if (options.repeat) writer.repeat_for_ever();
  for (int i = 0; i + 1 < count; ++i) writer.add(draw(i), delays[static_cast<std::size_t>(i)]);
  writer.add(draw(count - 1), delays.back());
  if (options.alternate) {
    // The first frame is the next run's, unless there is none.
    for (int i = count - 2; i >= (options.repeat ? 1 : 0); --i) {
      writer.add(draw(i), delays[static_cast<std::size_t>(std::max(i - 1, 0))]);
    }
  }
  return writer.take();
}

}  // namespace v0
}  // namespace tandem
