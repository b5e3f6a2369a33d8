// Meshes of published robots: where they are found, and what a description calls them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "import/urdf/mesh_files.hpp"
#include "urdf/imported.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A package of a robot and its meshes, in a folder that goes with it.
class PublishedMeshes : public testing::Test {
 protected:
  PublishedMeshes()
      : root_(fs::canonical(fs::temp_directory_path()) / ("alembert_meshes_" + std::to_string(getpid()))) {
    put("arm_description/package.xml", "<package/>");
    for (const char* file : {"arm_description/meshes/link.stl", "arm_description/urdf/near.stl", "secret.stl",
                             "other/gripper/meshes/finger.stl", "arm_description/models/link.stl"})
      put(file, "solid x\nendsolid x\n");
  }
  ~PublishedMeshes() override { fs::remove_all(root_); }

  std::string put(const std::string& name, const std::string& text) const {
    const fs::path path = root_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path.string();
  }
  std::string imported(const std::string& file, const DescribeOptions& options = {}) const {
    return test::import(read_source(file), options).text;
  }
  std::string urdf(const std::string& mesh) const {
    return put("arm_description/urdf/arm.urdf", R"(<robot name="arm"><link name="base"/>
  <link name="link"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename=")" + mesh + R"(" scale="0.001 0.001 -0.001"/></geometry></visual></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="link"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>)");
  }

  fs::path root_;
};

TEST_F(PublishedMeshes, OfUrdfAreFoundInItsPackage) {
  const std::string text = imported(urdf("package://arm_description/meshes/link.stl"));
  EXPECT_THAT(text, HasSubstr("../meshes/link.stl"));
  EXPECT_THAT(text, HasSubstr("0.001, 0.001, -0.001"));
  EXPECT_THAT(imported(urdf("../meshes/link.stl")), HasSubstr("../meshes/link.stl"));
  EXPECT_THAT(imported(urdf("near.stl")), HasSubstr("file: near.stl"));
  EXPECT_THAT(imported(urdf("file://" + (root_ / "arm_description/urdf/near.stl").string())),
              HasSubstr("file: near.stl"));
}

TEST_F(PublishedMeshes, AreNamedFromTheFolderOfTheDescription) {
  DescribeOptions options;
  options.folder = (root_ / "elsewhere").string();
  EXPECT_THAT(imported(urdf("near.stl"), options), HasSubstr("../arm_description/urdf/near.stl"));
}

/// A frame has no geometry of its own: its shapes are on the body that it is on.
TEST_F(PublishedMeshes, OfFramesAreDrawnWithTheirBodies) {
  const std::string text =
      imported(put("arm_description/urdf/ball.urdf", R"(<robot name="arm"><link name="base"/>
  <link name="link"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="ball"><visual><origin xyz="0 0 5"/><geometry><mesh filename="near.stl"/></geometry></visual>
    <visual><geometry><sphere radius="0.125"/></geometry></visual></link>
  <joint name="tip" type="fixed"><origin xyz="7 0 0"/><parent link="link"/><child link="ball"/></joint>
  <joint name="turn" type="continuous"><parent link="base"/><child link="link"/></joint></robot>)"));
  EXPECT_THAT(text, HasSubstr(R"(    geometry:
      - mesh:
          file: near.stl
        transform:
          - translate: [7, 0, 0]
          - translate: [0, 0, 5]
      - sphere: 0.125
        transform:
          - translate: [7, 0, 0]
frames:
  - name: ball
    body: link)"));
}

TEST_F(PublishedMeshes, OfOtherPackagesAreFoundByInclude) {
  const std::string file = urdf("package://gripper/meshes/finger.stl");
  EXPECT_THAT(imported(file), Not(HasSubstr("mesh")));
  DescribeOptions options;
  for (const char* folder : {"other", "other/gripper"}) {
    options.include_folders = {(root_ / folder).string()};
    EXPECT_THAT(imported(file, options), HasSubstr("../../other/gripper/meshes/finger.stl"));
  }
}

TEST_F(PublishedMeshes, ThatAreNotThereOrLieOutsideChangeNothing) {
  const std::string without = imported(urdf("package://arm_description/meshes/none.stl"));
  for (const std::string name :
       {"../../secret.stl", "package://arm_description/../secret.stl", "package://nobody/meshes/link.stl", "",
        "package://", "package:///meshes/link.stl", "http://example.org/link.stl", "/etc/passwd",
        "near.stl/"})
    EXPECT_EQ(imported(urdf(name)), without) << name;
  EXPECT_THAT(without, Not(HasSubstr("geometry")));
}

TEST_F(PublishedMeshes, OfMjcfAndSdf) {
  const std::string mjcf = put("arm_description/arm.mjcf", R"(<mujoco><compiler meshdir="models"/>
  <asset><mesh name="link" file="link.stl" scale="2 2 2"/><mesh name="gone" file="gone.stl"/></asset>
  <worldbody><body><joint type="hinge"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
    <geom type="mesh" mesh="link" rgba="1 0 0 1"/><geom type="mesh" mesh="gone"/></body></worldbody></mujoco>)");
  const std::string of_mjcf = imported(mjcf);
  EXPECT_THAT(of_mjcf, HasSubstr("models/link.stl"));
  EXPECT_THAT(of_mjcf, HasSubstr("[2, 2, 2]"));
  EXPECT_THAT(of_mjcf, Not(HasSubstr("gone")));

  const std::string sdf = put("arm_description/arm.sdf", R"(<sdf version="1.9"><model name="arm">
  <link name="base"/><link name="link"><inertial><mass>1</mass></inertial>
    <visual name="a"><geometry><mesh><uri>models/link.stl</uri><scale>3 3 3</scale></mesh></geometry></visual>
    <visual name="b"><geometry><mesh><uri>models/gone.stl</uri></mesh></geometry></visual></link>
  <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
  <joint name="turn" type="revolute"><parent>base</parent><child>link</child><axis><xyz>0 0 1</xyz></axis></joint>
</model></sdf>)");
  const std::string of_sdf = imported(sdf);
  EXPECT_THAT(of_sdf, HasSubstr("models/link.stl"));
  EXPECT_THAT(of_sdf, HasSubstr("[3, 3, 3]"));
  EXPECT_THAT(of_sdf, Not(HasSubstr("gone")));
}

}  // namespace
}  // namespace alembert
