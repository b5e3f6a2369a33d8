// Runtime parameters through frame placement and regrouping: every mechanism of the catalogue, and random
// ones, with some of their constants made arguments. At their defaults the dynamics are those of the
// mechanism with numbers, at all other values those of links as they were given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dynamics/choice/regrouping.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/rewrites/rigid_links.hpp"
#include "dynamics/rewrites/scaled_vectors.hpp"
#include "oracles/random_mechanism.hpp"

namespace alembert::test {
namespace {

constexpr double kTolerance = 1e-11;

/// What is made an argument: all of the last body's mass properties; masses and some entries of all bodies;
/// some lengths; some of all these.
enum class Made { load, masses, lengths, some };

/// Makes constants of a mechanism runtime parameters.
class RuntimeMaker {
 public:
  RuntimeMaker(const Mechanism& given, ExprGraph& graph, Made made, unsigned seed)
      : mechanism_(given), graph_(graph), random_(seed) {
    const auto last = std::find_if(mechanism_.bodies.rbegin(), mechanism_.bodies.rend(),
                                   [](const Body& body) { return !body.mass_properties.mass.is_zero(); });
    switch (made) {
      case Made::load:
        if (last != mechanism_.bodies.rend()) make_masses(last->mass_properties, 1, 1);
        break;
      case Made::masses:
        for (Body& body : mechanism_.bodies) make_masses(body.mass_properties, 1, 0.5);
        break;
      case Made::lengths:
        for (Body& body : mechanism_.bodies) make_lengths(body.transform, 0.5);
        break;
      case Made::some:
        for (Body& body : mechanism_.bodies) {
          make_masses(body.mass_properties, 0.3, 0.2);
          make_lengths(body.transform, 0.2);
        }
        break;
    }
  }
  const Mechanism& mechanism() const { return mechanism_; }
  bool made_any() const { return count_ > 0; }

 private:
  bool chance(double p) { return static_cast<double>(random_() >> 11) * 0x1p-53 < p; }

  void make(Expr& constant, double probability) {
    if (!constant.is_constant() || constant.is_zero() || !chance(probability)) return;
    Parameter parameter;
    parameter.name = "made_" + std::to_string(count_++);
    parameter.runtime = true;
    const std::array<Expr, 1> root{constant};
    parameter.value = evaluate(root, {})[0];
    constant = graph_.symbol(parameter.name);
    mechanism_.parameters.push_back(std::move(parameter));
  }
  void make_masses(MassProperties& properties, double mass, double entries) {
    make(properties.mass, mass);
    for (std::size_t i = 0; i < 3; ++i) make(properties.com[i], entries);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) {
        make(properties.inertia(i, j), entries);
        properties.inertia(j, i) = properties.inertia(i, j);
      }
    }
  }
  void make_lengths(Transform& transform, double probability) {
    for (Factor& factor : transform.factors) {
      if (Translation* shift = std::get_if<Translation>(&factor.value)) {
        for (Expr& length : shift->offset.entries) make(length, probability);
      }
    }
  }

  Mechanism mechanism_;
  ExprGraph& graph_;
  std::mt19937_64 random_;
  int count_ = 0;
};

/// Values of expressions at random states, with runtime parameters at their defaults or up to a half off.
std::vector<double> values_at(std::span<const Expr> expressions, const Mechanism& mechanism, ExprGraph& graph,
                              unsigned seed, double spread) {
  std::vector<double> state = state_values(mechanism, graph, seed);
  std::mt19937_64 random(seed);
  for (const Parameter& parameter : mechanism.parameters) {
    const double off = 2 * spread * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    if (parameter.runtime)
      state[graph.symbol_index(graph.symbol(parameter.name).ref().node())] = parameter.value * (1 + off);
  }
  return evaluate(expressions, state);
}

/// Largest difference at random states, relative to the larger of 1 and the values of y, of states where y is
/// finite; infinite if it never is, or x is not there.
double worst_difference(std::span<const Expr> x, std::span<const Expr> y, const Mechanism& mechanism,
                        ExprGraph& graph, double spread) {
  double worst = 0;
  int finite = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const std::vector<double> a = values_at(x, mechanism, graph, seed, spread);
    const std::vector<double> b = values_at(y, mechanism, graph, seed, spread);
    if (!std::all_of(b.begin(), b.end(), [](double v) { return std::isfinite(v); })) continue;
    ++finite;
    double scale = 1;
    for (const double v : b) scale = std::max(scale, std::abs(v));
    for (std::size_t i = 0; i < b.size(); ++i) {
      const double difference = std::abs(a[i] - b[i]) / scale;
      worst = std::isfinite(difference) ? std::max(worst, difference) : HUGE_VAL;
    }
  }
  return finite > 0 ? worst : HUGE_VAL;
}

/// Every way to write the links of a mechanism with runtime parameters against the given one with numbers and
/// against its own links as given. Returns whether an argument made a difference.
bool expect_same_dynamics(const LoadedMechanism& given, const RuntimeMaker& made) {
  ExprGraph& graph = *given.graph;
  const Mechanism& mechanism = made.mechanism();
  const Kinematics numbers = given.kinematics();
  const Kinematics kinematics = symbolic_kinematics(mechanism, graph);
  const std::vector<Expr> given_Q = reduced_inverse_dynamics(*given.mechanism, numbers.tree, graph);
  const std::vector<Expr> given_M = composite_mass_matrix(*given.mechanism, numbers.tree, graph);
  const std::vector<Expr> Q = reduced_inverse_dynamics(mechanism, kinematics.tree, graph);
  const std::vector<Expr> M = composite_mass_matrix(mechanism, kinematics.tree, graph);
  const auto expect_same = [&](const WrittenTree& tree, const char* how) {
    const std::vector<Expr> here_Q = reduced_inverse_dynamics(mechanism, tree, graph);
    const std::vector<Expr> here_M = composite_mass_matrix(mechanism, tree, graph);
    EXPECT_LE(worst_difference(here_Q, given_Q, mechanism, graph, 0), kTolerance) << how << ", Q at defaults";
    EXPECT_LE(worst_difference(here_M, given_M, mechanism, graph, 0), kTolerance) << how << ", M at defaults";
    EXPECT_LE(worst_difference(here_Q, Q, mechanism, graph, 0.5), kTolerance) << how << ", Q elsewhere";
    EXPECT_LE(worst_difference(here_M, M, mechanism, graph, 0.5), kTolerance) << how << ", M elsewhere";
  };
  std::vector<MotionTree> trees{kinematics.tree};
  if (kinematics.peeled) trees.push_back(*kinematics.peeled);
  for (const MotionTree& tree : trees) {
    const RigidLinks links(mechanism, tree, graph);
    const std::vector<std::pair<const char*, std::vector<Regrouping>>> ways{
        {"placed", std::vector<Regrouping>(links.links().size())},
        {"regrouped, terms stay", choose_regroupings(links)},
        {"regrouped, terms may move", choose_regroupings(links, true)},
        {"minimal, terms stay", minimal_regroupings(links)},
        {"minimal, terms move", minimal_regroupings(links, true)}};
    for (const auto& [how, regroupings] : ways) {
      WrittenTree placed = links.link_tree(regroupings, graph);
      expect_same(placed, how);
      const std::vector<int> turns = scalable_turns(placed.tree);
      placed.scaling = Scaling(placed.tree, turns);
      expect_same(placed, how);
      placed.scaling = Scaling(placed.tree, turns, turns);
      expect_same(placed, how);
    }
  }
  return worst_difference(Q, given_Q, mechanism, graph, 0.5) > 1e-6;
}

class RuntimeParameters : public testing::TestWithParam<std::string> {};

TEST_P(RuntimeParameters, SurvivePlacementAndRegrouping) {
  const LoadedMechanism given = LoadedMechanism::file(GetParam());
  // Of long mechanisms some constants are enough.
  const std::vector<Made> kinds =
      given.mechanism->bodies.size() > 8
          ? std::vector<Made>{Made::some}
          : std::vector<Made>{Made::load, Made::masses, Made::lengths, Made::some};
  bool any = false, differs = false;
  for (const Made made : kinds) {
    SCOPED_TRACE(static_cast<int>(made));
    const RuntimeMaker maker(*given.mechanism, *given.graph, made, 7);
    if (!maker.made_any()) continue;
    any = true;
    differs = expect_same_dynamics(given, maker) || differs;
  }
  EXPECT_TRUE(any);
  EXPECT_TRUE(differs) << "no argument made a difference";
}

INSTANTIATE_TEST_SUITE_P(Catalogue, RuntimeParameters, testing::ValuesIn(catalogue()),
                         [](const auto& test) { return test_name(test.param); });

class RandomRuntimeParameters : public testing::TestWithParam<unsigned> {};

TEST_P(RandomRuntimeParameters, SurvivePlacementAndRegrouping) {
  const std::string text = oracles::random_mechanism(GetParam());
  SCOPED_TRACE(text);
  const LoadedMechanism given = LoadedMechanism::text(text);
  for (const Made made : {Made::masses, Made::lengths, Made::some}) {
    SCOPED_TRACE(static_cast<int>(made));
    const RuntimeMaker maker(*given.mechanism, *given.graph, made, GetParam());
    if (maker.made_any()) expect_same_dynamics(given, maker);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRuntimeParameters, testing::Range(1u, 26u));

}  // namespace
}  // namespace alembert::test
