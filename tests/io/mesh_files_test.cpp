#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "surface/solids.h"
#include "tandem/error.h"
#include "tandem/io/glb.h"
#include "tandem/io/obj.h"
#include "tandem/io/ply.h"
#include "tandem/io/stl.h"
#include "tandem/surface/tessellate.h"

namespace tandem {
namespace {

/// Takes numbers off the front of bytes, the lowest byte first.
class Bytes {
 public:
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  T take() {
    T value{};
    EXPECT_LE(at_ + sizeof(T), bytes_.size());
    if (at_ + sizeof(T) > bytes_.size()) return value;
    std::array<unsigned char, sizeof(T)> own{};
    const std::uint16_t probe = 1;
    unsigned char first = 0;
    std::memcpy(&first, &probe, 1);
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      own[first == 1 ? k : sizeof(T) - 1 - k] = static_cast<unsigned char>(bytes_[at_ + k]);
    }
    std::memcpy(&value, own.data(), sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  std::string take(std::size_t count) {
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }
  std::string take_line() {
    const std::size_t end = bytes_.find('\n', at_);
    std::string line = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

TriangleMesh mesh(Joints joints) {
  return tessellate(testing::can(), {.chord = 1e-2, .joints = joints});
}

TEST(Obj, ReadsBackEqual) {
  const TriangleMesh written = mesh(Joints::split);
  std::istringstream in(format_obj(written));
  TriangleMesh read;
  std::string line;
  std::size_t textures = 0;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    std::array<double, 3> x{};
    if (keyword == "v" || keyword == "vn") {
      words >> x[0] >> x[1] >> x[2];
      (keyword == "v" ? read.vertices : read.normals).push_back(x);
    } else if (keyword == "vt") {
      words >> x[0] >> x[1];
      EXPECT_TRUE(x[0] >= 0.0 && x[0] <= 1.0 && x[1] >= 0.0 && x[1] <= 1.0);
      ++textures;
    } else if (keyword == "f") {
      std::array<std::uint32_t, 3> triangle{};
      for (std::uint32_t& k : triangle) {
        std::array<std::uint32_t, 3> index{};
        char slash = ' ';
        words >> index[0] >> slash >> index[1] >> slash >> index[2];
        EXPECT_TRUE(index[0] == index[1] && index[1] == index[2] && slash == '/');
        k = index[0] - 1;
      }
      read.triangles.push_back(triangle);
    }
    EXPECT_FALSE(words.fail()) << line;
  }
  EXPECT_EQ(read.vertices, written.vertices);
  EXPECT_EQ(read.triangles, written.triangles);
  EXPECT_EQ(textures, written.vertices.size());
  ASSERT_EQ(read.normals.size(), written.normals.size());
  for (std::size_t i = 0; i < read.normals.data().size(); ++i) {
    EXPECT_NEAR(read.normals.data()[i], written.normals.data()[i], 1e-7);
  }
}

TEST(Obj, LeavesOutWhatIsNotThere) {
  TriangleMesh bare = mesh(Joints::welded);
  bare.normals = {};
  bare.parameters = {};
  const std::string text = format_obj(bare);
  EXPECT_EQ(text.find("vn"), std::string::npos);
  EXPECT_EQ(text.find('/'), std::string::npos);
  bare.normals = mesh(Joints::welded).normals;
  EXPECT_NE(format_obj(bare).find("//"), std::string::npos);
}

TEST(Stl, ReadsBack) {
  const TriangleMesh written = mesh(Joints::welded);
  Bytes bytes(format_stl(written));
  EXPECT_NE(bytes.take(80).substr(0, 5), "solid");
  ASSERT_EQ(bytes.take<std::uint32_t>(), written.triangles.size());
  for (const auto& triangle : written.triangles) {
    const auto normal = facet_normal(written, triangle);
    for (const double x : normal) EXPECT_NEAR(bytes.take<float>(), x, 1e-7);
    for (const std::uint32_t k : triangle) {
      for (const double x : written.vertices[k]) EXPECT_EQ(bytes.take<float>(), static_cast<float>(x));
    }
    EXPECT_EQ(bytes.take<std::uint16_t>(), 0);
  }
  EXPECT_EQ(bytes.left(), 0U);
}

TEST(Stl, RefusesWhatFloatsCannotHold) {
  TriangleMesh huge = mesh(Joints::welded);
  huge.vertices[0][1] = 1e200;
  EXPECT_THROW(static_cast<void>(format_stl(huge)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(format_glb(huge)), InvalidArgument);
  EXPECT_NO_THROW(static_cast<void>(format_ply(huge)));
}

TEST(Ply, ReadsBackEqual) {
  const TriangleMesh written = mesh(Joints::welded);
  Bytes bytes(format_ply(written));
  std::vector<std::string> head;
  while (head.empty() || head.back() != "end_header") head.push_back(bytes.take_line());
  EXPECT_EQ(head[0], "ply");
  EXPECT_EQ(head[1], "format binary_little_endian 1.0");
  EXPECT_EQ(head[3], "element vertex " + std::to_string(written.vertices.size()));
  EXPECT_EQ(head[10], "element face " + std::to_string(written.triangles.size()));
  TriangleMesh read;
  for (std::size_t i = 0; i < written.vertices.size(); ++i) {
    std::array<double, 3> p{};
    for (double& x : p) x = bytes.take<double>();
    read.vertices.push_back(p);
    for (const double x : written.normals[i]) EXPECT_EQ(bytes.take<float>(), static_cast<float>(x));
  }
  for (std::size_t i = 0; i < written.triangles.size(); ++i) {
    EXPECT_EQ(bytes.take<std::uint8_t>(), 3);
    std::array<std::uint32_t, 3> t{};
    for (std::uint32_t& k : t) k = bytes.take<std::uint32_t>();
    read.triangles.push_back(t);
  }
  EXPECT_EQ(bytes.left(), 0U);
  EXPECT_EQ(read.vertices, written.vertices);
  EXPECT_EQ(read.triangles, written.triangles);
  EXPECT_TRUE(is_watertight(read));
}

TEST(Glb, HoldsWhatItsJsonSays) {
  const TriangleMesh written = mesh(Joints::split);
  Bytes bytes(format_glb(written));
  const std::size_t size = bytes.left();
  EXPECT_EQ(bytes.take(4), "glTF");
  EXPECT_EQ(bytes.take<std::uint32_t>(), 2U);
  EXPECT_EQ(bytes.take<std::uint32_t>(), size);
  const auto length = bytes.take<std::uint32_t>();
  EXPECT_EQ(length % 4, 0U);
  EXPECT_EQ(bytes.take(4), "JSON");
  const nlohmann::json json = nlohmann::json::parse(bytes.take(length));
  const auto binary_length = bytes.take<std::uint32_t>();
  EXPECT_EQ(bytes.take(4), std::string("BIN\0", 4));
  EXPECT_EQ(bytes.left(), binary_length);
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["buffers"][0]["byteLength"], binary_length);
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto& position = json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  const auto& normal = json["accessors"][primitive["attributes"]["NORMAL"].get<std::size_t>()];
  const auto& index = json["accessors"][primitive["indices"].get<std::size_t>()];
  EXPECT_EQ(position["count"], written.vertices.size());
  EXPECT_EQ(normal["count"], written.vertices.size());
  EXPECT_EQ(index["count"], 3 * written.triangles.size());
  EXPECT_EQ(position["min"], (nlohmann::json{-1.0, -1.0, -1.0}));
  EXPECT_EQ(position["max"], (nlohmann::json{1.0, 1.0, 1.0}));
  std::size_t at = 0;
  for (const auto& view : json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"], at);
    at += view["byteLength"].get<std::size_t>();
  }
  EXPECT_EQ(at, binary_length);
  for (const double x : written.vertices.data()) EXPECT_EQ(bytes.take<float>(), static_cast<float>(x));
  for (const double x : written.normals.data()) EXPECT_EQ(bytes.take<float>(), static_cast<float>(x));
  bytes.take(written.vertices.size() * 8);  // texture coordinates
  for (const auto& t : written.triangles) {
    for (const std::uint32_t k : t) EXPECT_EQ(bytes.take<std::uint32_t>(), k);
  }
  EXPECT_EQ(bytes.left(), 0U);
  EXPECT_THROW(static_cast<void>(format_glb(TriangleMesh{})), InvalidArgument);
}

}  // namespace
}  // namespace tandem
