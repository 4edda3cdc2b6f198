#pragma once

#include <string>

namespace tandem {
inline namespace v0 {

/// What makes a page its own.
struct Page {
  std::string title;
  std::string style;      ///< rules beside those of all pages
  std::string body;       ///< below the title
  std::string data;       ///< JSON, in the element with the id "data"
  std::string script;     ///< run with `data`, parsed, and byId(); empty: the page is at rest, without data
  std::string lead = {};  ///< the title and what stands beside it, in HTML; empty: the title alone
};

/// A self-contained page without network, in light and dark.
[[nodiscard]] std::string format_page(const Page& page);

/// A button to play, a slider `s` from 0 to 1 and its value: what kPlayScript moves. label: of the slider.
[[nodiscard]] std::string play_bar(const std::string& label, const std::string& more = {});

/// Script of pages that play: open_(film, show) starts them, pause(), setPlaying(on) and goTo(s) move them.
[[nodiscard]] std::string play_script();

}  // namespace v0
}  // namespace tandem
