// Names that are macros: what generated code makes of them compiles after all headers of the C library.
#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <gtest/gtest.h>
#include <inttypes.h>
#include <limits.h>
#include <locale.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <wchar.h>

// After them.
#include <macro_names/macro_names.h>

#include <macro_names/macro_names.hpp>
#include <macro_names/macro_names_batch.hpp>
#include <macro_names/macro_names_impl.hpp>

namespace {

namespace m = alembert::mechanisms::macro_names;

TEST(MacroNames, AreTextInGeneratedCode) {
  EXPECT_EQ(m::kCoordinateNames[0], "M_PI");
  EXPECT_EQ(m::kBodyNames[1], "BUFSIZ");
  static_assert(m::Coordinate::M_PI_ == 0 && m::Coordinate::signbit == 4 && m::Speed::signbit == 4);
  static_assert(m::Body::BUFSIZ_ == 1 && m::Frame::RAND_MAX_ == 0 && m::Parameter::math_errhandling_ == 1);
  static_assert(m::Mechanism<>::Wrench::E2BIG_ == 0);
  EXPECT_EQ(m::kParameterNames[0], "SIGINT");
  EXPECT_STREQ(macro_names_frame_names[0], "RAND_MAX");
  // The same of C: behind the mechanism's name a macro is none, and what functions and lists are called is another's.
  static_assert(macro_names_coordinate_M_PI == 0 && macro_names_coordinate_signbit == 4 &&
                macro_names_speed_signbit == 4 && macro_names_body_BUFSIZ == 1 &&
                macro_names_wrench_E2BIG == 0);
  static_assert(macro_names_parameter_math_errhandling == 1 && macro_names_parameter_count_ == 2 &&
                macro_names_parameter_count == 3);
  EXPECT_STREQ(macro_names_frame_names[macro_names_frame_RAND_MAX], "RAND_MAX");
  EXPECT_STREQ(macro_names_frame_names[macro_names_frame_poses_], "poses");
  EXPECT_STREQ(macro_names_frame_names[macro_names_frame_poses_2], "poses_");
  EXPECT_STREQ(macro_names_frame_names[macro_names_frame_poses_batch_], "poses_batch");
  const auto mass = m::Mechanism<double>::mass_matrix(m::Mechanism<double>::initial_coordinates());
  EXPECT_NEAR(mass(0, 0), 2 * 3 + 3, 1e-14);
}

}  // namespace
