// A mechanism in other units gives the same digits: lengths times 2^k and masses times 2^m change every
// result by a power of two, because no decision of the generator knows how long a metre is.
//
// The last bits may differ. Terms of a sum stand in an order that follows the content of the constants in them,
// and constants are exact fractions as long as 64 bits suffice for numerator and denominator, doubles after:
// powers of two change the one, and move where the other ends. With an order that knows mantissas only, two
// thirds of the arrays that differ still do, because of the second.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include "oracles/alembert_process.hpp"
#include "oracles/nasty_mechanism.hpp"
#include "oracles/reference.hpp"
#include "oracles/scaled_description.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {
namespace {

namespace fs = std::filesystem;

/// Micrometres and milligrams, kilometres and tonnes, heavy matter.
constexpr Scale kScales[] = {{-20, -20}, {10, 10}, {0, 17}};

std::vector<std::map<std::string, Arrays>> results(const std::string& text, const std::vector<State>& states,
                                                   const std::vector<Eigen::VectorXd>& tau,
                                                   const std::vector<std::string>& functions) {
  struct File {
    fs::path path;
    ~File() { fs::remove(path); }
  };
  const File file{fs::temp_directory_path() / ("alembert_scale_" + std::to_string(getpid()) + ".yaml")};
  std::ofstream(file.path) << text;
  return ask_functions(ALEMBERT_EXECUTABLE, file.path.string(), states, tau, functions);
}

/// Of an array's largest entry: 64 units in its last place, or what so much of the state makes of it. What is solved
/// for may differ as two backward stable solutions do.
constexpr double kRounding = 0x1p-46;

/// The same states, real coordinates, speeds and rates off by a part of `change` of themselves, in random directions.
std::vector<State> near_states(const Description& description, std::vector<State> states, double change) {
  std::mt19937_64 random(5);
  const auto move = [&](double& x) { x *= (random() >> 63) != 0 ? 1 + change : 1 - change; };
  for (State& state : states) {
    for (const Coordinate& coordinate : description.coordinates)
      if (!coordinate.quaternion) move(state.q[static_cast<std::size_t>(coordinate.first_q)]);
    std::ranges::for_each(state.speeds, move);
    std::ranges::for_each(state.rates, move);
  }
  return states;
}

void expect_same(const std::string& function, const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected,
                 double allowed) {
  ASSERT_EQ(found.size(), expected.size()) << function;
  const double largest = expected.size() == 0 ? 0 : expected.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < expected.size(); ++k) {
    const double a = found.reshaped()[k], b = expected.reshaped()[k];
    EXPECT_LE(std::abs(a - b), allowed * largest)
        << function << " [" << k << "]: " << a << " for " << b << ", off by " << (a - b) / largest
        << " of the largest, of which " << allowed << " is allowed";
  }
}

void expect_powers_of_two(const std::string& given, std::span<const Scale> scales) {
  const std::string text = with_short_numbers(given);
  const ScaledDescription plain = scaled_description(text, {});
  const Description description = parse_description(plain.text);
  std::mt19937_64 random(3);
  std::vector<State> states;
  std::vector<Eigen::VectorXd> tau;
  std::vector<double> of_rates;
  std::vector<Eigen::VectorXd> units;
  for (int i = 0; i < 2; ++i) {
    states.push_back(random_state(description, random));
    const auto dynamics = numeric_lagrangian<long double>(description, states.back());
    tau.emplace_back(dynamics.tau.cast<double>());
    const Eigen::Map<const Eigen::VectorXd> rates(states.back().rates.data(), description.nv);
    of_rates.push_back(kRounding + stable_accelerations(dynamics, rates.cast<long double>()));
    units.emplace_back(dynamics.mass_matrix.diagonal().cwiseSqrt().cast<double>());
  }
  std::set<std::string> wanted = comparable_functions(description);
  wanted.erase("coordinate_rates");                     // of quaternions and speeds alone
  wanted.erase("inverse_dynamics_second_derivatives");  // of a sum of forces in different units
  const std::vector<std::string> functions(wanted.begin(), wanted.end());
  constexpr double kChange = 0x1p-30;
  const std::vector<Reference> exact = taylor_references(description, states, wanted);
  const std::vector<Reference> near =
      taylor_references(description, near_states(description, states, kChange), wanted);
  const auto sensitivity = [&](std::size_t i, const std::string& function, const std::string& name) {
    const Eigen::MatrixXd &at = exact[i].exact.at(function).at(name),
                          &beside = near[i].exact.at(function).at(name);
    const double largest = at.size() == 0 ? 0 : at.cwiseAbs().maxCoeff();
    return largest > 0 ? (beside - at).cwiseAbs().maxCoeff() / (kChange * largest) : 0.0;
  };
  const auto before = results(plain.text, states, tau, functions);
  for (const Scale& scale : scales) {
    SCOPED_TRACE("lengths times 2^" + std::to_string(scale.length) + ", masses times 2^" +
                 std::to_string(scale.mass));
    const ScaledDescription scaled = scaled_description(text, scale);
    const std::vector<int> speeds = speed_exponents(description, scaled.lengths, scale);
    std::vector<int> back = speeds;
    for (int& exponent : back) exponent = -exponent;
    std::vector<State> scaled_states;
    std::vector<Eigen::VectorXd> scaled_tau;
    for (std::size_t i = 0; i < states.size(); ++i) {
      scaled_states.push_back(scaled_state(description, scaled.lengths, scale, states[i]));
      scaled_tau.emplace_back(scaled_array("inverse_dynamics", "tau", tau[i], speeds, scale));
    }
    const auto after = results(scaled.text, scaled_states, scaled_tau, functions);
    for (std::size_t i = 0; i < states.size(); ++i) {
      for (const auto& [function, arrays] : before[i]) {
        for (const auto& [name, values] : arrays) {
          Eigen::MatrixXd again = scaled_array(function, name, after[i].at(function).at(name), back,
                                               {-scale.length, -scale.mass});
          const bool solved = function.rfind("forward_dynamics", 0) == 0 || name == "Minv";
          const auto in_units = [&](const Eigen::MatrixXd& of) -> Eigen::MatrixXd {
            if (!solved) return of;
            const Eigen::MatrixXd rows = units[i].asDiagonal() * of;
            return name == "Minv" || name == "qdd_tau" ? rows * units[i].asDiagonal() : rows;
          };
          expect_same(function, in_units(again), in_units(values),
                      solved ? of_rates[i] : kRounding * std::max(1.0, sensitivity(i, function, name)));
        }
      }
    }
  }
}

class ScaleOfTheCatalogue : public testing::TestWithParam<std::string> {
 protected:
  static std::string text() {
    std::ifstream file(std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/" + GetParam() + ".yaml");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_P(ScaleOfTheCatalogue, KeepsTheDigits) {
  const bool is_large = GetParam() == "tree_every_joint";
  expect_powers_of_two(text(), std::span(kScales).first(is_large ? 1 : std::size(kScales)));
}
INSTANTIATE_TEST_SUITE_P(Mechanisms, ScaleOfTheCatalogue,
                         testing::Values("bead_on_helix", "body_on_torus", "cart_pole", "chain6r_90",
                                         "double_pendulum", "free_body", "pendulum", "puma560",
                                         "spherical_pendulum", "stanford", "tree_every_joint"),
                         [](const auto& test) { return test.param; });

/// Seeds of nasty_mechanism: of each kind one, in the scales in turn.
class ScaleOfNastyMechanisms : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ScaleOfNastyMechanisms, KeepsTheDigits) {
  std::uint64_t seed = GetParam();
  NastyMechanism mechanism = nasty_mechanism(seed);
  while (mechanism.text.find("runtime: true") != std::string::npos) mechanism = nasty_mechanism(seed += 10);
  const std::size_t scale = GetParam() % std::size(kScales);
  expect_powers_of_two(mechanism.text, std::span(kScales).subspan(scale, 1));
}
INSTANTIATE_TEST_SUITE_P(Seeds, ScaleOfNastyMechanisms, testing::Range<std::uint64_t>(1, 8));

}  // namespace
}  // namespace alembert::oracles
