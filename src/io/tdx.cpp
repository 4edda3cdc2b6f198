#include "tandem/io/tdx.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#include "rank/fnv.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kMagic = "\x89TDX\r\n\x1a\n"sv;
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kClosed = 1;
constexpr std::size_t kHeadSize = 24;
constexpr std::size_t kRecordHeadSize = 20;
constexpr std::size_t kChecksumSize = 8;
constexpr std::uint32_t kLargestText = 1U << 24U;
constexpr std::uint32_t kMostChords = 10'000;  // as ShapeDescriptor
constexpr std::uint32_t kLargestDimension = 1'000;
/// Bounds what a damaged size makes us allocate.
constexpr std::uint32_t kLargestRecord = 1U << 28U;

[[noreturn]] void fail(const std::string& source, const std::string& message) {
  throw ParseError(source, 0, 0, message);
}

void put(std::string& out, std::uint64_t value, int bytes) {
  for (int k = 0; k < bytes; ++k)
    out += static_cast<char>((value >> (8U * static_cast<unsigned>(k))) & 0xFFU);
}

void put_float(std::string& out, double value) {
  const auto single = static_cast<float>(value);
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof single);
  std::memcpy(&bits, &single, sizeof bits);
  put(out, bits, 4);
}

/// Takes numbers off the front of a text that is known to be long enough.
class Bytes {
 public:
  explicit Bytes(std::string_view text) : text_(text) {}

  [[nodiscard]] std::uint64_t number(int bytes) {
    std::uint64_t value = 0;
    for (int k = 0; k < bytes; ++k) {
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(text_[static_cast<std::size_t>(k)]))
               << (8U * static_cast<unsigned>(k));
    }
    text_.remove_prefix(static_cast<std::size_t>(bytes));
    return value;
  }
  [[nodiscard]] std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  [[nodiscard]] double real() {
    const std::uint32_t bits = u32();
    float single = 0.0F;
    std::memcpy(&single, &bits, sizeof single);
    return static_cast<double>(single);
  }
  [[nodiscard]] std::string text(std::size_t size) {
    std::string result(text_.substr(0, size));
    text_.remove_prefix(size);
    return result;
  }

 private:
  std::string_view text_;
};

/// The number of records. head: kHeadSize bytes, or what there is.
std::size_t parse_head(std::string_view head, const std::string& source) {
  if (head.substr(0, kMagic.size()) != kMagic) {
    const bool damaged = head.size() > 4 && head.substr(1, 3) == "TDX";
    fail(source, damaged ? "is a .tdx index damaged by being sent as text" : "is no .tdx index");
  }
  if (head.size() < kHeadSize) fail(source, "ends within its first 24 bytes");
  Bytes bytes(head.substr(kMagic.size()));
  const std::uint32_t version = bytes.u32();
  if (version != kVersion) {
    fail(source, fmt::format("is an index of version {}, expected {}: make it anew with tandem index",
                             version, kVersion));
  }
  if (bytes.u32() != 0) fail(source, "is damaged: its second word must be 0");
  return static_cast<std::size_t>(bytes.number(8));
}

std::uint64_t checksum(std::string_view record) {
  detail::Fnv hash;
  hash.add_bytes(record);
  return hash.value();
}

std::string record_error(std::size_t index, const std::string& what) {
  return fmt::format("record {} {}", index, what);
}

/// Size of a record from its first word.
std::size_t checked_size(std::uint32_t size, std::size_t index, const std::string& source) {
  if (size < kRecordHeadSize + kChecksumSize || size > kLargestRecord)
    fail(source, record_error(index, fmt::format("is damaged: it cannot have {} bytes", size)));
  return size;
}

ShapeDescriptor parse_record(std::string_view record, std::size_t index, const std::string& source) {
  const std::string_view checked = record.substr(0, record.size() - kChecksumSize);
  if (Bytes(record.substr(checked.size())).number(8) != checksum(checked))
    fail(source, record_error(index, "is damaged: its checksum is wrong"));
  Bytes bytes(checked);
  const std::uint32_t flags = bytes.u32();
  const std::uint32_t dim = bytes.u32();
  const std::uint32_t chords = bytes.u32();
  const std::uint32_t name_size = bytes.u32();
  const std::uint32_t label_size = bytes.u32();
  if (flags > kClosed || dim < 1 || dim > kLargestDimension || chords > kMostChords ||
      name_size > kLargestText || label_size > kLargestText) {
    fail(source, record_error(index, "is damaged: flags, dimension or sizes out of range"));
  }
  const std::uint64_t expected = kRecordHeadSize + std::uint64_t{name_size} + label_size +
                                 std::uint64_t{4} * chords * (std::uint64_t{dim} + 1);
  if (expected != checked.size()) {
    fail(source, record_error(index, fmt::format("is damaged: it has {} bytes, its sizes say {}",
                                                 checked.size(), expected)));
  }
  std::string name = bytes.text(name_size);
  std::string label = bytes.text(label_size);
  Points tangents(static_cast<int>(dim), chords);
  for (double& c : tangents.data()) c = bytes.real();
  std::vector<double> lengths(chords);
  for (double& length : lengths) length = bytes.real();
  try {
    return {flags == kClosed, std::move(tangents), std::move(lengths), std::move(name), std::move(label)};
  } catch (const InvalidArgument& error) {
    fail(source, record_error(index, error.what()));
  }
}

}  // namespace

std::string format_tdx_head(std::size_t records) {
  std::string out(kMagic);
  put(out, kVersion, 4);
  put(out, 0, 4);
  put(out, records, 8);
  return out;
}

std::string format_tdx_record(const ShapeDescriptor& shape) {
  if (shape.name().size() > kLargestText || shape.label().size() > kLargestText)
    throw InvalidArgument("a name or label is longer than an index can hold (16 MiB)");
  if (static_cast<std::uint32_t>(shape.dim()) > kLargestDimension) {
    throw InvalidArgument(
        fmt::format("an index holds curves of up to {} dimensions, not {}", kLargestDimension, shape.dim()));
  }
  std::string record;
  put(record, shape.is_closed() ? kClosed : 0, 4);
  put(record, static_cast<std::uint64_t>(shape.dim()), 4);
  put(record, shape.size(), 4);
  put(record, shape.name().size(), 4);
  put(record, shape.label().size(), 4);
  record += shape.name();
  record += shape.label();
  for (const double c : shape.tangents().data()) put_float(record, c);
  for (const double length : shape.lengths()) put_float(record, length);
  const std::uint64_t sum = checksum(record);
  put(record, sum, kChecksumSize);
  std::string out;
  put(out, record.size(), 4);
  return out + record;
}

std::string format_tdx(std::span<const ShapeDescriptor> shapes) {
  std::string out = format_tdx_head(shapes.size());
  for (const ShapeDescriptor& shape : shapes) out += format_tdx_record(shape);
  return out;
}

std::vector<ShapeDescriptor> parse_tdx(std::string_view content, const std::string& source) {
  const std::size_t count = parse_head(content.substr(0, kHeadSize), source);
  content.remove_prefix(kHeadSize);
  std::vector<ShapeDescriptor> shapes;
  for (std::size_t k = 0; k < count; ++k) {
    if (content.size() < 4) fail(source, fmt::format("is cut off: it has {} of {} records", k, count));
    const std::size_t size = checked_size(Bytes(content).u32(), k, source);
    content.remove_prefix(4);
    if (content.size() < size) fail(source, fmt::format("is cut off: it has {} of {} records", k, count));
    shapes.push_back(parse_record(content.substr(0, size), k, source));
    content.remove_prefix(size);
  }
  if (!content.empty()) fail(source, fmt::format("goes on after its {} records", count));
  return shapes;
}

struct TdxReader::Impl {
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string path;
  std::unique_ptr<std::FILE, Close> file;
  std::size_t count = 0;
  std::size_t read = 0;

  /// Up to `size` bytes.
  [[nodiscard]] std::string take(std::size_t size) {
    std::string content(size, '\0');
    content.resize(std::fread(content.data(), 1, size, file.get()));
    if (content.size() < size && std::ferror(file.get()) != 0) fail_to_read();
    return content;
  }
  [[nodiscard]] std::string take_all(std::size_t size) {
    std::string content = take(size);
    if (content.size() < size) fail(path, fmt::format("is cut off: it has {} of {} records", read, count));
    return content;
  }
  [[noreturn]] void fail_to_read() const {
    throw IoError(fmt::format("cannot read {}: {}", path, std::generic_category().message(errno)));
  }
};

TdxReader::TdxReader(const std::string& path) : impl_(std::make_unique<Impl>()) {
  impl_->path = path;
  impl_->file.reset(std::fopen(path.c_str(), "rbe"));
  if (impl_->file == nullptr) impl_->fail_to_read();
  impl_->count = parse_head(impl_->take(kHeadSize), path);
}

TdxReader::TdxReader(TdxReader&&) noexcept = default;
TdxReader& TdxReader::operator=(TdxReader&&) noexcept = default;
TdxReader::~TdxReader() = default;

std::size_t TdxReader::size() const noexcept {
  return impl_->count;
}

std::optional<ShapeDescriptor> TdxReader::next() {
  Impl& in = *impl_;
  if (in.read == in.count) {
    if (!in.take(1).empty()) fail(in.path, fmt::format("goes on after its {} records", in.count));
    return std::nullopt;
  }
  const std::size_t size = checked_size(Bytes(in.take_all(4)).u32(), in.read, in.path);
  ShapeDescriptor shape = parse_record(in.take_all(size), in.read, in.path);
  ++in.read;
  return shape;
}

}  // namespace v0
}  // namespace tandem
