#include <fmt/format.h>

#include "tandem/version.h"

int main() { fmt::print("tandem {}\n", tandem::version()); }
