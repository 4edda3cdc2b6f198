#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "io/text_position.h"

namespace tandem {
inline namespace v0 {

/// The XML tree of an SVG document, and where in the text everything stands.
class SvgDocument {
 public:
  /// `text` and `source` must outlive the document. @throws ParseError malformed XML, or no <svg> in it
  SvgDocument(std::string_view text, const std::string& source);

  [[nodiscard]] pugi::xml_node root() const noexcept { return root_; }
  [[nodiscard]] std::size_t size() const noexcept { return text_.size(); }
  /// The element with that id, the first of several; an empty node without one.
  [[nodiscard]] pugi::xml_node find(std::string_view id) const;
  [[nodiscard]] const std::vector<pugi::xml_node>& style_elements() const noexcept { return styles_; }

  /// The element's name when it is one of SVG's, without prefix; empty otherwise. A prefix means SVG when the
  /// document says so anywhere: scopes are not told apart.
  [[nodiscard]] std::string_view name(const pugi::xml_node& node) const;

  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& message) const;
  /// An error inside the value of an attribute.
  [[noreturn]] void fail(const pugi::xml_node& node, const char* attribute, const SyntaxError& error) const;

 private:
  template <typename Function>
  void for_each_element(Function f) const;
  void find_prefixes();
  void index_elements();
  [[nodiscard]] std::size_t offset_in_file(const pugi::xml_node& node, std::string_view attribute,
                                           std::size_t offset) const;

  std::string_view text_;
  const std::string& source_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::unordered_map<std::string_view, pugi::xml_node> ids_;
  std::vector<pugi::xml_node> styles_;
  std::unordered_set<std::string_view> prefixes_;  ///< those that stand for SVG
};

}  // namespace v0
}  // namespace tandem
