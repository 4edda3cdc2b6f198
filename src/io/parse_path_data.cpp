#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/path_data_reader.h"
#include "io/scanner.h"
#include "io/text_position.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
inline namespace v0 {
namespace {

Vec2 operator+(Vec2 p, Vec2 q) {
  return {p.x + q.x, p.y + q.y};
}

/// 2 p - q: the handle that continues the one at q smoothly.
Vec2 mirrored(Vec2 p, Vec2 q) {
  return {p.x + (p.x - q.x), p.y + (p.y - q.y)};
}

char upper(char c) {
  return static_cast<char>(c - (c >= 'a' && c <= 'z' ? 'a' - 'A' : 0));
}

bool is_command(char c) {
  return c != '\0' && std::string_view("MLHVCSQTAZ").find(upper(c)) != std::string_view::npos;
}

/// SVG 2, section 9.3. One member function per command; a command's letter may be followed by several
/// argument sets, with or without a comma between them.
class PathDataReader {
 public:
  PathDataReader(std::string_view text, const Transform& transform) : scanner_(text), transform_(transform) {
    builder_.set_transform(transform);
  }

  std::vector<CubicPath> read() {
    try {
      scanner_.skip_blanks();
      while (!scanner_.at_end()) {
        read_command();
        scanner_.skip_blanks();
      }
      std::vector<CubicPath> paths = builder_.take();
      if (std::all_of(paths.begin(), paths.end(), is_in_range)) return paths;
    } catch (const InvalidArgument&) {  // not finite
    }
    Scanner::fail(scanner_.position(), "an arc reaches beyond the largest coordinate, 1e300");
  }

 private:
  void read_command() {
    const char letter = scanner_.peek();
    if (first_ && upper(letter) != 'M') scanner_.fail_expected("M or m, with which path data starts");
    if (!is_command(letter)) {
      scanner_.fail_expected("a command (one of MLHVCSQTAZ, or lower case)");
    }
    first_ = false;
    scanner_.advance();
    scanner_.skip_blanks();
    command_ = upper(letter);
    relative_ = letter != command_;
    if (command_ == 'Z') {
      builder_.close();
      current_ = start_;
      previous_ = 'Z';
      return;
    }
    bool comma = false;
    do {
      draw();
      previous_ = command_;
      if (command_ == 'M') command_ = 'L';  // more points after a moveto are lines
      comma = scanner_.skip_comma_and_blanks();
    } while (comma || scanner_.number_follows());
  }

  void draw() {
    switch (command_) {
      case 'M':
        current_ = start_ = point();
        builder_.move_to(current_);
        break;
      case 'L':
        line_to(point());
        break;
      case 'H': {
        const std::size_t offset = scanner_.position();
        const double x = argument("x");
        line_to(checked({relative_ ? current_.x + x : x, current_.y}, offset));
        break;
      }
      case 'V': {
        const std::size_t offset = scanner_.position();
        const double y = argument("y");
        line_to(checked({current_.x, relative_ ? current_.y + y : y}, offset));
        break;
      }
      case 'C': {
        const Vec2 c1 = point("x1", "y1");
        separate();
        cubic_to(c1);
        break;
      }
      case 'S': {
        const bool smooth = previous_ == 'C' || previous_ == 'S';
        cubic_to(smooth ? reflected() : current_);
        break;
      }
      case 'Q': {
        const Vec2 c = point("x1", "y1");
        separate();
        quad_to(c);
        break;
      }
      case 'T': {
        const bool smooth = previous_ == 'Q' || previous_ == 'T';
        quad_to(smooth ? reflected() : current_);
        break;
      }
      default:
        arc();
    }
  }

  void line_to(Vec2 p) {
    builder_.line_to(p);
    current_ = p;
  }

  void cubic_to(Vec2 c1) {
    const Vec2 c2 = point("x2", "y2");
    separate();
    const Vec2 p = point();
    builder_.cubic_to(c1, c2, p);
    handle_ = c2;
    current_ = p;
  }

  void quad_to(Vec2 c) {
    const Vec2 p = point();
    builder_.quad_to(c, p);
    handle_ = c;
    current_ = p;
  }

  void arc() {
    const std::size_t offset = scanner_.position();
    const double rx = argument("rx");
    separate();
    const double ry = argument("ry");
    separate();
    const double rotation = argument("the rotation");
    separate();
    const bool large = scanner_.flag(named("the large-arc flag"));
    separate();
    const bool sweep = scanner_.flag(named("the sweep flag"));
    separate();
    const Vec2 p = point();
    check_range({rx, ry}, {}, offset);
    builder_.arc_to({rx, ry}, rotation, large, sweep, p);
    current_ = p;
  }

  void separate() { scanner_.skip_comma_and_blanks(); }

  std::string named(std::string_view what) const {
    return fmt::format("{} of {}", what, static_cast<char>(relative_ ? command_ - 'A' + 'a' : command_));
  }

  double argument(std::string_view name) {
    if (const std::optional<double> value = scanner_.try_number()) return *value;
    scanner_.fail_expected(fmt::format("a number ({})", named(name)));
  }

  Vec2 point(std::string_view x_name = "x", std::string_view y_name = "y") {
    const std::size_t offset = scanner_.position();
    const double x = argument(x_name);
    separate();
    const double y = argument(y_name);
    return checked(relative_ ? current_ + Vec2{x, y} : Vec2{x, y}, offset);
  }

  Vec2 checked(Vec2 p, std::size_t offset) {
    check_range(p, transform_, offset);
    return p;
  }

  Vec2 reflected() { return checked(mirrored(current_, handle_), scanner_.position()); }

  Scanner scanner_;
  Transform transform_;
  PathBuilder builder_;
  Vec2 start_{};
  Vec2 current_{};
  Vec2 handle_{};        ///< the last control point, which S and T reflect
  char command_ = '\0';  ///< upper case
  char previous_ = '\0';
  bool relative_ = false;
  bool first_ = true;
};

}  // namespace

std::vector<CubicPath> read_path_data(std::string_view text, bool fill, const Transform& transform) {
  std::vector<CubicPath> paths = PathDataReader(text, transform).read();
  return fill ? close_meeting_ends(std::move(paths)) : paths;
}

std::vector<CubicPath> parse_path_data(std::string_view text, const std::string& source, bool fill,
                                       const Transform& transform) {
  try {
    return read_path_data(text, fill, transform);
  } catch (const SyntaxError& error) {
    fail_at(source, text, error.offset, error.message);
  }
}

}  // namespace v0
}  // namespace tandem
