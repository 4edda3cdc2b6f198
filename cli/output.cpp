#include "output.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "interrupt.h"
#include "tandem/error.h"
#include "tandem/io/files.h"
#include "usage_error.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

struct Ending {
  std::string_view text;
  std::string_view word;  ///< of --to
  Format format;
};
// The longer of two endings that fit stands first.
constexpr std::array kEndings = {Ending{".lottie.json", "lottie", Format::lottie},
                                 Ending{".avd.xml", "avd", Format::animated_vector},
                                 Ending{".json", "json", Format::json},
                                 Ending{".svg", "svg", Format::svg},
                                 Ending{".html", "html", Format::html},
                                 Ending{".css", "css", Format::css},
                                 Ending{".gif", "gif", Format::gif},
                                 Ending{".png", "png", Format::png},
                                 Ending{".itd", "itd", Format::itd},
                                 Ending{".tdx", "tdx", Format::index},
                                 Ending{".jsonl", "jsonl", Format::json_lines},
                                 Ending{".npy", "npy", Format::npy},
                                 Ending{".csv", "csv", Format::csv},
                                 Ending{".obj", "obj", Format::obj},
                                 Ending{".stl", "stl", Format::stl},
                                 Ending{".ply", "ply", Format::ply},
                                 Ending{".glb", "glb", Format::glb},
                                 Ending{".step", "step", Format::step},
                                 Ending{".stp", "stp", Format::step},
                                 Ending{".iges", "iges", Format::iges},
                                 Ending{".igs", "igs", Format::iges},
                                 Ending{".brep", "brep", Format::brep}};

std::string list(const std::vector<Format>& allowed, std::string_view Ending::*part) {
  std::string text;
  for (const Ending& ending : kEndings) {
    if (std::find(allowed.begin(), allowed.end(), ending.format) == allowed.end()) continue;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", ending.*part);
  }
  return text;
}

bool allows(const std::vector<Format>& allowed, Format format) {
  return std::find(allowed.begin(), allowed.end(), format) != allowed.end();
}

[[noreturn]] void fail(const fs::path& path, std::string_view what, int error) {
  throw tandem::IoError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(error)));
}

bool is_frame_name(const std::string& name) {
  constexpr std::string_view kHead = "frame_";
  constexpr std::size_t kTail = 4;
  if (name.size() <= kHead.size() + kTail || name.rfind(kHead, 0) != 0) return false;
  const std::string tail = name.substr(name.size() - kTail);
  if (tail != ".svg" && tail != ".png" && tail != ".csv") return false;
  return std::all_of(name.begin() + kHead.size(), name.end() - kTail,
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

void check_replaceable(const fs::path& directory) {
  std::error_code error;
  if (!fs::exists(directory, error)) return;
  if (!fs::is_directory(directory, error)) fail(directory, "is not a directory", ENOTDIR);
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
    if (is_frame_name(entry.path().filename().string()) && entry.is_regular_file(error)) continue;
    throw tandem::IoError(
        fmt::format("{}: holds other files than frames ({}); choose a new or an empty directory",
                    directory.string(), entry.path().filename().string()));
  }
  if (error) fail(directory, "cannot be read", error.value());
}

/// The directory that frames shall be in, which may be replaced by them.
fs::path frame_target(const std::string& path) {
  std::error_code error;
  fs::path target =
      fs::weakly_canonical(path, error);  // a link to a directory stays one; no slash at the end
  if (error) fail(path, "cannot be written", error.value());
  if (!target.has_filename()) target = target.parent_path();
  check_replaceable(target);
  return target;
}

/// A directory that is removed again unless it was handed over.
class TemporaryDirectory {
 public:
  explicit TemporaryDirectory(const fs::path& beside) {
    std::string name = fmt::format("{}.tmp-XXXXXX", beside.string());
    if (mkdtemp(name.data()) == nullptr) fail(beside, "cannot be made", errno);
    path_ = name;
    const mode_t mask = umask(0);
    umask(mask);
    chmod(name.c_str(), 0777 & ~mask);  // mkdtemp makes it private
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] const fs::path& path() const noexcept { return path_; }

  void take_name(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);  // works on a missing and on an empty directory
    if (error) replace(target);
    path_.clear();
  }

 private:
  void replace(const fs::path& target) {
    const fs::path old = path_.string() + ".old";
    std::error_code error;
    fs::rename(target, old, error);
    if (error) fail(target, "cannot be replaced", error.value());
    fs::rename(path_, target, error);
    if (error) {
      const int reason = error.value();
      fs::rename(old, target, error);
      fail(target, "cannot be replaced", reason);
    }
    fs::remove_all(old, error);
  }

  fs::path path_;
};

}  // namespace

Format output_format(const std::string& path, const std::string& to, const std::vector<Format>& allowed) {
  std::error_code error;
  const bool directory = allows(allowed, Format::directory) && path != "-" &&
                         (path.back() == '/' || fs::is_directory(path, error));
  if (!to.empty()) {
    for (const Ending& ending : kEndings) {
      if (to != ending.word || !allows(allowed, ending.format)) continue;
      const bool frames =
          ending.format == Format::svg || ending.format == Format::png || ending.format == Format::csv;
      if (directory && frames) return Format::directory;
      if (path.back() == '/') {
        throw UsageError(fmt::format("{} is a directory, and --to {} wants a file", path, to));
      }
      return ending.format;
    }
    throw UsageError(fmt::format("--to takes one of {}, not '{}'", list(allowed, &Ending::word), to));
  }
  if (path == "-") return allows(allowed, Format::json) ? Format::json : allowed.back();
  if (directory) return Format::directory;
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const Ending& ending : kEndings) {
    const bool fits = lower.size() > ending.text.size() &&
                      lower.compare(lower.size() - ending.text.size(), ending.text.size(), ending.text) == 0;
    if (fits && allows(allowed, ending.format)) return ending.format;
    if (fits) break;
  }
  if (fs::is_directory(path, error)) {
    throw UsageError(
        fmt::format("{} is a directory, expected a file: {}", path, list(allowed, &Ending::text)));
  }
  throw UsageError(fmt::format("{}: the ending does not tell a format; there is {}{}, or use --to", path,
                               list(allowed, &Ending::text),
                               allows(allowed, Format::directory) ? ", DIRECTORY/" : ""));
}

void check_writable(const std::string& path, bool frames) {
  const auto refuse = [&](int error) {
    throw tandem::IoError(fmt::format("cannot write {}: {}", path, std::strerror(error)));
  };
  if (path == "-") return;
  const fs::path target = frames ? frame_target(path) : fs::path(path);
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status) && !frames) refuse(EISDIR);
  if (fs::exists(status)) {
    if (::access(target.c_str(), W_OK) != 0) refuse(errno);
    return;
  }
  const fs::path parent = target.parent_path();
  if (::access(parent.empty() ? "." : parent.c_str(), W_OK | X_OK) != 0) refuse(errno);
}

void write_output(const std::string& path, std::string_view content) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  // A pipe may keep us waiting, and nothing of it can be taken back: Ctrl-C ends the program there as usual.
  if (path == "-" || (fs::exists(status) && !fs::is_regular_file(status)))
    return tandem::write_file(path, content);
  {
    const WritingScope writing;
    tandem::write_file(path, content);
  }
  throw_if_interrupted();
}

void write_frame_directory(const std::string& path, std::size_t count, std::string_view ending,
                           const std::function<std::string(std::size_t)>& content) {
  const fs::path target = frame_target(path);
  const int digits = std::max(3, static_cast<int>(fmt::format("{}", count - 1).size()));
  {
    const WritingScope writing;
    TemporaryDirectory temporary(target);
    for (std::size_t i = 0; i < count; ++i) {
      throw_if_interrupted();
      tandem::write_file((temporary.path() / fmt::format("frame_{:0{}}{}", i, digits, ending)).string(),
                         content(i));
    }
    temporary.take_name(target);
  }
}

}  // namespace cli
