#include "morph_figures.h"

#include <vector>

#include "animals.h"
#include "sheet.h"
#include "tandem/io/load.h"
#include "tandem/morph/morph.h"

namespace tandem::figures {

namespace {

const std::vector<double> kTimes = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};

Curve animal(const std::string& name) {
  return load_shape("examples/data/" + name + ".svg").contours.front();
}

std::vector<Shape> shapes_of(const Morph& morph, const std::vector<double>& times) {
  std::vector<Shape> shapes;
  shapes.reserve(times.size());
  for (double s : times) shapes.push_back(morph.at(s));
  return shapes;
}

std::vector<Shape> matched(const Curve& a, const Curve& b, const MatchOptions& options) {
  return shapes_of(Morph(a, b, match(a, b, options)), kTimes);
}

/// Figure 8: shapes that are quite different.
std::string metamorphosis() {
  const Curve a = animal("camel");
  const Curve b = animal("cheetah");
  Sheet sheet(150, 130);
  sheet.add_row("Naive", naive_in_betweens(a, b, kTimes));
  sheet.add_row("m = 100, piecewise linear, 20 coefficients", matched(a, b, paper_options(100, 2, 20)));
  sheet.add_row("Matched elastically", matched(a, b, {}));
  return sheet.svg();
}

/// Figure 11: how many nodes, and how smooth a v(u).
std::string parameters() {
  const Curve a = animal("cheetah");
  const Curve b = animal("hamster");
  Sheet sheet(150, 80);
  sheet.add_row("Naive", naive_in_betweens(a, b, kTimes));
  sheet.add_row("m = 100, piecewise linear, 20 coefficients", matched(a, b, paper_options(100, 2, 20)));
  sheet.add_row("m = 300, piecewise quadratic, 50 coefficients", matched(a, b, paper_options(300, 3, 50)));
  sheet.add_row("m = 20, piecewise linear, 10 coefficients", matched(a, b, paper_options(20, 2, 10)));
  return sheet.svg();
}

/// Figure 13: one outline, edited; and a third key frame.
std::string key_frames() {
  const Curve deer = animal("deer");
  const Curve a = digitised(edited_deer(deer, 0.5, 0.0));
  const Curve b = digitised(deer);
  const Curve c = digitised(edited_deer(deer, 1.0, -0.5));
  MorphOptions options;
  options.match = paper_options(100, 2, 20);
  options.match.rotate = false;
  const std::vector<Shape> keys{{{a}}, {{b}}, {{c}}};
  Sheet sheet(120, 150);
  sheet.add_row("Naive", naive_in_betweens(a, b, kTimes));
  sheet.add_row("m = 100, piecewise linear, 20 coefficients", matched(a, b, options.match));
  sheet.add_row("Through a third key frame",
                shapes_of(Morph(keys, options), {0.0, 0.25, 0.5, 0.65, 0.8, 1.0}));
  return sheet.svg();
}

}  // namespace

std::map<std::string, std::string> morph_figures() {
  return {
      {"figure-8.svg", metamorphosis()}, {"figure-11.svg", parameters()}, {"figure-13.svg", key_frames()}};
}

}  // namespace tandem::figures
