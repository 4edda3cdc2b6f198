#include "io/svg_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "io/svg_document.h"
#include "io/svg_shapes.h"
#include "io/svg_style.h"
#include "io/svg_values.h"
#include "io/svg_viewport.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Groups within groups, and uses of uses. Drawing programs reach twenty; the limit keeps the recursion
/// short.
constexpr int kDeepestNesting = 256;

/// How many elements <use> may draw, and how many bytes of path data, a multiple of the file's size: a file
/// of a few lines can otherwise ask for billions.
constexpr std::size_t kMostUsedElements = 100000;
constexpr std::size_t kUsedDataShare = 8;
constexpr std::size_t kUsedDataAtLeast = std::size_t{4} << 20U;

/// What an element is drawn in.
struct Context {
  Transform transform;
  SvgStyle style;
  SvgViewport viewport;
};

/// Walks the tree as a renderer does and collects the outlines.
class SvgReader {
 public:
  /// wanted: only what is drawn inside the element with that id.
  SvgReader(const SvgDocument& document, std::optional<std::string_view> wanted)
      : document_(document), sheet_(document), wanted_(wanted) {}

  SvgPicture read() {
    draw(document_.root(), {}, 0);
    if (wanted_ && drawn_.empty()) draw_by_itself();
    // Icon sets put an unpainted square behind their icons to give them a size. It is no part of the drawing,
    // unless there is nothing else.
    const auto painted = [](const Drawn& drawn) { return drawn.painted; };
    const bool any = std::any_of(drawn_.begin(), drawn_.end(), painted);
    if (!sheet_.unread_selector().empty()) miss(fmt::format("styles for \"{}\"", sheet_.unread_selector()));
    SvgPicture picture{{}, shown_, missed_};
    for (Drawn& drawn : drawn_) {
      if (drawn.painted || !any) picture.elements.push_back(std::move(drawn.element));
    }
    return picture;
  }

 private:
  struct Drawn {
    SvgElement element;
    bool painted = true;
  };

  /// Sprites keep their icons in <defs> and <symbol>, where they are drawn only when used.
  void draw_by_itself() {
    const pugi::xml_node node = document_.find(*wanted_);
    if (!node) document_.fail(fmt::format("there is no element with the id \"{}\"", *wanted_));
    Context context;
    enter_viewport(document_.root(), context, true, {});
    context.style.inherit(sheet_.cascade(document_.root(), "svg"), document_);
    used_.push_back(node);
    if (document_.name(node) == "symbol") {
      draw_symbol(node, context, 0, {});
    } else {
      draw(node, context, 0);
    }
    if (drawn_.empty())
      document_.fail(node, fmt::format("the element with the id \"{}\" draws nothing", *wanted_));
  }

  void draw(const pugi::xml_node& node, Context context, int depth) {
    if (node.type() != pugi::node_element) return;
    const std::string_view name = document_.name(node);
    const bool shape = is_svg_shape(name);
    if (!shape && !is_container(name) && name != "use") return miss_element(name);
    count_use(node, shape);
    if (depth > kDeepestNesting) {
      document_.fail(node, fmt::format("elements are nested more than {} levels deep", kDeepestNesting));
    }
    const Declarations declarations = sheet_.cascade(node, name);
    if (is(declarations, SvgProperty::display, "none")) return;
    context.style.inherit(declarations, document_);
    context.transform = context.transform * own_transform(node, declarations);
    const bool wanted = wanted_ && *wanted_ == node.attribute("id").value();
    inside_wanted_ += wanted ? 1 : 0;
    if (!wanted_ || inside_wanted_ > 0) {
      for (const std::string_view words : missed_by(declarations)) miss(std::string(words));
    }
    if (shape) {
      draw_shape(node, name, context);
    } else if (name == "use") {
      draw_use(node, context, depth);
    } else if (name == "switch") {
      draw_switch(node, context, depth);
    } else if (name != "svg" || enter_viewport(node, context, depth == 0 && node == document_.root(), {})) {
      draw_children(node, context, depth);
    }
    inside_wanted_ -= wanted ? 1 : 0;
  }

  void miss_element(std::string_view name) {
    if (name != "text" && name != "image" && name != "foreignObject") return;
    if (!wanted_ || inside_wanted_ > 0) miss(fmt::format("<{}>", name));
  }

  void miss(std::string words) {
    if (std::find(missed_.begin(), missed_.end(), words) == missed_.end())
      missed_.push_back(std::move(words));
  }

  static bool is_container(std::string_view name) {
    constexpr std::array<std::string_view, 4> kContainers = {"g", "svg", "a", "switch"};
    return std::find(kContainers.begin(), kContainers.end(), name) != kContainers.end();
  }

  static bool is(const Declarations& declarations, SvgProperty property, std::string_view value) {
    const auto& declaration = declarations[static_cast<std::size_t>(property)];
    return declaration && declaration->value == value;
  }

  void draw_children(const pugi::xml_node& node, const Context& context, int depth) {
    for (const pugi::xml_node& child : node.children()) draw(child, context, depth + 1);
  }

  /// The first child that this program would understand; languages are not asked for.
  void draw_switch(const pugi::xml_node& node, const Context& context, int depth) {
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view name = document_.name(child);
      const bool drawable = is_svg_shape(name) || is_container(name) || name == "use";
      if (!drawable || !std::string_view(child.attribute("requiredExtensions").value()).empty()) continue;
      draw(child, context, depth + 1);
      return;
    }
  }

  void draw_shape(const pugi::xml_node& node, std::string_view name, const Context& context) {
    if (!context.style.visible || (wanted_ && inside_wanted_ == 0)) return;
    const Style style = context.style.resolved(line_width(context));
    const bool fill = context.style.style.fill.paints() && name != "line";
    const std::vector<CubicPath> paths =
        read_svg_shape(document_, node, name, fill, context.transform, context.viewport);
    if (paths.empty()) return;
    SvgElement element{node.attribute("id").value(), to_shape(paths, context.style.fill_rule), {}};
    // A line has no inside.
    if (style.stroke.paints() || (fill && style.fill.paints())) element.style = style;
    const bool painted = element.style || name == "line";
    drawn_.push_back({std::move(element), painted});
  }

  /// In the units of the drawing; a transform that is no similarity widens lines by the root of what it does
  /// to areas.
  static double line_width(const Context& context) {
    const Transform& map = context.transform;
    const double scale = std::sqrt(std::fabs(map.a * map.d - map.b * map.c));
    return scale * length_in(context.style.stroke_width, SvgAxis::diagonal, context.viewport).value_or(0.0);
  }

  void draw_use(const pugi::xml_node& node, Context context, int depth) {
    const pugi::xml_node target = use_target(node);
    if (!target) return;  // as a renderer does: another file, or an id that is not there
    if (std::find(used_.begin(), used_.end(), target) != used_.end()) {
      document_.fail(node, fmt::format("<use> of \"{}\" inside itself", target.attribute("id").value()));
    }
    const double x = read_length(document_, node, "x", SvgAxis::x, context.viewport).value_or(0.0);
    const double y = read_length(document_, node, "y", SvgAxis::y, context.viewport).value_or(0.0);
    context.transform = context.transform * Transform::translate(x, y);
    used_.push_back(target);
    const std::string_view name = document_.name(target);
    if (name == "symbol" || name == "svg") {
      draw_symbol(target, context, depth + 1, node);
    } else {
      draw(target, context, depth + 1);
    }
    used_.pop_back();
  }

  [[nodiscard]] pugi::xml_node use_target(const pugi::xml_node& node) const {
    const pugi::xml_attribute plain = node.attribute("href");
    const std::string_view reference = plain ? plain.value() : node.attribute("xlink:href").value();
    return reference.substr(0, 1) == "#" ? document_.find(reference.substr(1)) : pugi::xml_node();
  }

  /// A <symbol>, or an <svg>, whose size a <use> may override.
  void draw_symbol(const pugi::xml_node& symbol, Context context, int depth, const pugi::xml_node& use) {
    const Declarations declarations = sheet_.cascade(symbol, document_.name(symbol));
    if (is(declarations, SvgProperty::display, "none")) return;
    context.style.inherit(declarations, document_);
    context.transform = context.transform * own_transform(symbol, declarations);
    const bool wanted = wanted_ && *wanted_ == symbol.attribute("id").value();
    inside_wanted_ += wanted ? 1 : 0;
    if (enter_viewport(symbol, context, !use, use)) draw_children(symbol, context, depth);
    inside_wanted_ -= wanted ? 1 : 0;
  }

  /// False: it is of no size and draws nothing.
  bool enter_viewport(const pugi::xml_node& node, Context& context, bool outermost,
                      const pugi::xml_node& use) {
    if (!outermost) return enter_inner_viewport(document_, node, use, context.transform, context.viewport);
    shown_ = enter_outermost_viewport(document_, node, context.viewport);
    return true;
  }

  [[nodiscard]] Transform own_transform(const pugi::xml_node& node, const Declarations& declarations) const {
    const auto& declaration = declarations[static_cast<std::size_t>(SvgProperty::transform)];
    if (!declaration) return {};
    const pugi::xml_attribute attribute = node.attribute("transform");
    try {
      return parse_transform(attribute ? attribute.value() : declaration->value);
    } catch (const SyntaxError& error) {
      document_.fail(node, attribute ? "transform" : "style", {attribute ? error.offset : 0, error.message});
    }
  }

  /// Keeps what <use> multiplies within bounds.
  void count_use(const pugi::xml_node& node, bool shape) {
    if (used_.empty()) return;
    if (++used_elements_ > kMostUsedElements) {
      document_.fail(node, fmt::format("<use> draws more than {} elements", kMostUsedElements));
    }
    if (!shape) return;
    for (const char* attribute : {"d", "points"})
      used_data_ += std::string_view(node.attribute(attribute).value()).size();
    if (used_data_ > std::max(kUsedDataAtLeast, kUsedDataShare * document_.size())) {
      document_.fail(node, fmt::format("<use> draws {} bytes of path data, too many for a file of {}",
                                       used_data_, document_.size()));
    }
  }

  const SvgDocument& document_;
  StyleSheet sheet_;
  std::optional<std::string_view> wanted_;
  int inside_wanted_ = 0;
  std::vector<Drawn> drawn_;
  std::optional<ViewBox> shown_;
  std::vector<std::string> missed_;
  std::vector<pugi::xml_node> used_;  ///< what the <use> elements around the current one refer to
  std::size_t used_elements_ = 0;
  std::size_t used_data_ = 0;
};

}  // namespace

SvgPicture read_svg(std::string_view text, const std::string& source) {
  const SvgDocument document(text, source);
  SvgPicture picture = SvgReader(document, std::nullopt).read();
  if (picture.elements.empty()) {
    document.fail("there is nothing drawable in it; of a set of symbols, name one: FILE.svg#ID");
  }
  return picture;
}

SvgPicture read_svg_part(std::string_view text, const std::string& id, const std::string& source) {
  const SvgDocument document(text, source);
  return SvgReader(document, id).read();
}

std::vector<SvgElement> parse_svg(std::string_view text, const std::string& source) {
  return read_svg(text, source).elements;
}

std::vector<SvgElement> parse_svg_part(std::string_view text, const std::string& id,
                                       const std::string& source) {
  return read_svg_part(text, id, source).elements;
}

}  // namespace v0
}  // namespace tandem
