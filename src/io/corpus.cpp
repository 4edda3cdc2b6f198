#include "tandem/io/corpus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <variant>

#include "io/file_format.h"
#include "io/font_reader.h"
#include "io/json_lines.h"
#include "tandem/error.h"
#include "tandem/io/tdx.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace {

namespace fs = std::filesystem;

/// A file that waits for its turn, or anything else that names a shape.
struct Entry {
  std::string name;
  std::string label;
  bool required = true;  ///< named itself, not found in a directory
};

bool holds_shapes(FileFormat format) {
  return format != FileFormat::unknown && format != FileFormat::cad && format != FileFormat::compressed;
}

std::vector<Entry> list_directory(const std::string& directory) {
  std::error_code error;
  std::vector<Entry> entries;
  const fs::path root(directory);
  // Links to directories are not followed: they may lead round in circles, and to the same shapes twice.
  auto each = fs::recursive_directory_iterator(root, fs::directory_options::skip_permission_denied, error);
  for (; !error && each != fs::recursive_directory_iterator(); each.increment(error)) {
    std::error_code ignored;
    const fs::path& path = each->path();
    if (!fs::is_regular_file(path, ignored) || !holds_shapes(format_of_extension(path.string()))) continue;
    const bool nested = path.parent_path() != root && each.depth() > 0;
    entries.push_back({path.string(), nested ? path.parent_path().filename().string() : "", false});
  }
  if (error) throw IoError(fmt::format("cannot list {}: {}", directory, error.message()));
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) { return x.name < y.name; });
  return entries;
}

/// A candidate that cannot be read.
Candidate broken(const std::string& name, const std::exception_ptr& error) {
  return {name, [error]() -> ShapeDescriptor { std::rethrow_exception(error); }, false};
}

/// The single character that a part of a font names, as glyphs of whole fonts have it for a label.
std::string label_of_part(const FilePart& file) {
  if (format_of_extension(file.path) != FileFormat::font || !file.part) return {};
  const std::string& part = *file.part;
  const bool one = std::count_if(part.begin(), part.end(), [](char c) {
                     return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
                   }) == 1;
  return one ? part : std::string();
}

class FontGlyphs {
 public:
  FontGlyphs(const Entry& entry, int samples) : path_(entry.name), samples_(samples), font_(entry.name) {}

  [[nodiscard]] std::optional<Candidate> next() {
    while (at_ < font_.size()) {
      NamedGlyph glyph;
      try {
        glyph = font_.glyph(at_++);
      } catch (const Error&) {
        return broken(fmt::format("{}#glyph{}", path_, at_ - 1), std::current_exception());
      }
      if (glyph.outline.contours.empty()) continue;
      DescribeOptions options{samples_, path_ + "#" + glyph.name, glyph.character};
      return Candidate{options.name,
                       [shape = std::move(glyph.outline), options] {
                         const Curve& contour = shape.contours[outer_contour(shape)];
                         // Fonts have y up, everything else that is planar has y down.
                         return describe(transform(contour, Transform::scale(1.0, -1.0)), options);
                       },
                       false};
    }
    return std::nullopt;
  }
  [[nodiscard]] double fraction() const {
    return static_cast<double>(at_) / static_cast<double>(font_.size());
  }

 private:
  std::string path_;
  int samples_;
  FontReader font_;
  std::size_t at_ = 0;
};

class LineShapes {
 public:
  LineShapes(const Entry& entry, int samples)
      : path_(entry.name), samples_(samples), in_(std::make_unique<std::ifstream>(entry.name)), lines_(*in_) {
    if (!in_->is_open()) throw IoError(fmt::format("cannot read {}", path_));
    std::error_code error;
    size_ = static_cast<double>(fs::file_size(path_, error));
  }

  [[nodiscard]] std::optional<Candidate> next() {
    std::optional<JsonLine> line = lines_.next();
    if (!line) {
      if (in_->bad()) throw IoError(fmt::format("cannot read {} to its end", path_));
      return std::nullopt;
    }
    read_ += static_cast<double>(line->text.size());
    DescribeOptions options{samples_, fmt::format("{}#{}", path_, count_++), {}};
    return Candidate{options.name,
                     [line = *std::move(line), options, path = path_]() mutable {
                       NamedShape named = parse_json_line(line, path);
                       if (!named.name.empty()) options.name = std::move(named.name);
                       options.label = std::move(named.label);
                       return describe(named.shape, options);
                     },
                     false};
  }
  [[nodiscard]] double fraction() const { return std::min(1.0, read_ / std::max(size_, 1.0)); }

 private:
  std::string path_;
  int samples_;
  std::unique_ptr<std::ifstream> in_;
  JsonLines lines_;
  double size_ = 0.0;
  double read_ = 0.0;
  std::size_t count_ = 0;
};

class IndexRecords {
 public:
  explicit IndexRecords(const Entry& entry) : reader_(entry.name) {}

  [[nodiscard]] std::optional<Candidate> next() {
    std::optional<ShapeDescriptor> shape = reader_.next();
    if (!shape) return std::nullopt;
    ++read_;
    std::string name = shape->name();
    return Candidate{std::move(name), [shape = *std::move(shape)] { return shape; }, false};
  }
  [[nodiscard]] double fraction() const {
    return static_cast<double>(read_) / static_cast<double>(std::max<std::size_t>(reader_.size(), 1));
  }

 private:
  TdxReader reader_;
  std::size_t read_ = 0;
};

/// FILE.tdx#PART: the record of that name, or of that number.
ShapeDescriptor find_record(const FilePart& file) {
  TdxReader reader(file.path);
  std::optional<ShapeDescriptor> numbered;
  for (std::size_t k = 0; std::optional<ShapeDescriptor> shape = reader.next(); ++k) {
    if (shape->name() == *file.part) return *std::move(shape);
    // The name of a later one goes first.
    if (std::to_string(k) == *file.part) numbered = shape;
  }
  if (numbered) return *std::move(numbered);
  throw ParseError(file.path, 0, 0,
                   fmt::format("has no shape '{}'; it has {} (#0 to #{}), and their names", *file.part,
                               reader.size(), static_cast<long long>(reader.size()) - 1));
}

}  // namespace

struct Corpus::Impl {
  CorpusOptions options;
  std::deque<Entry> waiting;
  std::size_t entries = 0;
  std::variant<std::monostate, FontGlyphs, LineShapes, IndexRecords> open;

  /// Opens the file, when it holds many shapes.
  bool start(const Entry& entry) {
    switch (format_of_extension(entry.name)) {
      case FileFormat::font:
        open.emplace<FontGlyphs>(entry, options.samples);
        return true;
      case FileFormat::json_lines:
        open.emplace<LineShapes>(entry, options.samples);
        return true;
      case FileFormat::index:
        open.emplace<IndexRecords>(entry);
        return true;
      default:
        return false;
    }
  }

  [[nodiscard]] std::optional<Candidate> next_of_open() {
    return std::visit(
        [](auto& source) -> std::optional<Candidate> {
          if constexpr (std::is_same_v<std::decay_t<decltype(source)>, std::monostate>) {
            return std::nullopt;
          } else {
            return source.next();
          }
        },
        open);
  }

  [[nodiscard]] Candidate single(const Entry& entry) const {
    return {entry.name,
            [entry, own = options]() -> ShapeDescriptor {
              const std::optional<FilePart> file = existing_file(entry.name);
              if (file && file->part && format_of_extension(file->path) == FileFormat::index)
                return find_record(*file);
              const Shape shape = load_shape(entry.name, own.load);
              if (shape.contours.empty()) throw InvalidArgument("holds no contour");
              return describe(shape, {own.samples, entry.name,
                                      entry.label.empty() && file ? label_of_part(*file) : entry.label});
            },
            entry.required};
  }

  /// The next candidate; `current` is the entry that it comes from, so that a file found in a directory may
  /// be broken.
  [[nodiscard]] std::optional<Candidate> next() {
    for (;;) {
      try {
        if (std::optional<Candidate> candidate = next_of_open()) return candidate;
        open.emplace<std::monostate>();
        if (waiting.empty()) return std::nullopt;
        current = std::move(waiting.front());
        waiting.pop_front();
        const std::optional<FilePart> file = existing_file(current.name);
        if (file && !file->part && start(current)) continue;
      } catch (const Error&) {
        open.emplace<std::monostate>();
        if (current.required) throw;
        return broken(current.name, std::current_exception());
      }
      return single(current);
    }
  }

  Entry current;
};

Corpus::Corpus(const std::vector<std::string>& names, const CorpusOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->options = options;
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      impl_->waiting.push_back({name, "", true});
      continue;
    }
    for (Entry& entry : list_directory(name)) impl_->waiting.push_back(std::move(entry));
  }
  impl_->entries = impl_->waiting.size();
}

Corpus::Corpus(Corpus&&) noexcept = default;
Corpus& Corpus::operator=(Corpus&&) noexcept = default;
Corpus::~Corpus() = default;

std::optional<Candidate> Corpus::next() {
  return impl_->next();
}

double Corpus::fraction() const {
  if (impl_->entries == 0) return 1.0;
  const double started = static_cast<double>(impl_->entries - impl_->waiting.size());
  const double open = std::visit(
      [](const auto& source) -> double {
        if constexpr (std::is_same_v<std::decay_t<decltype(source)>, std::monostate>) {
          return 1.0;
        } else {
          return source.fraction();
        }
      },
      impl_->open);
  return std::max(0.0, started - 1.0 + open) / static_cast<double>(impl_->entries);
}

}  // namespace v0
}  // namespace tandem
