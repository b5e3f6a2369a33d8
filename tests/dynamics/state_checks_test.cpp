// A mass matrix that is singular is an error that names the coordinate; one that is singular in one state
// only is not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dynamics/checks/plain_equations.hpp"
#include "dynamics/mechanism_file.hpp"

namespace alembert::test {
namespace {

std::string diagnosis(const std::string& text) {
  const auto loaded = LoadedMechanism::text(text);
  const Kinematics kinematics = loaded.kinematics();
  try {
    check_mass_matrix(kinematics, PlainEquations(kinematics));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MassMatrixCheck, NamesTheCoordinateWithoutInertia) {
  const std::string message = diagnosis(R"(alembert: 1
name: test
coordinates:
  - lift
  - spin
bodies:
  - {name: a, transform: [{translate: [0, 0, lift]}, {rotate: {axis: z, angle: spin}}], mass: 1}
)");
  EXPECT_THAT(message, testing::StartsWith("test.yaml:5:5: error:"));
  EXPECT_THAT(message, testing::HasSubstr("'spin'"));
}

TEST(MassMatrixCheck, FindsTwoCoordinatesThatDoTheSame) {
  EXPECT_NE(diagnosis(R"(alembert: 1
name: test
coordinates: [a, b]
bodies:
  - {name: a, transform: [{rotate: {axis: z, angle: a + b}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}
)"),
            "");
}

TEST(MassMatrixCheck, AllowsAPointwiseSingularity) {
  EXPECT_EQ(diagnosis(R"(alembert: 1
name: test
coordinates: [azimuth, polar]
bodies:
  - {name: bob, transform: [{rotate: {axis: z, angle: azimuth}}, {rotate: {axis: y, angle: polar}}], mass: 1, com: [0, 0, -1]}
)"),
            "");
}

TEST(MassMatrixCheck, SmallInertiaIsNoSingularity) {
  EXPECT_EQ(diagnosis(R"(alembert: 1
name: test
coordinates: [a, b]
bodies:
  - {name: big, transform: [{rotate: {axis: z, angle: a}}], mass: 100, com: [1, 0, 0], inertia: {xx: 50, yy: 50, zz: 50}}
  - {name: small, parent: big, transform: [{rotate: {axis: x, angle: b}}], mass: 0.001, inertia: {xx: 1e-7, yy: 1e-7, zz: 1e-7}}
)"),
            "");
}

}  // namespace
}  // namespace alembert::test
