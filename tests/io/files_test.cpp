#include "tandem/io/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>

#include "io/scratch_directory.h"
#include "tandem/error.h"

namespace {

namespace fs = std::filesystem;
using tandem::read_file;
using tandem::write_file;

class Files : public tandem::test::ScratchDirectory {
 protected:
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }
};

template <typename Action>
std::string io_error(Action action) {
  try {
    action();
  } catch (const tandem::IoError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(Files, ReadsBackWhatItWrote) {
  std::string content(200000, 'x');
  content[777] = '\0';
  write_file(path("a.bin"), content);
  EXPECT_EQ(read_file(path("a.bin")), content);
  write_file(path("a.bin"), "");
  EXPECT_EQ(read_file(path("a.bin")), "");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, TakesTheModeOfTheUmaskOrOfTheFileItReplaces) {
  const mode_t before = umask(0027);
  write_file(path("a"), "x");
  umask(before);
  EXPECT_EQ(static_cast<int>(fs::status(path("a")).permissions()), 0640);
  fs::permissions(path("a"), fs::perms{0604});
  write_file(path("a"), "y");
  EXPECT_EQ(static_cast<int>(fs::status(path("a")).permissions()), 0604);
}

TEST_F(Files, WritesThroughLinks) {
  write_file(path("target"), "old");
  fs::create_symlink("target", directory_ / "link");
  write_file(path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(directory_ / "link"));
  EXPECT_EQ(read_file(path("target")), "new");
  fs::create_symlink("later", directory_ / "dangling");
  write_file(path("dangling"), "x");
  EXPECT_EQ(read_file(path("later")), "x");
}

TEST_F(Files, SaysWhyAFileCannotBeRead) {
  EXPECT_EQ(io_error([&] { (void)read_file(path("none")); }),
            "cannot read " + path("none") + ": No such file or directory");
  EXPECT_EQ(io_error([&] { (void)read_file(path("")); }), "cannot read " + path("") + ": Is a directory");
}

TEST_F(Files, GivesUpOnFilesThatNoDrawingIsAsLargeAs) {
  write_file(path("large"), "x");
  fs::resize_file(path("large"), (std::uintmax_t{256} << 20U) + 1);
  EXPECT_EQ(io_error([&] { (void)read_file(path("large")); }),
            "cannot read " + path("large") + ": it is larger than 256 MiB");
}

TEST_F(Files, LeavesNothingBehindWhenItCannotWrite) {
  EXPECT_EQ(io_error([&] { write_file(path("no/a"), "x"); }),
            "cannot write " + path("no/a") + ": No such file or directory");
  fs::create_directory(directory_ / "d");
  EXPECT_EQ(io_error([&] { write_file(path("d"), "x"); }), "cannot write " + path("d") + ": Is a directory");
  EXPECT_EQ(entries(), 1U);
  EXPECT_TRUE(fs::is_empty(directory_ / "d"));
  EXPECT_EQ(io_error([] { write_file("/dev/full", "x"); }),
            "cannot write /dev/full: No space left on device");
}

TEST_F(Files, WritesToDevices) {
  EXPECT_NO_THROW(write_file("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, WritesPieceByPiece) {
  int piece = 0;
  const auto three = [&]() -> std::optional<std::string> {
    if (piece == 3) return std::nullopt;
    return std::to_string(piece++);
  };
  put(".tandem-a", "left behind by a process that was killed, and longer");
  fs::create_symlink("a", directory_ / "link");
  write_file(path("link"), three);
  EXPECT_EQ(read_file(path("a")), "012");
  EXPECT_TRUE(fs::is_symlink(directory_ / "link"));
  fs::permissions(path("a"), fs::perms{0604});
  piece = 1;
  write_file(path("a"), three);
  EXPECT_EQ(read_file(path("a")), "12");
  EXPECT_EQ(static_cast<int>(fs::status(path("a")).permissions()), 0604);
  EXPECT_EQ(entries(), 2U);
}

TEST_F(Files, LeavesNothingBehindWhenAPieceCannotBeMade) {
  put("a", "before");
  int piece = 0;
  const auto broken = [&]() -> std::optional<std::string> {
    if (piece++ == 2) throw tandem::InvalidArgument("no more");
    return "x";
  };
  EXPECT_THROW(write_file(path("a"), broken), tandem::InvalidArgument);
  EXPECT_EQ(read_file(path("a")), "before");
  EXPECT_EQ(io_error([&] { write_file("/dev/null", broken); }), "cannot write /dev/null: it is not a file");
  EXPECT_EQ(entries(), 1U);
}

}  // namespace
