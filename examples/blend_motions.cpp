// Two motions in, the one half-way between them out: example_blend_motions A.csv B.csv OUT.csv
#include <cstdio>
#include <string>
#include <vector>

#include "tandem/io/csv.h"
#include "tandem/io/files.h"
#include "tandem/tandem.h"

int main(int argc, char** argv) {
  const std::vector<std::string> names(argv + 1, argv + argc);
  if (names.size() != 3) {
    std::fputs("usage: example_blend_motions A.csv B.csv OUT.csv\n", stderr);
    return 2;
  }
  try {
    const tandem::CsvTable a = tandem::parse_csv_table(tandem::read_file(names[0]), names[0]);
    const tandem::CsvTable b = tandem::parse_csv_table(tandem::read_file(names[1]), names[1]);
    const tandem::MotionMorph morph(std::vector<tandem::Curve>{a.curve, b.curve});  // matches once
    const tandem::Points half = morph.rows(0.5, 100);  // at even times, the time first
    tandem::write_file(names[2], tandem::format_csv(half, a.columns));
  } catch (const tandem::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
