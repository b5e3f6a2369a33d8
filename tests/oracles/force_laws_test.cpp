// Laws that random forces on random mechanisms obey in the oracle.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "oracles/comparison.hpp"
#include "oracles/random_forces.hpp"
#include "oracles/random_mechanism.hpp"
#include "oracles/taylor/applied_forces.hpp"
#include "oracles/taylor/numeric_functions.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {
namespace {

constexpr std::uint64_t kSeeds = 44;

std::string forced(std::uint64_t seed) {
  return with_random_forces(random_mechanism(seed), seed);
}

// Every kind of force, key of a coordinate and function is drawn often enough to be met.
TEST(RandomForces, OfEveryKind) {
  std::map<std::string, int> met;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::string text = forced(seed);
    EXPECT_EQ(text, forced(seed));
    const auto meet = [&](const std::string& word) {
      met[word] += std::regex_search(text, std::regex("(^|[^a-z_])" + word)) ? 1 : 0;
    };
    for (const char* word :
         {"on: q",       "on: r",       "potential:",     "between:",    "path:",       "at: g",
          "axes: world", "axes: frame", "damping:",       "friction:",   "stiffness:",  "rest:",
          "effort:",     "initial: ",   "position\\(",    "velocity\\(", "rotation\\(", "angular_velocity\\(",
          "length\\(",   "rate\\(",     "distance\\(",    "length -",    "min\\(",      "max\\(",
          "clamp\\(",    "step\\(",     "smoothstep\\(",  "select\\(",   "sign\\(",     "abs\\(",
          "spline\\(",   "linear\\(",   "simm_spline\\(", "d\\(q",       "d\\(r",       "runtime: true",
          "in0",         "w0:",         "contact: ",      "plane: ",     "sphere: "})
      meet(word);
    for (const char* word :
         {"s1", "rate: \"", "y0", "along: ", "tension\\(", "when: \"min", "when: \"length", "when: \"s"})
      meet(word);
  }
  for (const auto& [word, count] : met) EXPECT_GE(count, 2) << word;
}

// Almost every speed is driven, and all are numbers.
TEST(RandomForces, ReachTheSpeeds) {
  int driven = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Description d = parse_description(forced(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 2; ++i) {
      const State state = random_state(d, random);
      ASSERT_EQ(state.inputs.size(), d.inputs.size());
      for (const double Q : applied_forces(d, lifted<double>(state))) {
        EXPECT_TRUE(std::isfinite(Q)) << seed;
        driven += Q != 0 ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_GT(driven, 0.9 * all);
}

// M and gravity are what they were without forces; tau and c lose what is applied.
TEST(ForceLaws, TauAndBiasLoseWhatIsApplied) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::string plain = random_mechanism(seed);
    const Description without = parse_description(plain), with = parse_description(forced(seed));
    std::mt19937_64 random(seed);
    State state = random_state(with, random);
    const auto before =
        numeric_functions(without, state, {"mass_matrix", "bias", "inverse_dynamics", "gravity"});
    const auto after = numeric_functions(
        with, state, {"mass_matrix", "bias", "inverse_dynamics", "gravity", "applied_forces"});
    const Eigen::MatrixXd& Q = after.at("applied_forces").at("Q");
    EXPECT_EQ(before.at("mass_matrix").at("M"), after.at("mass_matrix").at("M"));
    EXPECT_EQ(before.at("gravity").at("g"), after.at("gravity").at("g"));
    EXPECT_LE(relative_error(after.at("bias").at("c"), before.at("bias").at("c") - Q), 1e-13);
    EXPECT_LE(
        relative_error(after.at("inverse_dynamics").at("tau"), before.at("inverse_dynamics").at("tau") - Q),
        1e-13);
  }
}

/// Lines of `forces` that match only, and no other forces; no outputs, no motion of states, and paths straight over all
/// of their points.
std::string with_forces_like(const std::string& text, const std::string& pattern) {
  std::istringstream lines(text);
  std::string result, line, section;
  while (std::getline(lines, line)) {
    if (line[0] != ' ') section = line;
    line = std::regex_replace(line, std::regex("rate: \"[^\"]*\""), "rate: 0");
    line = std::regex_replace(line, std::regex("\\{frame: (\\w+), when: [^}]*\\}"), "$1");
    line = std::regex_replace(line, std::regex("\\{(sphere|cylinder): [^}]*\\}, "), "");
    line = std::regex_replace(line, std::regex(", (damping: [^,}]*|friction: \\{[^}]*\\})"), "");
    if (section == "outputs:") continue;
    if (line.rfind("  - ", 0) != 0 || section != "forces:" || std::regex_search(line, std::regex(pattern)))
      result += line + "\n";
  }
  return result;
}

// Where there is a contact, at some states bodies touch, at some they do not.
TEST(RandomForces, ContactsTouchAtTimes) {
  int touching = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::string text = with_forces_like(forced(seed), "contact: ");
    if (text.find("contact: ") == std::string::npos) continue;
    const Description with = parse_description(text);
    const Description without = parse_description(with_forces_like(text, "none of them"));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 4; ++i) {
      const StateOf<double> state = lifted<double>(random_state(with, random));
      touching += applied_forces(with, state) != applied_forces(without, state) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(touching, 0.2 * all);
  EXPECT_LT(touching, 0.8 * all);
}

// Potentials and springs: dV/dt along any motion at fixed time and inputs is minus their power.
TEST(ForceLaws, PotentialForcesTakeTheirPowerFromThePotential) {
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    // length(PATH) needs its path.
    const std::string text = with_forces_like(forced(seed), "potential:");
    if (text.find("length(") != std::string::npos) continue;
    ++tried;
    const Description d = parse_description(text);
    std::mt19937_64 random(seed);
    const State state = random_state(d, random);
    const std::vector<double> Q = applied_forces(d, lifted<double>(state));
    StateOf<Jet<double>> moved = lifted<Jet<double>>(state);
    moved.q = trajectory(d, state, state.rates);
    double power = 0, size = 0;
    for (std::size_t k = 0; k < Q.size(); ++k) {
      power += Q[k] * state.speeds[k];
      size = std::max(size, std::abs(Q[k] * state.speeds[k]));
    }
    EXPECT_NEAR(potential_of_forces(d, moved).first, -power, 1e-12 * std::max(1.0, size)) << seed;
  }
  EXPECT_GT(tried, 15);
}

// Paths on mechanisms and frames that do not move by themselves: their power is -T dL/dt, and less than nothing where
// the tension is a damper's.
TEST(ForceLaws, DampedPathsTakePower) {
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= 2 * kSeeds; ++seed) {
    std::string text = with_forces_like(forced(seed), "name: path");
    text = std::regex_replace(text, std::regex("tension: \"[^\"]*\""), "tension: \"3*rate\"");
    text = std::regex_replace(text, std::regex(", stiffness: [^,}]*"), "");
    text = std::regex_replace(text, std::regex(" \\+ t\\)\""), ")\"");  // of definitions
    if (std::regex_search(text, std::regex("\\bt\\b"))) continue;
    ++tried;
    const Description d = parse_description(text);
    std::mt19937_64 random(seed);
    const State state = random_state(d, random);
    const StateOf<double> now = lifted<double>(state);
    const std::vector<double> Q = applied_forces(d, now);
    // Rates of lengths by central differences of fourth order along the motion.
    const auto length = [&](std::size_t path, double dt) {
      std::vector<Jet<double>> q;
      for (const Jet<double>& x : trajectory(d, state, state.rates))
        q.emplace_back(x.value + dt * x.first + dt * dt / 2 * x.second);
      const auto frames = frame_poses(d, q, Jet<double>(state.time));
      double sum = 0;
      for (std::size_t i = 0; i + 1 < d.paths[path].points.size(); ++i) {
        const auto &a = frames[d.paths[path].points[i].frame].translation,
                   &b = frames[d.paths[path].points[i + 1].frame].translation;
        sum += std::hypot(b[0].value - a[0].value, b[1].value - a[1].value, b[2].value - a[2].value);
      }
      return sum;
    };
    double expected = 0, power = 0;
    const double h = 1e-3;
    for (std::size_t path = 0; path < d.paths.size(); ++path) {
      const double rate =
          (8 * (length(path, h) - length(path, -h)) - (length(path, 2 * h) - length(path, -2 * h))) /
          (12 * h);
      expected -= 3 * rate * rate;
    }
    for (std::size_t k = 0; k < Q.size(); ++k) power += Q[k] * state.speeds[k];
    EXPECT_NEAR(power, expected, 1e-7 * std::max(1.0, std::abs(expected))) << seed;
  }
  EXPECT_GT(tried, 5);
}

// Derivatives of forces and rates of states against differences of fourth order: along speeds, by speeds, states and
// inputs.
TEST(ForceLaws, DerivativesOfStatesAreDifferences) {
  using R = long double;
  using Values = std::vector<R>;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Description d = parse_description(forced(seed));
    const State state = comparable_states(d, 1, seed).front();
    const auto all = numeric_functions(
        d, state, {"state_rates_derivatives", "state_jacobian", "state_input_jacobian", "input_jacobian"});
    const auto expect = [&](const Eigen::VectorXd& found, const auto& at) {
      const R h = 1e-4L;
      const Values a = at(h), b = at(-h), c = at(2 * h), e = at(-2 * h);
      ASSERT_EQ(static_cast<std::size_t>(found.size()), a.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        const R difference = (8 * (a[i] - b[i]) - (c[i] - e[i])) / (12 * h);
        EXPECT_NEAR(found[static_cast<Eigen::Index>(i)], static_cast<double>(difference),
                    1e-6 * std::max(1.0, found.cwiseAbs().maxCoeff()))
            << "seed " << seed << " row " << i;
      }
    };
    const Arrays& rates = all.at("state_rates_derivatives");
    for (int k = 0; k < d.nv; ++k) {
      expect(rates.at("r_q").col(k), [&](R step) {
        StateOf<R> moved = lifted<R>(state);
        const std::vector<Jet<R>> along = unit_motion(d, moved, k);
        for (std::size_t i = 0; i < along.size(); ++i) moved.q[i] += step * along[i].first;
        return state_rates(d, moved);
      });
      expect(rates.at("r_qd").col(k), [&](R step) {
        StateOf<R> moved = lifted<R>(state);
        moved.speeds[static_cast<std::size_t>(k)] += step;
        return state_rates(d, moved);
      });
    }
    const auto shifted = [&](const std::string& name, R step) {
      StateOf<R> moved = lifted<R>(state);
      (moved.states.count(name) != 0 ? moved.states : moved.inputs).at(name) += step;
      return moved;
    };
    const auto by = [&](const auto& given, const Eigen::MatrixXd& of_forces,
                        const Eigen::MatrixXd& of_rates) {
      for (std::size_t i = 0; i < given.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        expect(of_forces.col(column),
               [&](R step) { return applied_forces(d, shifted(given[i].name, step)); });
        expect(of_rates.col(column), [&](R step) { return state_rates(d, shifted(given[i].name, step)); });
      }
    };
    by(d.states, all.at("state_jacobian").at("Q_s"), rates.at("r_s"));
    by(d.inputs, all.at("input_jacobian").at("B"), all.at("state_input_jacobian").at("r_inputs"));
  }
}

// Derivatives of tau against differences of fourth order, along each speed and by each speed.
TEST(ForceLaws, DerivativesAreDifferences) {
  using R = long double;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Description d = parse_description(forced(seed));
    const State state = comparable_states(d, 1, seed).front();
    const auto derivatives =
        numeric_functions(d, state, {"inverse_dynamics_derivatives"}).at("inverse_dynamics_derivatives");
    const auto forces = [&](std::size_t k, R by_q, R by_qd) {
      StateOf<Jet<R>> moved = lifted<Jet<R>>(state);
      const std::vector<Jet<R>> along = unit_motion(d, lifted<R>(state), static_cast<int>(k));
      for (std::size_t i = 0; i < along.size(); ++i)
        moved.q[i].value = along[i].value + by_q * along[i].first;
      moved.speeds[k].value += by_qd;
      return numeric_forces(d, moved, state.wrenches);
    };
    const R h = 1e-4L;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d.nv); ++k) {
      for (const bool by_speed : {false, true}) {
        const auto at = [&](R step) { return forces(k, by_speed ? 0 : step, by_speed ? step : 0); };
        const auto a = at(h), b = at(-h), c = at(2 * h), e = at(-2 * h);
        const Eigen::VectorXd found =
            derivatives.at(by_speed ? "tau_qd" : "tau_q").col(static_cast<Eigen::Index>(k));
        for (std::size_t i = 0; i < a.size(); ++i) {
          const R difference = (8 * (a[i].value - b[i].value) - (c[i].value - e[i].value)) / (12 * h);
          EXPECT_NEAR(found[static_cast<Eigen::Index>(i)], static_cast<double>(difference),
                      1e-6 * std::max(1.0, found.cwiseAbs().maxCoeff()))
              << "seed " << seed << " speed " << k << (by_speed ? " qd " : " q ") << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace alembert::oracles
