#include "look_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "names.h"

namespace cli {
namespace {

using tandem::ViewBox;

// What an outline may lie outside of a view box without anybody's noticing, as a share of the box.
constexpr double kUnseen = 1e-3;

std::string text_of(const ViewBox& box) {
  return fmt::format("{:g} {:g} {:g} {:g}", box.x, box.y, box.width, box.height);
}

bool holds(const ViewBox& view, const tandem::Box& box) {
  const double slack = kUnseen * std::max(view.width, view.height);
  return box.lo[0] >= view.x - slack && box.lo[1] >= view.y - slack &&
         box.hi[0] <= view.x + view.width + slack && box.hi[1] <= view.y + view.height + slack;
}

void say_view_boxes(const Messages& messages, const std::vector<tandem::Drawing>& drawings,
                    const tandem::Look& look) {
  std::string boxes;
  bool differ = false;
  for (const tandem::Drawing& drawing : drawings) {
    if (!drawing.view_box) continue;
    differ = differ || *drawing.view_box != *look.view_box;
    boxes += (boxes.empty() ? "" : ", ") + text_of(*drawing.view_box);
  }
  if (differ) {
    messages.note(fmt::format("the view boxes differ ({}): what comes out shows {}, which holds all", boxes,
                              text_of(*look.view_box)));
  }
}

}  // namespace

void say_look(const Messages& messages, const Command& command, const std::vector<tandem::Drawing>& drawings,
              const tandem::Look& look, const tandem::PathMorph& morph) {
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    if (!drawings[i].missed.empty()) {
      messages.note(fmt::format("{} is drawn without {}", short_name(command.inputs[i]),
                                fmt::join(drawings[i].missed, ", ")));
    }
    if (!drawings[i].several_styles) continue;
    messages.note(fmt::format(
        "{} is drawn in several styles, a morph in one: that of its largest area; FILE.svg#ID takes a part",
        short_name(command.inputs[i])));
  }
  if (!look.view_box) return;
  say_view_boxes(messages, drawings, look);
  const bool keys_inside = std::all_of(drawings.begin(), drawings.end(), [&](const tandem::Drawing& drawing) {
    return holds(*look.view_box, tandem::bounding_box(drawing.shape));
  });
  if (keys_inside && !holds(*look.view_box, morph.box())) {
    messages.note("in-betweens reach beyond the view box, and are cut off there");
  }
}

}  // namespace cli
