#include "tandem/rank/team.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "rank/shapes.h"
#include "tandem/error.h"

namespace {

using tandem::AllPairsOptions;
using tandem::PairTiles;
using tandem::ShapeDescriptor;
using tandem::Team;
using tandem::TeamMessage;
using namespace tandem::testing_rank;

/// Carries messages between threads that stand for processes.
class Mail {
 public:
  explicit Mail(int size) : boxes_(static_cast<std::size_t>(size)) {}

  Team team(int rank) {
    return {rank, static_cast<int>(boxes_.size()),
            [this, rank](int to, std::span<const std::uint64_t> words) {
              const std::lock_guard lock(mutex_);
              boxes_[static_cast<std::size_t>(to)].push_back({rank, {words.begin(), words.end()}});
            },
            [this, rank]() -> std::optional<TeamMessage> {
              const std::lock_guard lock(mutex_);
              std::deque<TeamMessage>& box = boxes_[static_cast<std::size_t>(rank)];
              if (box.empty()) return std::nullopt;
              TeamMessage message = std::move(box.front());
              box.pop_front();
              return message;
            }};
  }

 private:
  std::mutex mutex_;
  std::vector<std::deque<TeamMessage>> boxes_;
};

using Tiles = std::vector<std::vector<double>>;

/// What the leader of that many collects. The followers' shapes may be others.
Tiles collect(int size, std::span<const ShapeDescriptor> shapes, std::span<const ShapeDescriptor> followers,
              const tandem::Progress& progress = {}, bool* finished = nullptr) {
  Mail mail(size);
  std::atomic<bool> over = false;
  std::vector<std::thread> threads;
  for (int rank = 1; rank < size; ++rank) {
    threads.emplace_back([&, rank] {
      (void)follow_all_pairs(mail.team(rank), followers,
                             {.threads = rank, .progress = [&](double) { return !over; }});
    });
  }
  const PairTiles tiles(shapes.size());
  Tiles found(tiles.size());
  std::size_t next = 0;
  std::exception_ptr failure;
  try {
    const bool whole = lead_all_pairs(
        mail.team(0), shapes, [&] { return next == tiles.size() ? std::nullopt : std::optional(next++); },
        [&](std::size_t tile, std::span<const double> costs) {
          EXPECT_TRUE(found[tile].empty());
          found[tile].assign(costs.begin(), costs.end());
        },
        {.threads = 1, .progress = progress});
    if (finished != nullptr) *finished = whole;
  } catch (...) {
    failure = std::current_exception();
    over = true;
  }
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
  return found;
}

TEST(Team, SharesOutTheWorkWithoutATrace) {
  const std::vector<ShapeDescriptor> shapes = stars(60, 21, 16);
  const Tiles alone = collect(1, shapes, shapes);
  for (const std::vector<double>& costs : alone) EXPECT_FALSE(costs.empty());
  EXPECT_EQ(collect(2, shapes, shapes), alone);
  EXPECT_EQ(collect(4, shapes, shapes), alone);
}

TEST(Team, EveryoneGetsWorkAndGoesHome) {
  const std::vector<ShapeDescriptor> shapes = stars(60, 22, 16);
  Mail mail(2);
  std::atomic<int> asked = 0;
  std::thread follower([&] {
    EXPECT_TRUE(follow_all_pairs(mail.team(1), shapes, {.threads = 1, .progress = [&](double) {
                                                          ++asked;
                                                          return true;
                                                        }}));
  });
  std::size_t next = 0;
  const PairTiles tiles(shapes.size());
  EXPECT_TRUE(lead_all_pairs(
      mail.team(0), shapes, [&] { return next == tiles.size() ? std::nullopt : std::optional(next++); },
      [](std::size_t, std::span<const double>) {}, {.threads = 1}));
  follower.join();
  EXPECT_GT(asked, 10);
}

TEST(Team, StopsTogether) {
  const std::vector<ShapeDescriptor> shapes = stars(200, 23, 16);
  bool finished = true;
  int asked = 0;
  const Tiles some = collect(
      3, shapes, shapes, [&](double) { return ++asked < 5; }, &finished);
  EXPECT_FALSE(finished);
  EXPECT_GT(std::count(some.begin(), some.end(), std::vector<double>{}), 0);
}

TEST(Team, RefusesOthersShapes) {
  const std::vector<ShapeDescriptor> shapes = stars(30, 24, 16);
  EXPECT_THROW((void)collect(2, shapes, std::span(shapes).first(29)), tandem::InvalidArgument);
}

TEST(Team, RefusesMessagesThatMakeNoSense) {
  const std::vector<ShapeDescriptor> shapes = stars(30, 25, 16);
  const std::vector<std::vector<std::uint64_t>> messages = {{}, {0}, {2}, {2, 5}, {2, 1'000'000, 1}, {77}};
  for (const std::vector<std::uint64_t>& words : messages) {
    Mail mail(2);
    mail.team(1).send(0, words);
    EXPECT_THROW(
        (void)lead_all_pairs(
            mail.team(0), shapes, [] { return std::nullopt; }, [](std::size_t, std::span<const double>) {}),
        tandem::InvalidArgument);
  }
}

}  // namespace
