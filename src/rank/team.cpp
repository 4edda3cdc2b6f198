#include "tandem/rank/team.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

/// The first word of a message.
enum Kind : std::uint64_t {
  kHello,   ///< to rank 0: the digest of what this process has read
  kAsk,     ///< to rank 0: another tile, please
  kCosts,   ///< to rank 0: a tile and its costs
  kBye,     ///< to rank 0: no message follows
  kTile,    ///< from rank 0: the tile asked for
  kNoTile,  ///< from rank 0: there is no more
};

/// Between two looks for a message. Short against a tile (0.05 s and more), long against a look.
constexpr auto kNap = std::chrono::microseconds(500);

std::uint64_t to_word(double number) {
  std::uint64_t word = 0;
  std::memcpy(&word, &number, sizeof word);
  return word;
}

double to_number(std::uint64_t word) {
  double number = 0.0;
  std::memcpy(&number, &word, sizeof number);
  return number;
}

/// The leader's side of the conversation.
class Desk {
 public:
  Desk(const Team& team, std::uint64_t digest, const PairTiles& tiles, const TileSource& source,
       const TileSink& sink)
      : team_(team), digest_(digest), tiles_(tiles), source_(source), sink_(sink), present_(team.size - 1) {}

  [[nodiscard]] bool is_empty() const { return present_ == 0; }

  void answer(const TeamMessage& message) {
    switch (at(message, 0)) {
      case kHello:
        if (at(message, 1) != digest_) {
          throw InvalidArgument(fmt::format(
              "process {} has read other shapes than process 0: all must see the same files", message.from));
        }
        return;
      case kAsk:
        return reply(message.from);
      case kCosts:
        return take(message);
      case kBye:
        --present_;
        return;
      default:
        throw broken(message);
    }
  }

 private:
  static InvalidArgument broken(const TeamMessage& message) {
    return InvalidArgument(fmt::format("process {} sent a message that makes no sense", message.from));
  }

  [[nodiscard]] static std::uint64_t at(const TeamMessage& message, std::size_t word) {
    if (word >= message.words.size()) throw broken(message);
    return message.words[word];
  }

  void reply(int to) {
    const std::optional<std::size_t> tile = source_();
    const std::uint64_t words[] = {tile ? kTile : kNoTile, tile.value_or(0)};
    team_.send(to, words);
  }

  void take(const TeamMessage& message) {
    const std::uint64_t tile = at(message, 1);
    if (tile >= tiles_.size() || message.words.size() != 2 + tiles_.tile(tile).pairs()) throw broken(message);
    std::vector<double> costs;
    costs.reserve(message.words.size() - 2);
    for (std::size_t k = 2; k < message.words.size(); ++k) costs.push_back(to_number(message.words[k]));
    sink_(tile, costs);
  }

  const Team& team_;
  std::uint64_t digest_;
  const PairTiles& tiles_;
  const TileSource& source_;
  const TileSink& sink_;
  int present_;
};

/// all_pairs() on threads of its own, which are stopped and waited for at the end at the latest.
class OwnShare {
 public:
  OwnShare(std::span<const ShapeDescriptor> shapes, const TileSource& source, const TileSink& sink,
           const AllPairsOptions& options)
      : thread_([this, shapes, &source, &sink, own = options]() mutable {
          own.progress = [this](double) { return !stopped_; };
          try {
            (void)all_pairs(shapes, source, sink, own);
          } catch (...) {
            failure_ = std::current_exception();
          }
          done_ = true;
        }) {}
  OwnShare(const OwnShare&) = delete;
  OwnShare& operator=(const OwnShare&) = delete;
  ~OwnShare() {
    stop();
    if (thread_.joinable()) thread_.join();
  }

  void stop() { stopped_ = true; }
  [[nodiscard]] bool is_done() const { return done_; }
  /// @throws what went wrong in it
  void rethrow_failure() const {
    if (done_ && failure_) std::rethrow_exception(failure_);
  }

 private:
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> done_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  // last: it uses the others
};

}  // namespace

bool lead_all_pairs(const Team& team, std::span<const ShapeDescriptor> shapes, const TileSource& source,
                    const TileSink& sink, const AllPairsOptions& options) {
  const PairTiles tiles(shapes.size());
  std::mutex mutex;  // source and sink: our threads and the desk
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> done = 0;
  const TileSource next = [&]() -> std::optional<std::size_t> {
    const std::lock_guard lock(mutex);
    return stopped ? std::nullopt : source();
  };
  const TileSink take = [&](std::size_t tile, std::span<const double> costs) {
    const std::lock_guard lock(mutex);
    sink(tile, costs);
    ++done;
  };
  Desk desk(team, all_pairs_digest(shapes, options.compare), tiles, next, take);
  OwnShare own(shapes, next, take, options);
  while (!desk.is_empty() || !own.is_done()) {
    own.rethrow_failure();
    const double fraction =
        static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(tiles.size(), 1));
    if (!stopped && options.progress && !options.progress(fraction)) {
      stopped = true;
      own.stop();
    }
    if (const std::optional<TeamMessage> message = team.receive()) {
      desk.answer(*message);
    } else {
      std::this_thread::sleep_for(kNap);
    }
  }
  own.rethrow_failure();
  return !stopped;
}

bool follow_all_pairs(const Team& team, std::span<const ShapeDescriptor> shapes,
                      const AllPairsOptions& options) {
  const std::uint64_t hello[] = {kHello, all_pairs_digest(shapes, options.compare)};
  team.send(0, hello);
  bool more = true;  // all_pairs() calls source and sink one at a time
  const TileSource source = [&]() -> std::optional<std::size_t> {
    if (!more) return std::nullopt;
    const std::uint64_t ask[] = {kAsk};
    team.send(0, ask);
    for (;;) {
      if (options.progress && !options.progress(0.0)) return std::nullopt;
      if (const std::optional<TeamMessage> reply = team.receive()) {
        more = reply->words.size() == 2 && reply->words[0] == kTile;
        if (!more) return std::nullopt;
        return reply->words[1];
      }
      std::this_thread::sleep_for(kNap);
    }
  };
  const TileSink sink = [&](std::size_t tile, std::span<const double> costs) {
    std::vector<std::uint64_t> words = {kCosts, tile};
    for (const double cost : costs) words.push_back(to_word(cost));
    team.send(0, words);
  };
  // Stopped while it waited for a reply: all_pairs() has not seen it.
  if (!all_pairs(shapes, source, sink, options) || more) return false;
  const std::uint64_t bye[] = {kBye};
  team.send(0, bye);
  return true;
}

}  // namespace v0
}  // namespace tandem
