// The muscles of Thelen (2003) in mechanisms/forces/elbow.yaml and elbow_elastic_tendons.yaml: closed form of the activation, the static
// equations where they come to rest, and force over speed against its inverse.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/csv.hpp"
#include "cli/muscle.hpp"

namespace alembert::test {
namespace {

using nlohmann::json;

// The curves, of the largest isometric force, over lengths of fibres in optimal ones and strains of tendons.
double thelen_active(double length) {
  return std::exp(-(length - 1) * (length - 1) / 0.45);
}
double thelen_passive(double length) {
  return std::max(0.0, std::expm1(5 * (length - 1) / 0.6) / std::expm1(5));
}
double thelen_tendon(double strain) {
  const double toe = 0.609 * 0.04;
  if (strain <= 0) return 0;
  return strain < toe ? 0.33 * std::expm1(3 * strain / toe) / std::expm1(3)
                      : 0.33 + 1.712 / 0.04 * (strain - toe);
}

/// The elbow on elastic tendons, held by a huge inertia, with the lengths of its muscles as outputs.
std::string held_elbow(const TemporaryFolder& folder) {
  const std::string text =
      replaced(read_text(mechanism_file("forces/elbow_elastic_tendons")), "damping: 0.05}", "armature: 1e9}");
  return folder.write("held.yaml", replaced(text, "triceps_activation\n    initial: 0.05",
                                            "triceps_activation\n    initial: 0.9") +
                                       "  - {name: biceps_path, value: length(biceps)}\n"
                                       "  - {name: triceps_path, value: length(triceps)}\n");
}

Csv held_motion(const TemporaryFolder& folder, double duration) {
  const CommandResult result =
      alembert(folder, "simulate " + held_elbow(folder) + " --step 1e-4 --every 100 --duration " +
                           std::to_string(duration) + " --input flexor=0.7 --input extensor=0.3");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Csv(result.out);
}

TEST(ThelenMuscles, ActivationFollowsItsClosedForm) {
  const TemporaryFolder folder;
  const Csv table = held_motion(folder, 0.1);
  const std::size_t rises = table.column("biceps_activation"), falls = table.column("triceps_activation");
  ASSERT_EQ(table.rows.size(), 11U);
  for (const std::vector<double>& row : table.rows) {
    const double up = row[rises], down = row[falls];
    EXPECT_NEAR(0.015 * (-(0.5 + 1.5 * 0.7) * std::log((0.7 - up) / (0.7 - 0.05)) - 1.5 * (up - 0.05)),
                row[0], 1e-7);
    EXPECT_NEAR(0.05 / (0.5 + 1.5 * 0.3) *
                    (std::log((0.5 + 1.5 * down) / (0.5 + 1.5 * 0.9)) - std::log((down - 0.3) / (0.9 - 0.3))),
                row[0], 1e-7);
  }
}

struct ThelenMuscle {
  const char* name;
  double force, fibre, slack, pennation, activation;
};

TEST(ThelenMuscles, AnIsometricStepEndsAtTheStaticForce) {
  const TemporaryFolder folder;
  const Csv table = held_motion(folder, 1);
  const std::vector<double>& end = table.rows.back();
  EXPECT_NEAR(end[1], 0.278, 1e-5) << "it is held";
  for (const ThelenMuscle& m :
       {ThelenMuscle{"biceps", 600, 0.13, 0.17, 0, 0.7}, ThelenMuscle{"triceps", 800, 0.1, 0.11, 0.2, 0.3}}) {
    const auto of = [&](const char* quantity) {
      return end[table.column(m.name + std::string("_") + quantity)];
    };
    const auto cosine = [&](double l) { return std::sqrt(1 - std::pow(std::sin(m.pennation) / l, 2)); };
    const auto fibres = [&](double l) {
      return cosine(l) * (m.activation * thelen_active(l) + thelen_passive(l));
    };
    const auto stretched = [&](double l) {
      return thelen_tendon((of("path") - m.fibre * l * cosine(l)) / m.slack - 1);
    };
    const double rest = where([&](double l) { return fibres(l) - stretched(l); }, 0, 0.6, 1.3);
    EXPECT_NEAR(of("length"), rest, 1e-6) << m.name;
    EXPECT_NEAR(of("tension"), m.force * fibres(rest), 1e-5 * m.force) << m.name;
    EXPECT_NEAR(of("load"), m.activation * thelen_active(rest), 1e-5) << m.name;
    EXPECT_GT(of("tension"), 0.2 * m.force) << m.name;
    EXPECT_GT(std::abs(rest - table.rows[0][table.column(m.name + std::string("_length"))]), 0.01)
        << m.name << " moved";
  }
}

// Speeds of fibres on elastic tendons, put into the muscle with a rigid tendon, give the forces that they came from.
TEST(ThelenMuscles, ForceOverSpeedAndItsInverseAgree) {
  const TemporaryFolder folder;
  const std::string rigid =
      folder.write("rigid.yaml", read_text(mechanism_file("forces/elbow")) +
                                     "  - {name: fibre, value: (length(biceps) - 0.17)/0.13}\n"
                                     "  - {name: fibre_rate, value: rate(biceps)/0.13}\n"
                                     "  - {name: force, value: tension(biceps)/600}\n");
  enum RigidOutput : std::size_t { fibre = 2, fibre_rate, force };
  const auto output = [](const json& values, std::size_t which) {
    return values["outputs"]["y"][which].get<double>();
  };
  for (const double activation : {0.2, 0.6, 1.0}) {
    const auto turning = [&](double speed) {
      return json{{"q", {0.6}}, {"qd", {speed}}, {"inputs", {{"flexor", activation}}}};
    };
    const json unit = values_at(folder, rigid, "outputs", {turning(1)})[0];
    const double length = output(unit, fibre);

    std::vector<json> states;
    for (int i = 0; i < 60; ++i)  // from a slack tendon to a taut one
      states.push_back({{"q", {0.6 - 0.006 * i}},
                        {"states", {{"biceps_length", length}, {"biceps_activation", activation}}}});
    std::vector<double> loads;
    std::vector<json> speeds;
    for (const json& values :
         values_at(folder, mechanism_file("forces/elbow_elastic_tendons"), "outputs,state_rates", states)) {
      const double load = output(values, 0);
      if (load <= 0 || load >= 0.95 * 1.4 * activation * thelen_active(length)) continue;
      loads.push_back(load);
      speeds.push_back(turning(values["state_rates"]["sdot"][2].get<double>() / output(unit, fibre_rate)));
    }
    const std::vector<json> back = values_at(folder, rigid, "outputs", speeds);
    std::size_t lengthening = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      EXPECT_NEAR(output(back[i], force) - thelen_passive(length), loads[i], 1e-12)
          << "activation " << activation;
      lengthening += output(back[i], fibre_rate) > 0;
    }
    EXPECT_GE(lengthening, 2U);
    EXPECT_GE(loads.size() - lengthening, 5U);
  }
}

}  // namespace
}  // namespace alembert::test
