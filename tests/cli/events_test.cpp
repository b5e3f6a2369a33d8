// What `simulate` says of limits, contacts and drives along a motion, against closed forms.
#include <gmock/gmock.h>

#include <cmath>
#include <regex>

#include "cli/command.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;

/// The line of an event, in numbers.
struct EventLine {
  long count = 0;
  double begin = 0, end = 0, largest = 0, largest_time = 0;
};
EventLine event_of(const std::string& err, const std::string& what) {
  const std::regex line(
      "note: ([^\n]*): (once|[0-9]+ times, first) from t = ([0-9.e+-]+) to (the end|[0-9.e+-]+); "
      "[a-z ]+([0-9.e+-]+)[ m]* at t = ([0-9.e+-]+)\n");
  for (std::sregex_iterator i(err.begin(), err.end(), line), none; i != none; ++i) {
    const std::smatch& found = *i;
    if (found[1] != what) continue;
    return {found[2] == "once" ? 1 : std::stol(found[2]), std::stod(found[3]),
            found[4] == "the end" ? INFINITY : std::stod(found[4]), std::stod(found[5]), std::stod(found[6])};
  }
  ADD_FAILURE() << "no event '" << what << "' in:\n" << err;
  return {};
}

TEST(Events, ADroppedBallHitsTheGroundWhenItShould) {
  const TemporaryFolder folder;
  const std::string file = folder.write("ball.yaml", R"(alembert: 1
name: ball
coordinates: [{name: z, initial: 0.6}]
bodies: [{name: ball, transform: [{translate: [0, 0, z]}], mass: 2}]
frames: [{name: centre, body: ball}]
forces: [{name: ground, contact: {frame: centre, radius: 0.1, plane: {normal: [0, 0, 1]}, stiffness: 1e6}}]
)");
  const double fall = std::sqrt(2 * 0.5 / 9.81);
  for (const std::string options : {" --step 1e-4", " --step 1e-4 --every 7", " --step 1.3e-4"}) {
    const CommandResult result = alembert(folder, "simulate " + file + " --duration 3" + options);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const EventLine hit = event_of(result.err, "contact 'ground'");
    EXPECT_NEAR(hit.begin, fall, 1e-9);
    EXPECT_EQ(hit.count, 5) << "it comes back without loss";
    // 2 g (0.5 + d) = 2/5 1e6 d^(5/2)
    double depth = 0;
    for (int i = 0; i < 50; ++i) depth = std::pow(2.5 * 2 * 9.81 * (0.5 + depth) / 1e6, 0.4);
    EXPECT_NEAR(hit.largest, depth, 1e-4 * depth);
    // Time on the ground: 2.94 d / v without gravity (Hertz).
    EXPECT_NEAR(hit.end - hit.begin, 2.943 * depth / std::sqrt(9.81), 0.02 * depth);
  }
  EXPECT_THAT(alembert(folder, "simulate " + file + " --duration 0.3").err,
              testing::Not(HasSubstr("contact")));
}

TEST(Events, ABallThatLiesOnTheGroundTouchesItFromTheStartToTheEnd) {
  const TemporaryFolder folder;
  const std::string file = folder.write("ball.yaml", R"(alembert: 1
name: ball
coordinates: [{name: z, initial: 0.09}]
bodies: [{name: ball, transform: [{translate: [0, 0, z]}], mass: 2}]
frames: [{name: centre, body: ball}]
forces: [{name: ground, contact: {frame: centre, radius: 0.1, plane: {normal: [0, 0, 1]}, stiffness: 1e4}}]
)");
  const EventLine lies =
      event_of(alembert(folder, "simulate " + file + " --duration 0.5 --integrator implicit --step 0.01").err,
               "contact 'ground'");
  EXPECT_EQ(lies.count, 1);
  EXPECT_EQ(lies.begin, 0);
  EXPECT_EQ(lies.end, INFINITY);
}

TEST(Events, APendulumPassesItsLimitsWhenItShould) {
  const TemporaryFolder folder;
  const std::string file = folder.write("pendulum.yaml", R"(alembert: 1
name: pendulum
coordinates: [{name: q, initial_speed: 5, limits: [-0.9, 0.8]}]
bodies: [{name: bob, transform: [{rotate: {axis: y, angle: q}}], mass: 1, com: [0, 0, -0.5]}]
)");
  const CommandResult result = alembert(folder, "simulate " + file + " --duration 6");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  // From the energy, by Simpson's rule: the time to an angle; and the period 4 K(k) / w by the mean of means.
  const auto speed = [](double q) { return std::sqrt(25 - 4 * 9.81 * (1 - std::cos(q))); };
  const auto time_to = [&](double angle) {
    const int n = 2000;
    double sum = 0;
    for (int i = 0; i <= n; ++i) sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) / speed(angle * i / n);
    return sum * angle / (3 * n);
  };
  const double w = std::sqrt(9.81 / 0.5), k = 5 / (2 * w);
  double a = 1, b = std::sqrt(1 - k * k);
  for (int i = 0; i < 20; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  const double period = 4 * M_PI / (2 * a) / w;
  const EventLine upper = event_of(result.err, "coordinate 'q' passes its upper limit 0.8");
  EXPECT_NEAR(upper.begin, time_to(0.8), 2e-9);
  EXPECT_NEAR(upper.end, period / 2 - time_to(0.8), 2e-9);
  EXPECT_EQ(upper.count, std::floor((6 - time_to(0.8)) / period) + 1);
  EXPECT_NEAR(upper.largest, 2 * std::asin(k) - 0.8, 1e-5);
  const EventLine lower = event_of(result.err, "coordinate 'q' passes its lower limit -0.9");
  EXPECT_NEAR(lower.begin, period / 2 + time_to(0.9), 2e-9);
  EXPECT_EQ(lower.count, std::floor((6 - lower.begin) / period) + 1);
}

TEST(Events, OutputsPassTheirLimits) {
  const TemporaryFolder folder;
  const std::string file = folder.write("ball.yaml", R"(alembert: 1
name: ball
gravity: [0, 0, -10]
coordinates: [{name: z, initial_speed: 6}]
bodies: [{name: ball, transform: [{translate: [0, 0, z]}], mass: 2}]
frames: [{name: center, body: ball}]
outputs:
  - {name: height, value: position(center).z, limits: [-1, 1]}
  - {name: way, value: 2*height, limits: [-100, 100]}
  - {name: fall, value: -velocity(center).z, limits: [-6.5, 5]}
)");
  const CommandResult result = alembert(folder, "simulate " + file + " --duration 1.5");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  constexpr double kPrinted = 5e-9;  // nine digits
  // z = 6 t - 5 t^2
  const EventLine upper = event_of(result.err, "output 'height' passes its upper limit 1");
  EXPECT_NEAR(upper.begin, 0.2, kPrinted);
  EXPECT_NEAR(upper.end, 1, kPrinted);
  EXPECT_NEAR(upper.largest, 0.8, 1e-5);
  EXPECT_NEAR(event_of(result.err, "output 'height' passes its lower limit -1").begin,
              (6 + std::sqrt(56)) / 10, kPrinted);
  EXPECT_NEAR(event_of(result.err, "output 'fall' passes its upper limit 5").begin, 1.1, kPrinted);
  EXPECT_EQ(result.err.find("way"), std::string::npos);
}

TEST(Events, DrivesAreAskedForMoreThanTheyCan) {
  const TemporaryFolder folder;
  const std::string file = folder.write("cart.yaml", R"(alembert: 1
name: cart
gravity: [0, 0, 0]
inputs: [push]
coordinates: [{name: x, damping: 0.1, effort: 3, speed: 5}, {name: y, effort: 1, speed: 1}]
bodies:
  - {name: cart, transform: [{translate: [x, y, 0]}], mass: 2}
forces: [{name: engine, on: x, value: push + 0.1*d(x)}]
)");
  const CommandResult result = alembert(folder, "simulate " + file + " --duration 4 --input 'push=2*t'");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const EventLine fast = event_of(result.err, "coordinate 'x' is faster than its drive's speed 5");
  EXPECT_NEAR(fast.begin, std::sqrt(20.0 / 2), 1e-9) << "u = t^2 / 2";
  EXPECT_EQ(fast.end, INFINITY);
  EXPECT_NEAR(fast.largest, 8 - 5, 1e-6);
  EXPECT_EQ(fast.largest_time, 4);
  // 2 t + t^2 / 20 = 3; what damps is not the drive's.
  const EventLine strong = event_of(result.err, "coordinate 'x' is driven by more than its drive's effort 3");
  EXPECT_NEAR(strong.begin, -20 + std::sqrt(400 + 60.0), 1e-9);
  EXPECT_EQ(strong.count, 1);
  EXPECT_THAT(result.err, testing::Not(HasSubstr("'y'")));
}

}  // namespace
}  // namespace alembert::test
