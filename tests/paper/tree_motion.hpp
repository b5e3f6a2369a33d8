// The paper's mechanisms without constraints as the alembert command moves them. In: a file's name, a step.
// Out: the states of a simulation, and the poses of bodies at states, by name. Poses are what is measured:
// distances from wires, surfaces and hinges, apart from the equations that were integrated.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "oracles/description/description.hpp"

namespace alembert::test {

using Pose = Eigen::Matrix<double, 3, 4>;  ///< [R | p], world

inline std::string paper_file(const std::string& name) {
  return ALEMBERT_SOURCE_DIR "/mechanisms/paper/" + name + ".yaml";
}

/// One moment of a simulation; names of values are the columns of the CSV.
struct Moment {
  std::vector<double> q, speeds;
  double t = 0, kinetic = 0, energy = 0;
};

/// Runs the command with a time limit fit for a minute of motion.
inline CommandResult run_for_a_minute(const TemporaryFolder& folder, const std::string& arguments,
                                      const std::string& input = "") {
  return alembert(folder, arguments, input, 300);
}

/// States and poses of one mechanism of mechanisms/paper.
class TreeMotion {
 public:
  explicit TreeMotion(const std::string& name)
      : file_(paper_file(name)), description_(oracles::read_description(file_)) {}

  const oracles::Description& description() const { return description_; }
  double parameter(const std::string& name) const { return description_.parameter(name); }
  /// Index into q.
  std::size_t coordinate(const std::string& name) const {
    for (const oracles::Coordinate& c : description_.coordinates) {
      if (c.name == name) return static_cast<std::size_t>(c.first_q);
    }
    throw std::runtime_error("no coordinate '" + name + "'");
  }

  /// Unforced motion by steps of the classical Runge-Kutta method from the initial state; every `every`-th.
  std::vector<Moment> simulate(double duration, double step, int every) const {
    const TemporaryFolder folder;
    std::ostringstream options;
    options.precision(17);
    options << " --duration " << duration << " --step " << step << " --every " << every
            << " --integrator rk4";
    const CommandResult result = run_for_a_minute(folder, "simulate " + file_ + options.str());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::size_t nq = static_cast<std::size_t>(description_.nq),
                      nv = static_cast<std::size_t>(description_.nv);
    std::vector<Moment> moments;
    std::istringstream lines(result.out);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::vector<double> row;
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
      EXPECT_GE(row.size(), 1 + nq + nv + 3) << "columns of the CSV";
      if (row.size() < 1 + nq + nv + 3) return moments;
      const auto at = [&](std::size_t i) { return row.begin() + static_cast<std::ptrdiff_t>(i); };
      moments.push_back(
          {{at(1), at(1 + nq)}, {at(1 + nq), at(1 + nq + nv)}, row[0], row[1 + nq + nv], row[3 + nq + nv]});
    }
    return moments;
  }

  /// World poses of all bodies at each state, by name.
  std::vector<std::map<std::string, Pose>> poses(
      const std::vector<std::pair<double, std::vector<double>>>& states) const {
    const TemporaryFolder folder;
    std::string input;
    for (const auto& [t, q] : states) input += nlohmann::json{{"q", q}, {"t", t}}.dump() + "\n";
    const CommandResult result = run_for_a_minute(folder, "evaluate --json " + file_, input);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::vector<std::map<std::string, Pose>> all;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
      const nlohmann::json list = nlohmann::json::parse(line).at("poses");
      EXPECT_EQ(list.size(), description_.bodies.size());
      std::map<std::string, Pose> named;
      for (std::size_t b = 0; b < list.size(); ++b) {
        Pose pose;
        for (int i = 0; i < 12; ++i)
          pose(i / 4, i % 4) = list[b].at(static_cast<std::size_t>(i)).get<double>();
        named[description_.bodies[b].name] = pose;
      }
      all.push_back(std::move(named));
    }
    EXPECT_EQ(all.size(), states.size());
    return all;
  }
  std::vector<std::map<std::string, Pose>> poses(const std::vector<Moment>& moments) const {
    std::vector<std::pair<double, std::vector<double>>> states;
    for (const Moment& moment : moments) states.emplace_back(moment.t, moment.q);
    return poses(states);
  }

 private:
  std::string file_;
  oracles::Description description_;
};

inline Eigen::Vector3d origin(const Pose& pose) {
  return pose.col(3);
}
inline Eigen::Matrix3d axes(const Pose& pose) {
  return pose.leftCols<3>();
}
/// A point of the body in the world.
inline Eigen::Vector3d at(const Pose& pose, double x, double y, double z) {
  return axes(pose) * Eigen::Vector3d(x, y, z) + origin(pose);
}
/// A point of the world in the body.
inline Eigen::Vector3d seen_from(const Pose& pose, const Eigen::Vector3d& point) {
  return axes(pose).transpose() * (point - origin(pose));
}

}  // namespace alembert::test
