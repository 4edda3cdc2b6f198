#pragma once

namespace cli {

/// Thrown where the work stops because of Ctrl-C.
struct Interrupted {};

/// Ctrl-C (and SIGTERM, SIGHUP) end the program at once with 128 + signal, except inside the two scopes
/// below. A signal that the caller has set to be ignored stays ignored.
void install_interrupt_handlers();

/// The signal that came, or 0.
[[nodiscard]] int interrupt_signal();

/// @throws Interrupted when a signal has come
void throw_if_interrupted();

/// Work that asks interrupt_signal() now and then: the first signal is only noted, the second ends the
/// program.
class InterruptibleScope {
 public:
  InterruptibleScope();
  ~InterruptibleScope();
  InterruptibleScope(const InterruptibleScope&) = delete;
  InterruptibleScope& operator=(const InterruptibleScope&) = delete;

 private:
  int outer_;
};

/// Temporary files exist: every signal is only noted, so that nobody but the writer ends this scope.
class WritingScope {
 public:
  WritingScope();
  ~WritingScope();
  WritingScope(const WritingScope&) = delete;
  WritingScope& operator=(const WritingScope&) = delete;

 private:
  int outer_;
};

}  // namespace cli
