// Checks of constraints by numbers: laws that hold and fail, redundant rows, initial states that are off,
// derivatives without value.
#include "dynamics/checks/constraint_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "dynamics/mechanism_file.hpp"
#include "dynamics/recursions/constraints.hpp"
#include "dynamics/sleigh.hpp"

namespace alembert::test {
namespace {

/// A sleigh with equations in q and t.
LoadedMechanism sleigh_with(
    const std::function<std::vector<Expr>(const Mechanism&, const std::vector<Expr>&)>& equations) {
  LoadedMechanism loaded = LoadedMechanism::text(kSleigh);
  Mechanism& m = *loaded.mechanism;
  std::vector<Expr> q;
  for (const Coordinate& c : m.coordinates) q.push_back(c.symbols[0]);
  Constraint loop;
  loop.name = "loop";
  loop.equations = equations(m, q);
  loop.where = m.bodies[0].where;
  m.constraints.push_back(std::move(loop));
  return loaded;
}

ConstraintEquations equations_of(const LoadedMechanism& loaded, const Kinematics& kinematics) {
  return constraint_equations(*loaded.mechanism, kinematics.tree, kinematics.derivatives, *loaded.graph);
}

std::vector<Expr> mass_matrix(const Kinematics& kinematics) {
  return equations_of_motion(kinematics, Formulation::reduced).M;
}

TEST(ConstraintChecks, LawsHoldAndFailWhereARowIsWrong) {
  const LoadedMechanism loaded = sleigh_with([](const Mechanism& m, const std::vector<Expr>& q) {
    return std::vector<Expr>{sin(q[0] * q[2]) + q[1] * m.time, q[1] * q[2]};
  });
  const Kinematics kinematics = loaded.kinematics();
  ConstraintEquations equations = equations_of(loaded, kinematics);
  const ConstraintLaws laws = constraint_laws(kinematics, equations);
  ASSERT_TRUE(laws.position_rate && laws.velocity_rate);
  EXPECT_LT(*laws.position_rate, 1e-9);
  EXPECT_LT(*laws.velocity_rate, 1e-9);
  equations.gamma[1] += loaded.graph->rational(Rational(1, 1000)) * kinematics.derivatives.speed(0);
  EXPECT_GT(constraint_laws(kinematics, equations).velocity_rate.value(), 1e-5);
  equations.velocity[0] += loaded.graph->rational(Rational(1, 1000)) * kinematics.derivatives.speed(0);
  EXPECT_GT(constraint_laws(kinematics, equations).position_rate.value(), 1e-5);
}

TEST(ConstraintChecks, RedundantRowsAreThoseThatAddNothing) {
  const LoadedMechanism loaded = sleigh_with([](const Mechanism&, const std::vector<Expr>& q) {
    return std::vector<Expr>{q[0] + q[1], q[2], q[0] * q[0] * q[1], q[0] + q[0] + q[1] + q[1] - sin(q[2]),
                             q[0] - q[1] * q[1] - q[1]};
  });
  const Kinematics kinematics = loaded.kinematics();
  EXPECT_THAT(redundant_rows(kinematics, equations_of(loaded, kinematics), mass_matrix(kinematics)),
              testing::ElementsAre(2, 3));
}

TEST(ConstraintChecks, ShortRowsAreRowsToo) {
  const LoadedMechanism loaded = sleigh_with([](const Mechanism&, const std::vector<Expr>& q) {
    const Expr tiny = q[0].graph().rational(Rational(1, 1'000'000'000'000'000'000));
    const Expr quarter = q[0].graph().rational(Rational(1, 4));
    return std::vector<Expr>{q[0], q[1] * tiny, (q[1] - quarter) * tiny};
  });
  const Kinematics kinematics = loaded.kinematics();
  const ConstraintEquations equations = equations_of(loaded, kinematics);
  EXPECT_THAT(redundant_rows(kinematics, equations, mass_matrix(kinematics)), testing::ElementsAre(2));
  const std::vector<InitialResidual> residuals = initial_residuals(kinematics, equations, 1e-9);
  ASSERT_EQ(residuals.size(), 1u);
  EXPECT_EQ(residuals[0].row, 2u);
}

TEST(ConstraintChecks, ResidualsOfTheInitialState) {
  const LoadedMechanism loaded = sleigh_with([](const Mechanism& m, const std::vector<Expr>& q) {
    return std::vector<Expr>{q[0], q[1] - q[0].graph().rational(Rational(1, 4)),
                             q[2] - m.time - m.time - m.time};
  });
  const Kinematics kinematics = loaded.kinematics();
  const std::vector<InitialResidual> residuals =
      initial_residuals(kinematics, equations_of(loaded, kinematics), 1e-9);
  ASSERT_EQ(residuals.size(), 2u);
  EXPECT_EQ(residuals[0].row, 1u);
  EXPECT_EQ(residuals[0].position, -0.25);
  EXPECT_EQ(residuals[1].row, 2u);
  EXPECT_EQ(residuals[1].velocity, -3);
}

TEST(ConstraintChecks, ADerivativeWithoutValueIsNamed) {
  const LoadedMechanism loaded = sleigh_with([](const Mechanism&, const std::vector<Expr>& q) {
    return std::vector<Expr>{q[2], sqrt(q[0] * q[0] + q[1] * q[1])};
  });
  const Kinematics kinematics = loaded.kinematics();
  try {
    equations_of(loaded, kinematics);
    FAIL() << "the distance of two points that coincide has no derivative";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("test.yaml:5:"));
    EXPECT_THAT(error.what(), testing::HasSubstr("derivative of constraint 'loop[1]' has no value"));
  }
}

TEST(ConstraintChecks, TextTellsWhichOfTheCatalogueHaveConstraints) {
  for (const std::string& path : catalogue())
    EXPECT_EQ(has_constraints(path), !LoadedMechanism::file(path).mechanism->constraints.empty()) << path;
}

class ConstrainedCatalogue : public testing::TestWithParam<std::string> {};
TEST_P(ConstrainedCatalogue, RowsHaveTheirRates) {
  const LoadedMechanism loaded = LoadedMechanism::file(GetParam());
  const Kinematics kinematics = loaded.kinematics();
  const ConstraintLaws laws = constraint_laws(kinematics, equations_of(loaded, kinematics));
  ASSERT_TRUE(laws.velocity_rate);
  EXPECT_LT(*laws.velocity_rate, 1e-7);
  const bool holonomic = std::ranges::any_of(
      loaded.mechanism->constraints, [](const Constraint& c) { return c.type == ConstraintType::holonomic; });
  ASSERT_EQ(laws.position_rate.has_value(), holonomic);
  EXPECT_LT(laws.position_rate.value_or(0), 1e-7);
}
INSTANTIATE_TEST_SUITE_P(Files, ConstrainedCatalogue, testing::ValuesIn(catalogue_where(has_constraints)),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace alembert::test
