#include "interrupt.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

#include "progress_bar.h"

namespace cli {
namespace {

enum Reaction : int { kEnd, kNoteFirst, kNote };

// Handlers can see nothing but globals; lock-free atomics are safe in them.
std::atomic<int> reaction{kEnd};
std::atomic<int> signal_seen{0};
static_assert(std::atomic<int>::is_always_lock_free);

void on_signal(int signal) {
  const int first = signal_seen.exchange(signal);
  if (reaction == kNote || (reaction == kNoteFirst && first == 0)) return;
  erase_progress_bar();
  _exit(128 + signal);
}

}  // namespace

void install_interrupt_handlers() {
  for (const int signal : std::array{SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

int interrupt_signal() {
  return signal_seen;
}

void throw_if_interrupted() {
  if (signal_seen != 0) throw Interrupted{};
}

InterruptibleScope::InterruptibleScope() : outer_(reaction.exchange(kNoteFirst)) {}
InterruptibleScope::~InterruptibleScope() {
  reaction = outer_;
}
WritingScope::WritingScope() : outer_(reaction.exchange(kNote)) {}
WritingScope::~WritingScope() {
  reaction = outer_;
}

}  // namespace cli
