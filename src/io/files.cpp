#include "tandem/io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// No curve file is as large as this; a device or a pipe without end is.
constexpr std::size_t kLargestFile = std::size_t{256} << 20U;

std::string reason(int error) {
  return std::generic_category().message(error);
}

[[noreturn]] void fail(const char* what, const std::string& path, int error) {
  throw IoError(fmt::format("cannot {} {}: {}", what, path, reason(error)));
}

class FileDescriptor {
 public:
  explicit FileDescriptor(int value) : value_(value) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { close(); }

  [[nodiscard]] int get() const noexcept { return value_; }
  /// 0, or the errno of a close that could not write what was left.
  int close() noexcept {
    const int error = value_ > 2 && ::close(value_) != 0 ? errno : 0;
    value_ = -1;
    return error;
  }

 private:
  int value_;
};

/// Holds back the signals that end a program until the file is whole or gone again.
class DeferSignals {
 public:
  DeferSignals() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  DeferSignals(const DeferSignals&) = delete;
  DeferSignals& operator=(const DeferSignals&) = delete;
  ~DeferSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// 0 or the errno.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// The file that a chain of symbolic links leads to, which need not exist.
std::string link_target(const std::string& path) {
  std::filesystem::path target = path;
  std::error_code error;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(target, error); ++links) {
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

/// A new, empty file in the directory of `target`, so that it can take its name; the mode is the umask's.
FileDescriptor create_beside(const std::string& target, std::string& name) {
  const std::string directory = std::filesystem::path(target).parent_path().string();
  for (int attempt = 0;; ++attempt) {
    name = fmt::format("{}{}.tandem-{}-{}", directory, directory.empty() ? "" : "/", ::getpid(), attempt);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST || attempt == 1000) return FileDescriptor(descriptor);
  }
}

/// Devices and pipes cannot be replaced; they are written to.
void write_in_place(const std::string& path, std::string_view content) {
  FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) fail("write", path, errno);
  if (const int error = write_all(file.get(), content)) fail("write", path, error);
  if (const int error = file.close()) fail("write", path, error);
}

void replace_file(const std::string& path, std::string_view content, std::optional<mode_t> mode) {
  const std::string target = link_target(path);
  const DeferSignals defer;
  std::string temporary;
  FileDescriptor file = create_beside(target, temporary);
  if (file.get() < 0) fail("write", path, errno);
  int error = write_all(file.get(), content);
  if (error == 0 && mode && ::fchmod(file.get(), *mode) != 0) error = errno;
  const int close_error = file.close();
  if (error == 0) error = close_error;
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail("write", path, error);
  }
}

/// /dev/stdout and /dev/fd/3 may lead to a regular file, which the shell holds open and must not be replaced.
bool names_a_descriptor(const std::string& path) {
  return path.rfind("/dev/", 0) == 0 || path.rfind("/proc/", 0) == 0;
}

}  // namespace

std::string read_file(const std::string& path) {
  const bool standard_input = path == "-";
  const std::string name = standard_input ? "standard input" : path;
  FileDescriptor file(standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail("read", name, errno);
  const auto check_size = [&name](std::size_t size) {
    if (size <= kLargestFile) return;
    throw IoError(fmt::format("cannot read {}: it is larger than {} MiB", name, kLargestFile >> 20U));
  };
  std::string content;
  struct stat status {};
  if (::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode)) {
    check_size(static_cast<std::size_t>(status.st_size));
    content.reserve(static_cast<std::size_t>(status.st_size));
  }
  std::vector<char> buffer(std::size_t{1} << 16U);
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("read", name, errno);
    if (count == 0) return content;
    content.append(buffer.data(), static_cast<std::size_t>(count));
    check_size(content.size());
  }
}

void write_file(const std::string& path, std::string_view content) {
  if (path == "-") {
    if (const int error = write_all(STDOUT_FILENO, content)) fail("write", "standard output", error);
    return;
  }
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) fail("write", path, errno);
    replace_file(path, content, std::nullopt);
  } else if (S_ISDIR(status.st_mode)) {
    fail("write", path, EISDIR);
  } else if (S_ISREG(status.st_mode) && !names_a_descriptor(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail("write", path, errno);
    replace_file(path, content, status.st_mode & 07777U);
  } else {
    write_in_place(path, content);
  }
}

void write_file(const std::string& path, const FilePieces& next) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail("write", path, errno);
  if (exists && S_ISDIR(status.st_mode)) fail("write", path, EISDIR);
  if (exists && !S_ISREG(status.st_mode))
    throw IoError(fmt::format("cannot write {}: it is not a file", path));
  if (exists && ::access(path.c_str(), W_OK) != 0) fail("write", path, errno);
  const std::filesystem::path target = link_target(path);
  const std::string temporary = (target.parent_path() / (".tandem-" + target.filename().string())).string();
  FileDescriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.get() < 0) fail("write", path, errno);
  try {
    while (const std::optional<std::string> piece = next()) {
      if (const int error = write_all(file.get(), *piece)) fail("write", path, error);
    }
    if (exists && ::fchmod(file.get(), status.st_mode & 07777U) != 0) fail("write", path, errno);
    if (const int error = file.close()) fail("write", path, error);
    if (::rename(temporary.c_str(), target.c_str()) != 0) fail("write", path, errno);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace v0
}  // namespace tandem
