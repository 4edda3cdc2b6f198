#include "io/svg_document.h"

#include <fmt/format.h>

#include <algorithm>

namespace tandem {
inline namespace v0 {
namespace {

constexpr std::string_view kNamespace = "http://www.w3.org/2000/svg";

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::size_t skip_blanks(std::string_view text, std::size_t i) {
  while (i < text.size() && is_blank(text[i])) ++i;
  return i;
}

/// <svg id="a">
std::string describe(const pugi::xml_node& node) {
  const std::string_view id = node.attribute("id").value();
  return id.empty() ? fmt::format("<{}>", node.name()) : fmt::format("<{} id=\"{}\">", node.name(), id);
}

/// Where the value of an attribute starts, given the offset of its element's name; npos when it is not found.
std::size_t find_value(std::string_view text, std::size_t element, std::string_view attribute) {
  const auto ends_name = [](char c) { return is_blank(c) || c == '=' || c == '>' || c == '/'; };
  std::size_t i = element;
  while (i < text.size() && !ends_name(text[i])) ++i;
  for (;;) {
    i = skip_blanks(text, i);
    const std::size_t name = i;
    while (i < text.size() && !ends_name(text[i])) ++i;
    const std::string_view found = text.substr(name, i - name);
    i = skip_blanks(text, i);
    if (found.empty() || i >= text.size() || text[i] != '=') return std::string_view::npos;
    i = skip_blanks(text, i + 1);
    if (i >= text.size() || (text[i] != '"' && text[i] != '\'')) return std::string_view::npos;
    if (found == attribute) return i + 1;
    i = text.find(text[i], i + 1);
    if (i == std::string_view::npos) return i;
    ++i;
  }
}

/// Bytes of the file behind the first `count` bytes of an attribute's value, which has its references
/// replaced and its line ends made one blank.
std::size_t raw_length(std::string_view raw, std::size_t count) {
  std::size_t i = 0;
  for (std::size_t decoded = 0; decoded < count && i < raw.size(); ++decoded) {
    if (raw[i] == '\r' && i + 1 < raw.size() && raw[i + 1] == '\n') {
      i += 2;
    } else if (raw[i] == '&') {
      const std::size_t end = raw.find(';', i);
      constexpr std::size_t kLongestReference = 10;
      const bool reference = end != std::string_view::npos && end - i < kLongestReference;
      i = reference ? end + 1 : i + 1;
    } else {
      ++i;
    }
  }
  return std::min(i, raw.size());
}

}  // namespace

SvgDocument::SvgDocument(std::string_view text, const std::string& source)
    : text_(without_bom(text)), source_(source) {
  if (text_.substr(0, 2) == "\xFE\xFF" || text_.substr(0, 2) == "\xFF\xFE") {
    fail("the file is UTF-16, expected UTF-8");
  }
  const pugi::xml_parse_result result =
      document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    fail_at(source_, text_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
            fmt::format("malformed XML: {}", result.description()));
  }
  find_prefixes();
  root_ = document_.document_element();
  if (name(root_) != "svg") fail(root_, fmt::format("expected <svg>, found <{}>", root_.name()));
  index_elements();
}

pugi::xml_node SvgDocument::find(std::string_view id) const {
  const auto found = ids_.find(id);
  return found == ids_.end() ? pugi::xml_node() : found->second;
}

std::string_view SvgDocument::name(const pugi::xml_node& node) const {
  const std::string_view qualified = node.name();
  const std::size_t colon = qualified.find(':');
  if (colon == std::string_view::npos) return qualified;
  return prefixes_.count(qualified.substr(0, colon)) != 0 ? qualified.substr(colon + 1) : std::string_view();
}

void SvgDocument::fail(const std::string& message) const {
  fail_at(source_, text_, 0, message);
}

void SvgDocument::fail(const pugi::xml_node& node, const std::string& message) const {
  const std::ptrdiff_t offset = node.offset_debug();
  fail_at(source_, text_, offset > 0 ? static_cast<std::size_t>(offset) - 1 : 0, message);
}

void SvgDocument::fail(const pugi::xml_node& node, const char* attribute, const SyntaxError& error) const {
  fail_at(source_, text_, offset_in_file(node, attribute, error.offset),
          fmt::format("{}, attribute {}: {}", describe(node), attribute, error.message));
}

template <typename Function>
void SvgDocument::for_each_element(Function f) const {
  const pugi::xml_node root = document_.document_element();
  for (pugi::xml_node node = root; node;) {
    f(node);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node != root && !node.next_sibling()) node = node.parent();
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
}

void SvgDocument::find_prefixes() {
  constexpr std::string_view kDeclaration = "xmlns:";
  bool svg_is_other = false;
  for_each_element([&](const pugi::xml_node& node) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string_view declared = attribute.name();
      if (declared.substr(0, kDeclaration.size()) != kDeclaration) continue;
      const std::string_view prefix = declared.substr(kDeclaration.size());
      const std::string_view uri = attribute.value();
      // Adobe's files write the namespace as a reference to an entity, which stays as it is here.
      if (uri == kNamespace || uri == "&ns_svg;") {
        prefixes_.insert(prefix);
      } else if (prefix == "svg") {
        svg_is_other = true;
      }
    }
  });
  if (!svg_is_other) prefixes_.insert("svg");
}

void SvgDocument::index_elements() {
  for_each_element([this](const pugi::xml_node& node) {
    if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace(id.value(), node);
    if (name(node) == "style") styles_.push_back(node);
  });
}

std::size_t SvgDocument::offset_in_file(const pugi::xml_node& node, std::string_view attribute,
                                        std::size_t offset) const {
  const std::ptrdiff_t element = node.offset_debug();
  if (element < 0) return 0;
  const auto start = static_cast<std::size_t>(element);
  const std::size_t value = find_value(text_, start, attribute);
  if (value == std::string_view::npos) return start;
  return value + raw_length(text_.substr(value), offset);
}

}  // namespace v0
}  // namespace tandem
