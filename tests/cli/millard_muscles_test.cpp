// The muscle curves of Millard, Uchida, Seth and Delp (Flexing Computational Muscle, Journal of Biomechanical Engineering 135, 2013,
// 021005), worked out here from the points that define them with the default parameters of OpenSim, against the tables of
// mechanisms/forces/elbow_millard.yaml; and its motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cli/csv.hpp"
#include "cli/muscle.hpp"

namespace alembert::test {
namespace {

using nlohmann::json;

/// How near the tables are, as the description says: forces in largest isometric ones, speeds in largest ones.
constexpr double kNear = 0.004;

using Controls = std::array<double, 6>;

/// Value and derivative of a quintic Bezier polynomial, by de Casteljau's scheme.
std::pair<double, double> bezier(Controls p, double u) {
  for (std::size_t last = 5; last > 1; --last)
    for (std::size_t i = 0; i < last; ++i) p[i] += u * (p[i + 1] - p[i]);
  return {p[0] + u * (p[1] - p[0]), 5 * (p[1] - p[0])};
}

/// A point of a curve with its slope; the piece that ends there has the curviness.
struct CurvePoint {
  double x, y, slope, curviness = 0;
};

/// Quintic Bezier pieces from point to point. The inner control points of each lie two by two on the lines along the slopes at its ends,
/// 0.1 + 0.8 of its curviness of the way to where these meet. Beyond its ends the curve goes on straight.
class BezierCurve {
 public:
  explicit BezierCurve(std::vector<CurvePoint> points) : points_(std::move(points)) {
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const CurvePoint &a = points_[i], &b = points_[i + 1];
      const double way = 0.1 + 0.8 * b.curviness;
      const double corner_x = (b.y - a.y - b.x * b.slope + a.x * a.slope) / (a.slope - b.slope);
      const double corner_y = b.y + (corner_x - b.x) * b.slope;
      const auto controls = [way](double first, double corner, double last) {
        const double second = first + way * (corner - first), fourth = last + way * (corner - last);
        return Controls{first, second, second, fourth, fourth, last};
      };
      x_.push_back(controls(a.x, corner_x, b.x));
      y_.push_back(controls(a.y, corner_y, b.y));
    }
  }
  BezierCurve inverse() const {
    BezierCurve swapped = *this;
    std::swap(swapped.x_, swapped.y_);
    for (CurvePoint& point : swapped.points_) point = {point.y, point.x, 1 / point.slope};
    return swapped;
  }
  double value(double x) const { return at(x).first; }
  double slope(double x) const { return at(x).second; }
  double steepest() const {
    double most = 0;
    for (std::size_t i = 0; i < x_.size(); ++i)
      for (double u = 0; u <= 1; u += 1.0 / 64)
        most = std::max(most, std::abs(bezier(y_[i], u).second / bezier(x_[i], u).second));
    return most;
  }

 private:
  std::pair<double, double> at(double x) const {
    const CurvePoint &first = points_.front(), &last = points_.back();
    if (x <= first.x) return {first.y + first.slope * (x - first.x), first.slope};
    if (x >= last.x) return {last.y + last.slope * (x - last.x), last.slope};
    std::size_t i = 0;
    while (x > points_[i + 1].x) ++i;
    const double u = where([&](double v) { return bezier(x_[i], v).first; }, x, 0, 1);
    const auto [y, y_u] = bezier(y_[i], u);
    return {y, y_u / bezier(x_[i], u).second};
  }
  std::vector<CurvePoint> points_;
  std::vector<Controls> x_, y_;
};

/// Active force over length: from `least` at 0.4441 up steeply to 0.73, less so to the plateau about 1, and down to `least` at 1.8123.
BezierCurve active_force(double least) {
  const double first = 0.4441, shoulder = 0.73, last = 1.8123, half_plateau = 0.05, shallow = 0.8616;
  const double at_shoulder = 1 - shallow * (1 - half_plateau - shoulder);
  return BezierCurve({{first, least, 0},
                      {(first + shoulder) / 2, at_shoulder / 2, 1.25 * at_shoulder / (shoulder - first), 1},
                      {(shoulder + 1 - half_plateau) / 2, (1 + at_shoulder) / 2, shallow, 1},
                      {1, 1, 0, 1},
                      {(1 + half_plateau + last) / 2, 0.5, -1 / (last - 1 - 2 * half_plateau), 1},
                      {last, least, 0, 1}});
}

/// Passive force over length: a foot of slope 0.2, then up to 1 at a strain of 0.7.
BezierCurve passive_force() {
  const double foot = 0.2, strain = 0.7, stiffness = 2 / strain,
               to_foot = std::min(0.1 / stiffness, 0.1 * strain);
  return BezierCurve(
      {{1, 0, 0}, {1 + to_foot, foot * to_foot / 2, foot, 0.75}, {1 + strain, 1, stiffness, 0.75}});
}

/// Force over speed, with the slope `at_ends` at the largest speeds.
BezierCurve force_of_speed(double at_ends) {
  const double shortening = 0.25, lengthening = 0.15;
  return BezierCurve({{-1, 0, at_ends},
                      {-0.9, 0.05 * (shortening + at_ends), shortening, 0.6},
                      {0, 1, 5, 0.6},
                      {0.9, 1.4 - 0.05 * (lengthening + at_ends), lengthening, 0.9},
                      {1, 1.4, at_ends, 0.9}});
}

/// Force of the tendon over its strain: a toe up to 2/3, then straight to 1 at 0.049.
BezierCurve tendon_force() {
  const double strain = 0.049, stiffness = 1.375 / strain, toe = 2.0 / 3;
  const double toe_end = strain + (toe - 1) / stiffness, foot = toe_end / 10;
  const double slope = toe / 2 / (strain + (toe / 2 - 1) / stiffness - foot);
  const double middle = (strain + (toe / 2 - 1) / stiffness - foot) / 2;
  return BezierCurve(
      {{0, 0, 0}, {foot + middle, slope * middle, slope, 0.5}, {toe_end, toe, stiffness, 0.5}});
}

/// Points of a table: each value, and the slope as the difference of two near points.
struct CurveTable {
  std::vector<double> x, y;
  /// Values within kNear, slopes within `slope_error` of the curve's steepest.
  void expect_follows(const BezierCurve& curve, double low, double high, double slope_error,
                      const char* name) const {
    EXPECT_LE(*std::ranges::min_element(x), low) << name;
    EXPECT_GE(*std::ranges::max_element(x), high) << name;
    const double steepest = curve.steepest();
    std::size_t points = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] < low || x[i] > high) continue;
      ++points;
      EXPECT_NEAR(y[i], curve.value(x[i]), kNear) << name << " at " << x[i];
      if (i % 2 == 1) {
        EXPECT_NEAR((y[i] - y[i - 1]) / (x[i] - x[i - 1]), curve.slope(x[i]), slope_error * steepest)
            << "slope of " << name << " at " << x[i];
      }
    }
    EXPECT_GE(points, 200U) << name;
  }
};

/// Pairs of near numbers over [low, high].
std::vector<double> near_pairs(double low, double high) {
  std::vector<double> numbers;
  for (int i = 0; i <= 200; ++i) {
    const double x = low + (high - low) * i / 200;
    numbers.insert(numbers.end(), {x, x + 1e-5 * (high - low)});
  }
  return numbers;
}

const char* const kMillard = "forces/elbow_millard";
enum class Elbow : std::size_t {
  active,
  passive,
  load,
  biceps_tension,
  triceps_tension,
  length,
  speed,
  strain
};

/// Outputs of the elbow, with the length and speed of the biceps' fibres and the strain of the triceps' tendon.
std::vector<json> elbow_at(const TemporaryFolder& folder, const std::vector<json>& states) {
  const std::string text = replaced(read_text(mechanism_file(kMillard)), "biceps_slack: 0.17",
                                    "biceps_slack: {value: 0.17, runtime: true}") +
                           "  - {name: length_now, value: (length(biceps) - biceps_slack)/biceps_fibre}\n"
                           "  - {name: speed_now, value: rate(biceps)/(biceps_fibre*vmax)}\n"
                           "  - {name: strain_now, value: (length(triceps) - "
                           "triceps_fibre*triceps_length*triceps_cosine)/triceps_slack - 1}\n";
  return values_at(folder, folder.write("elbow.yaml", text), "outputs,state_rates", states);
}
double elbow_output(const json& values, Elbow which) {
  return values["outputs"]["y"][static_cast<std::size_t>(which)].get<double>();
}

TEST(MillardMuscles, CurvesHaveTheirDefiningValues) {
  EXPECT_NEAR(active_force(0.1).value(1), 1, 1e-12);
  EXPECT_NEAR(passive_force().value(1.7), 1, 1e-12);
  EXPECT_NEAR(passive_force().slope(1.7), 2 / 0.7, 1e-9);
  EXPECT_NEAR(force_of_speed(0).value(0), 1, 1e-12);
  EXPECT_NEAR(force_of_speed(0).slope(1e-9), 5, 1e-5);
  EXPECT_NEAR(force_of_speed(0.1).inverse().value(1), 0, 1e-12);
  EXPECT_NEAR(tendon_force().value(0.049), 1, 1e-12);
}

TEST(MillardMuscles, TheRigidTendonsTablesFollowTheCurves) {
  const TemporaryFolder folder;
  const auto state = [](double activation, double slack, double speed) {
    return json{{"q", {0.6}},
                {"qd", {speed}},
                {"parameters", {{"biceps_slack", slack}}},
                {"states", {{"biceps_activation", activation}}}};
  };
  const double path = 0.13 * elbow_output(elbow_at(folder, {state(0, 0, 0)})[0], Elbow::length);
  std::vector<json> states;
  for (const double l : near_pairs(0.3, 2))
    for (const double a : {0.0, 1.0}) states.push_back(state(a, path - 0.13 * l, 0));
  const std::size_t speeds = states.size();
  for (const double v : near_pairs(-50, 50))
    for (const double a : {0.0, 1.0}) states.push_back(state(a, path - 0.13 * 1.3, v));
  states.push_back(state(0, path - 0.13, 30));
  const std::vector<json> values = elbow_at(folder, states);
  const auto force = [&](std::size_t i) { return elbow_output(values.at(i), Elbow::biceps_tension) / 600; };

  CurveTable passive_table, active_table, speed_table;
  for (std::size_t i = 0; i < speeds; i += 2) {
    const double l = elbow_output(values[i], Elbow::length);
    passive_table.x.push_back(l);
    passive_table.y.push_back(force(i));
    active_table.x.push_back(l);
    active_table.y.push_back(force(i + 1) - force(i));
  }
  passive_table.expect_follows(passive_force(), 0.31, 1.99, 0.03, "passive force");
  active_table.expect_follows(active_force(0), 0.31, 1.99, 0.12, "active force");

  const std::size_t rest = speeds + 400;
  ASSERT_EQ(elbow_output(values[rest], Elbow::speed), 0);
  const double still = force(rest + 1) - force(rest), at_rest = force(rest);
  for (std::size_t i = speeds; i + 2 < states.size(); i += 2) {
    const double v = elbow_output(values[i], Elbow::speed);
    EXPECT_NEAR(force(i), at_rest + 0.1 * v, 1e-12) << "damping at " << v;
    speed_table.x.push_back(v);
    speed_table.y.push_back((force(i + 1) - force(i)) / still);
  }
  speed_table.expect_follows(force_of_speed(0), -1.2, 1.2, 0.05, "force over speed");
  EXPECT_EQ(force(states.size() - 1), 0) << "a muscle does not push";
}

TEST(MillardMuscles, TheElasticTendonsTablesFollowTheCurves) {
  const TemporaryFolder folder;
  const auto state = [](double l) {
    return json{{"q", {0.278}}, {"states", {{"triceps_length", l}, {"triceps_activation", 1}}}};
  };
  std::vector<json> states;
  for (const double l : near_pairs(0.3, 2)) states.push_back(state(l));
  const std::size_t lengths = states.size();
  for (const double l : near_pairs(0.93, 1.06)) states.push_back(state(l));
  const std::vector<json> values = elbow_at(folder, states);

  CurveTable active_table, passive_table, tendon_table, speed_table;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const json& now = values[i];
    if (i < lengths) {
      const double l = states[i]["states"]["triceps_length"];
      active_table.x.push_back(l);
      active_table.y.push_back(elbow_output(now, Elbow::active));
      passive_table.x.push_back(l);
      passive_table.y.push_back(elbow_output(now, Elbow::passive));
    } else {
      tendon_table.x.push_back(elbow_output(now, Elbow::strain));
      tendon_table.y.push_back(elbow_output(now, Elbow::triceps_tension) / 800);
      speed_table.x.push_back(elbow_output(now, Elbow::load) / elbow_output(now, Elbow::active));
      speed_table.y.push_back(now["state_rates"]["sdot"][2].get<double>() / 10);
    }
  }
  active_table.expect_follows(active_force(0.1), 0.31, 1.99, 0.12, "active force");
  passive_table.expect_follows(passive_force(), 0.31, 1.99, 0.03, "passive force");
  tendon_table.expect_follows(tendon_force(), -0.01, 0.06, 0.05, "tendon");
  speed_table.expect_follows(force_of_speed(0.1).inverse(), 0, 1.45, 0.14, "speed over force");
}

Csv simulated(const TemporaryFolder& folder, const std::string& options) {
  const CommandResult result =
      alembert(folder, "simulate " + mechanism_file(kMillard) + " --every 100000 " + options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Csv(result.out);
}

TEST(MillardMuscles, StayAtTheirInitialState) {
  const TemporaryFolder folder;
  const Csv table = simulated(folder, "--duration 0.1 --step 5e-5");
  for (std::size_t i = 1; i < table.rows[0].size(); ++i)
    EXPECT_NEAR(table.rows.back()[i], table.rows[0][i], 2e-5 * (1 + std::abs(table.rows[0][i]))) << i;
}

TEST(MillardMuscles, MoveTheSameByShorterSteps) {
  const TemporaryFolder folder;
  const std::string input = "--duration 0.2 --input 'flexor=0.05 + 0.3*smoothstep(10*t)' --step ";
  const std::vector<double> coarse = simulated(folder, input + "5e-5").rows.back();
  const std::vector<double> fine = simulated(folder, input + "2.5e-5").rows.back();
  EXPECT_GT(fine[1], 0.5) << "it bends";
  for (std::size_t i = 1; i < fine.size(); ++i)
    EXPECT_NEAR(coarse[i], fine[i], 1e-6 * (1 + std::abs(fine[i]))) << i;
}

}  // namespace
}  // namespace alembert::test
