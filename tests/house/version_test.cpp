#include "tandem/version.h"

#include <gtest/gtest.h>

TEST(Version, HeaderLibraryAndBuildSystemAgree) {
  EXPECT_EQ(tandem::kVersion, TANDEM_PROJECT_VERSION);
  EXPECT_EQ(tandem::version(), TANDEM_PROJECT_VERSION);
}
