#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "io/painter.h"
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

/// A frame as GIF holds it: colours, and which of them every pixel has.
struct Indexed {
  std::array<GifColorType, 256> colors{};
  int width = 0;
  int height = 0;
  std::vector<GifPixelType> pixels;

  [[nodiscard]] bool same_colors(const Indexed& other) const {
    return std::equal(colors.begin(), colors.end(), other.colors.begin(),
                      [](const GifColorType& a, const GifColorType& b) {
                        return a.Red == b.Red && a.Green == b.Green && a.Blue == b.Blue;
                      });
  }
  [[nodiscard]] std::array<GifByteType, 3> color_at(std::size_t i) const {
    const GifColorType& color = colors[pixels[i]];
    return {color.Red, color.Green, color.Blue};
  }
};

/// One paint has a colour per coverage, so that smooth edges are exact; two have sixteen steps each.
Indexed indexed(const Painting& painting) {
  constexpr double kWhite = 255.0;
  constexpr int kSteps = 16;
  Indexed frame;
  frame.width = painting.area.width;
  frame.height = painting.area.height;
  for (int c = 0; c < 256; ++c) {
    const std::array<double, 4> pixel =
        painting.two_paints() ? pixel_of(painting, c / kSteps / (kSteps - 1.0), c % kSteps / (kSteps - 1.0))
                              : pixel_of(painting, c / kWhite, 0.0);
    const auto on_white = [&](double x) {
      return static_cast<GifByteType>(std::lround(kWhite * (pixel[3] * x + 1.0 - pixel[3])));
    };
    frame.colors[static_cast<std::size_t>(c)] = {on_white(pixel[0]), on_white(pixel[1]), on_white(pixel[2])};
  }
  frame.pixels = painting.area.coverage;
  if (!painting.two_paints()) return frame;
  const auto step = [](int coverage) { return (coverage * (kSteps - 1) + 127) / 255; };
  for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
    frame.pixels[i] =
        static_cast<GifPixelType>(kSteps * step(frame.pixels[i]) + step(painting.line.coverage[i]));
  }
  return frame;
}

struct MapDeleter {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMap = std::unique_ptr<ColorMapObject, MapDeleter>;

class GifWriter {
 public:
  GifWriter(const Indexed& first) : width_(first.width), first_(first) {
    int error = 0;
    file_ = EGifOpen(&content_, append, &error);
    if (file_ == nullptr) throw IoError(fmt::format("gif: {}", GifErrorString(error)));
    EGifSetGifVersion(file_, true);
    try {
      const ColorMap map = map_of(first);
      check(EGifPutScreenDesc(file_, first.width, first.height, 8, 0, map.get()));
    } catch (...) {
      close();
      throw;
    }
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
  void add(Indexed frame, int delay) {
    const Rect rect = before_.pixels.empty() ? Rect{0, 0, frame.width, frame.height} : changes(frame);
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay, NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, 4, bytes.data()));
    const ColorMap map = frame.same_colors(first_) ? nullptr : map_of(frame);
    check(EGifPutImageDesc(file_, rect.left, rect.top, rect.width, rect.height, false, map.get()));
    std::vector<GifPixelType> line(static_cast<std::size_t>(rect.width));
    for (int y = rect.top; y < rect.top + rect.height; ++y) {
      const auto row = frame.pixels.begin() + static_cast<std::ptrdiff_t>(y) * width_ + rect.left;
      std::copy_n(row, rect.width, line.begin());
      check(EGifPutLine(file_, line.data(), rect.width));
    }
    before_ = std::move(frame);
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

  static ColorMap map_of(const Indexed& frame) {
    ColorMap map(GifMakeMapObject(256, frame.colors.data()));
    if (!map) throw std::bad_alloc();
    return map;
  }

  [[nodiscard]] Rect changes(const Indexed& frame) const {
    const bool same_colors = frame.same_colors(before_);
    int left = frame.width, right = -1, top = frame.height, bottom = -1;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const auto i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
        if (same_colors ? frame.pixels[i] == before_.pixels[i] : frame.color_at(i) == before_.color_at(i))
          continue;
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
  Indexed first_;
  Indexed before_;
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

std::string format_gif(const PathMorph& morph, const AnimationOptions& options, int frame_count, int size,
                       const Look& look) {
  check_animation(options);
  const int count = count_of(options, frame_count);
  const std::vector<int> delays = delays_of(options, count);
  const View view = view_of(look, morph.box());
  const Painter painter(morph, look, view, canvas_of(view, size));
  const KeyFrames frames = key_frames(morph, {.tolerance = options.tolerance, .bake_turn = false});
  const std::vector<TimelineStep> steps = forward_timeline(frames, options);
  const auto draw = [&](int i) {
    const double s = played_at(frames, steps, i / (count - 1.0));
    return indexed(painter.draw(s, morph.at(s)));
  };

  Indexed first = draw(0);
  GifWriter writer(first);
  if (options.repeat) writer.repeat_for_ever();
  writer.add(std::move(first), delays.front());
  for (int i = 1; i + 1 < count; ++i) writer.add(draw(i), delays[static_cast<std::size_t>(i)]);
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
