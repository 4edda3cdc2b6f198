#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

#include "interrupt.h"

namespace cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::milliseconds(500);  // docs/interface.md
constexpr auto kRefresh = std::chrono::milliseconds(50);    // 20 pictures a second look smooth
constexpr int kWidth = 40;

std::atomic<bool> drawn{false};
std::mutex drawing;
Clock::time_point last_drawn;

void write_to_terminal(std::string_view text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

void draw(double fraction) {
  const std::unique_lock lock(drawing, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  if (!lock || now - last_drawn < kRefresh) return;
  last_drawn = now;
  const int filled = static_cast<int>(fraction * kWidth);
  drawn = true;
  write_to_terminal(fmt::format("\r[{}{}] {:3} %", std::string(static_cast<std::size_t>(filled), '#'),
                                std::string(static_cast<std::size_t>(kWidth - filled), ' '),
                                static_cast<int>(fraction * 100)));
}

}  // namespace

tandem::Progress show_progress(bool quiet, std::size_t part, std::size_t parts) {
  static const Clock::time_point start = Clock::now();
  const bool visible = !quiet && isatty(STDERR_FILENO) == 1;
  return [=](double fraction) {
    if (visible && Clock::now() - start > kPatience) {
      const double done = static_cast<double>(part) + std::clamp(fraction, 0.0, 1.0);
      draw(done / static_cast<double>(parts));
    }
    return interrupt_signal() == 0;
  };
}

void erase_progress_bar() {
  if (drawn.exchange(false)) write_to_terminal("\r\033[K");
}

}  // namespace cli
