// Two drawings in, an animated SVG out: example_morph_svg A.svg B.svg OUT.svg
#include <cstdio>
#include <string>
#include <vector>

#include "tandem/io/files.h"
#include "tandem/io/load.h"
#include "tandem/io/svg.h"
#include "tandem/tandem.h"

int main(int argc, char** argv) {
  const std::vector<std::string> names(argv + 1, argv + argc);
  if (names.size() != 3) {
    std::fputs("usage: example_morph_svg A.svg B.svg OUT.svg\n", stderr);
    return 2;
  }
  try {
    const std::vector<tandem::Shape> keys = {tandem::load_shape(names[0]), tandem::load_shape(names[1])};
    const tandem::PathMorph morph(keys);  // matches once
    tandem::write_file(names[2], tandem::format_animated_svg(morph, {.duration = 3.0}));
  } catch (const tandem::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
