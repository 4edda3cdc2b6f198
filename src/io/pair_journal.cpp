#include "tandem/io/pair_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include "io/little_endian.h"
#include "rank/fnv.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

constexpr std::string_view kMagic = "\x89TDJ\r\n\x1a\n";
constexpr std::uint64_t kVersion1 = 1;
constexpr std::size_t kWord = 8;
constexpr std::size_t kHead = 5 * kWord;

std::uint64_t checksum(std::string_view bytes) {
  detail::Fnv sum;
  for (std::size_t at = 0; at < bytes.size(); at += kWord) sum.add_word(detail::get_word(bytes, at));
  return sum.value();
}

std::string format_head(std::uint64_t digest, std::size_t shapes) {
  std::string head(kMagic);
  for (const std::uint64_t word : {kVersion1, digest, std::uint64_t{shapes}}) detail::put_word(head, word);
  detail::put_word(head, checksum(std::string_view(head).substr(kMagic.size())));
  return head;
}

[[noreturn]] void fail(const char* what, const std::string& path, int error) {
  throw IoError(fmt::format("cannot {} {}: {}", what, path, std::generic_category().message(error)));
}

/// A file as it is now, without a copy in memory.
class Mapping {
 public:
  Mapping(int descriptor, std::size_t size, const std::string& path) : size_(size) {
    if (size_ == 0) return;
    data_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (data_ == MAP_FAILED) fail("read", path, errno);
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  ~Mapping() {
    if (size_ > 0) ::munmap(data_, size_);
  }
  [[nodiscard]] std::string_view content() const {
    return size_ > 0 ? std::string_view(static_cast<const char*>(data_), size_) : std::string_view();
  }

 private:
  void* data_ = nullptr;
  std::size_t size_;
};

}  // namespace

PairJournalScan scan_pair_journal(std::string_view content, std::uint64_t digest, const PairTiles& tiles) {
  PairJournalScan scan;
  scan.offsets.assign(tiles.size(), 0);
  const std::string_view start = content.substr(0, kMagic.size());
  if (start != kMagic.substr(0, start.size())) {
    scan.kind = PairJournalScan::Kind::foreign;
    return scan;
  }
  if (content.size() < kHead) return scan;
  if (content.substr(0, kHead) != format_head(digest, tiles.shapes())) {
    scan.kind = PairJournalScan::Kind::other;
    return scan;
  }
  scan.kind = PairJournalScan::Kind::ours;
  scan.end = kHead;
  while (content.size() - scan.end >= kWord) {
    const std::uint64_t tile = detail::get_word(content, scan.end);
    if (tile >= tiles.size()) break;
    const std::size_t checked = (1 + tiles.tile(tile).pairs()) * kWord;
    if (content.size() - scan.end < checked + kWord) break;
    if (detail::get_word(content, scan.end + checked) != checksum(content.substr(scan.end, checked))) break;
    if (scan.offsets[tile] == 0) {
      scan.offsets[tile] = scan.end + kWord;
      ++scan.done;
    }
    scan.end += checked + kWord;
  }
  return scan;
}

struct PairJournal::Impl {
  Impl(std::string name, std::size_t shapes) : path(std::move(name)), tiles(shapes) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (descriptor >= 0) ::close(descriptor);
  }

  /// Opens it for this process alone. The lock ends with the process, however that ends.
  void open() {
    for (;;) {
      descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (descriptor < 0) fail("write", path, errno);
      if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK) throw IoError(path + ": another process is at work on it");
        fail("lock", path, errno);
      }
      // The process that had it may have taken the file away in between.
      struct stat status {};
      if (::fstat(descriptor, &status) != 0) fail("read", path, errno);
      if (!S_ISREG(status.st_mode)) throw IoError(path + ": is not a regular file");
      size = static_cast<std::size_t>(status.st_size);
      if (status.st_nlink > 0) return;
      ::close(std::exchange(descriptor, -1));
    }
  }

  void cut(std::size_t at) {
    if (::ftruncate(descriptor, static_cast<off_t>(at)) != 0) fail("write", path, errno);
    size = at;
  }

  void append(std::string_view bytes) {
    std::size_t written = 0;
    while (written < bytes.size()) {
      const ssize_t count = ::pwrite(descriptor, bytes.data() + written, bytes.size() - written,
                                     static_cast<off_t>(size + written));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail("write", path, errno);
      written += static_cast<std::size_t>(count);
    }
    size += bytes.size();
  }

  std::string path;
  PairTiles tiles;
  int descriptor = -1;
  std::size_t size = 0;
  std::vector<std::uint64_t> offsets;
  std::atomic<std::size_t> done = 0;
  bool replaced_another = false;
};

PairJournal::PairJournal(const std::string& path, std::uint64_t digest, std::size_t shapes)
    : impl_(std::make_unique<Impl>(path, shapes)) {
  impl_->open();
  PairJournalScan scan =
      scan_pair_journal(Mapping(impl_->descriptor, impl_->size, path).content(), digest, impl_->tiles);
  if (scan.kind == PairJournalScan::Kind::foreign) {
    throw IoError(path +
                  ": is not the journal of a run over all pairs; move it away, or choose another output");
  }
  impl_->replaced_another = scan.kind == PairJournalScan::Kind::other;
  impl_->cut(scan.end);
  if (scan.kind != PairJournalScan::Kind::ours) impl_->append(format_head(digest, shapes));
  impl_->offsets = std::move(scan.offsets);
  impl_->done = scan.done;
}

PairJournal::PairJournal(PairJournal&&) noexcept = default;
PairJournal& PairJournal::operator=(PairJournal&&) noexcept = default;
PairJournal::~PairJournal() = default;

const PairTiles& PairJournal::tiles() const noexcept {
  return impl_->tiles;
}

std::size_t PairJournal::done() const noexcept {
  return impl_->done;
}

bool PairJournal::has(std::size_t tile) const {
  return tile < impl_->offsets.size() && impl_->offsets[tile] != 0;
}

bool PairJournal::replaced_another() const noexcept {
  return impl_->replaced_another;
}

void PairJournal::add(std::size_t tile, std::span<const double> costs) {
  const std::size_t pairs = impl_->tiles.tile(tile).pairs();
  if (costs.size() != pairs) {
    throw InvalidArgument(
        fmt::format("tile {} has {} pairs, but {} costs were given", tile, pairs, costs.size()));
  }
  if (has(tile)) return;
  std::string record;
  record.reserve((pairs + 2) * kWord);
  detail::put_word(record, tile);
  for (const double cost : costs) detail::put_number(record, cost);
  detail::put_word(record, checksum(record));
  const std::size_t offset = impl_->size + kWord;
  impl_->append(record);
  impl_->offsets[tile] = offset;
  ++impl_->done;
}

std::vector<double> PairJournal::costs(std::size_t tile) const {
  if (!has(tile)) throw InvalidArgument(fmt::format("tile {} is not in the journal", tile));
  std::string bytes(impl_->tiles.tile(tile).pairs() * kWord, '\0');
  std::size_t read = 0;
  while (read < bytes.size()) {
    const ssize_t count = ::pread(impl_->descriptor, bytes.data() + read, bytes.size() - read,
                                  static_cast<off_t>(impl_->offsets[tile] + read));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("read", impl_->path, errno);
    if (count == 0) throw IoError(impl_->path + ": has become shorter");
    read += static_cast<std::size_t>(count);
  }
  std::vector<double> costs;
  costs.reserve(bytes.size() / kWord);
  for (std::size_t at = 0; at < bytes.size(); at += kWord) costs.push_back(detail::get_number(bytes, at));
  return costs;
}

void PairJournal::remove() {
  if (::unlink(impl_->path.c_str()) != 0) fail("remove", impl_->path, errno);
}

}  // namespace v0
}  // namespace tandem
