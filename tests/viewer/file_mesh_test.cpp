// Meshes of files: where their points lie, which way they face, what colours they have, and how many triangles are left.
#include "viewer/file_mesh.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace alembert {
namespace {

namespace fs = std::filesystem;

class FileMeshes : public testing::Test {
 protected:
  FileMeshes() : folder_(fs::temp_directory_path() / ("alembert_file_meshes_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~FileMeshes() override { fs::remove_all(folder_); }

  /// The meshes of a file beside a description.
  std::vector<ColoredMesh> meshes(const std::string& name, const std::string& text,
                                  const std::vector<double>& scale = {1, 1, 1}) const {
    std::ofstream(folder_ / name) << text;
    return named(name, scale);
  }
  std::vector<ColoredMesh> named(const std::string& name,
                                 const std::vector<double>& scale = {1, 1, 1}) const {
    Shape shape;
    shape.kind = ShapeKind::mesh;
    shape.file = name;
    shape.sizes = scale;
    shape.where = {std::make_shared<const SourceText>(SourceText{(folder_ / "arm.yaml").string(), ""}), 1, 1};
    return file_meshes(shape);
  }

  fs::path folder_;
};

Eigen::AlignedBox3f box_of(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : mesh.positions) box.extend(point);
  return box;
}

/// Whether each triangle faces the side that its normals do.
void expect_facing(const Mesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f side =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (const auto k : {a, b, c}) {
      EXPECT_GT(side.dot(mesh.normals[k]), 0);
      EXPECT_NEAR(mesh.normals[k].norm(), 1, 1e-6);
    }
  }
}

/// A tetrahedron with three edges along the axes.
const std::string kTetrahedron = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST_F(FileMeshes, OfObj) {
  const auto found = meshes("tetrahedron.obj", kTetrahedron);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].mesh.triangles.size(), 4u);
  EXPECT_FLOAT_EQ(static_cast<float>(volume(found[0].mesh)), 4);
  EXPECT_EQ(box_of(found[0].mesh).max(), Eigen::Vector3f(2, 3, 4));
  EXPECT_FALSE(found[0].color);
  expect_facing(found[0].mesh);
}

TEST_F(FileMeshes, AreScaledAndMirrored) {
  const Mesh mesh = meshes("tetrahedron.OBJ", kTetrahedron, {0.5, 1, -2}).at(0).mesh;
  EXPECT_FLOAT_EQ(static_cast<float>(volume(mesh)), 4);
  EXPECT_EQ(box_of(mesh).min(), Eigen::Vector3f(0, 0, -8));
  expect_facing(mesh);
}

/// Lengths in centimetres, z up, a node that is shifted and turned, two colours.
TEST_F(FileMeshes, OfColladaHaveUnitsNodesAndColours) {
  const auto effect = [](const std::string& id, const std::string& color) {
    return "<effect id=\"" + id + "\"><profile_COMMON><technique sid=\"c\"><lambert><diffuse><color>" +
           color + " 1</color></diffuse></lambert></technique></profile_COMMON></effect>";
  };
  const auto triangles = [](const std::string& material, const std::string& indices) {
    return "<triangles material=\"" + material +
           "\" count=\"2\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" + indices +
           "</p></triangles>";
  };
  const auto found =
      meshes("two.dae", R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_effects>)" + effect("re", "1 0 0") +
                            effect("be", "0 0 1") + R"(</library_effects>
<library_materials><material id="r"><instance_effect url="#re"/></material><material id="b"><instance_effect url="#be"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 100 0 0 0 200 0 0 0 300</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)" +
                            triangles("red", "0 2 1 0 1 3") + triangles("blue", "0 3 2 1 2 3") + R"(
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><translate>0 0 1000</translate><rotate>0 0 1 90</rotate>
<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="red" target="#r"/><instance_material symbol="blue" target="#b"/></technique_common></bind_material></instance_geometry>
</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
  ASSERT_EQ(found.size(), 2u);
  Eigen::AlignedBox3f box;
  double inside = 0;
  for (const ColoredMesh& each : found) {
    box.extend(box_of(each.mesh));
    inside += volume(each.mesh);
    ASSERT_TRUE(each.color);
    expect_facing(each.mesh);
  }
  EXPECT_EQ(*found[0].color, (Color{1, 0, 0}));
  EXPECT_EQ(*found[1].color, (Color{0, 0, 1}));
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3f(-2, 0, 10), 1e-5f)) << box.min().transpose();
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3f(0, 1, 13), 1e-5f)) << box.max().transpose();
  EXPECT_NEAR(inside, 1, 1e-4);
}

TEST_F(FileMeshes, WithManyTrianglesKeepTheirShapeWithFewer) {
  // A sphere of 80,000 triangles, as STL has them: each by itself.
  std::string text = "solid ball\n";
  constexpr int kRings = 200, kSides = 200;
  const auto point = [](int i, int j) {
    const double a = M_PI * i / kRings, b = 2 * M_PI * j / kSides;
    return Eigen::Vector3d(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
  };
  const auto facet = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Eigen::Vector3d& v : {a, b, c})
      text += "vertex " + std::to_string(v.x()) + ' ' + std::to_string(v.y()) + ' ' + std::to_string(v.z()) +
              '\n';
    text += "endloop\nendfacet\n";
  };
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSides; ++j) {
      facet(point(i, j), point(i + 1, j), point(i + 1, j + 1));
      facet(point(i, j), point(i + 1, j + 1), point(i, j + 1));
    }
  const auto found = meshes("ball.stl", text + "endsolid ball\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LE(found[0].mesh.triangles.size(), 16000u);
  EXPECT_GT(found[0].mesh.triangles.size(), 500u);
  EXPECT_NEAR(volume(found[0].mesh), 4.0 / 3 * M_PI, 0.05);
  double worst = 0;
  for (std::size_t i = 0; i < found[0].mesh.positions.size(); ++i)
    worst = std::max(worst, 1.0 - static_cast<double>(
                                      found[0].mesh.normals[i].dot(found[0].mesh.positions[i].normalized())));
  EXPECT_LT(worst, 0.01);  // smooth
}

TEST_F(FileMeshes, ThatCannotBeReadSayWhy) {
  EXPECT_THROW(named("none.stl"), std::runtime_error);
  EXPECT_THROW(meshes("text.stl", "no mesh"), std::runtime_error);
  EXPECT_THROW(meshes("empty.obj", ""), std::runtime_error);
  EXPECT_THROW(named(""), std::runtime_error);
  EXPECT_THROW(named("."), std::runtime_error);
}

}  // namespace
}  // namespace alembert
