// Models of OpenSim as `alembert import` describes them, and states of both.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "oracles/osim/skeleton.hpp"
#include "oracles/state.hpp"

namespace alembert::oracles {

/// A file that goes with the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& extension);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// The description that a model becomes, in a file of its own.
class Imported {
 public:
  /// Throws std::runtime_error with what the import said if it refuses.
  explicit Imported(const std::string& model);
  std::string path() const { return file_.path(); }
  std::string text() const;
  const Description& description() const { return description_; }

 private:
  TemporaryFile file_{".yaml"};
  Description description_;
};

/// A state by the names of coordinates.
struct NamedMotion {
  std::map<std::string, double> q, u;
  std::vector<std::string> order;
  double time = 0;
  NamedMotion(const Description& description, const State& state);
  void apply(OsimSkeleton& skeleton) const { skeleton.set(q, u, time); }
};

/// Derivatives of a function of the skeleton's position by the coordinates in order, by differences of four points.
Eigen::VectorXd numeric_gradient(OsimSkeleton& skeleton, const NamedMotion& motion,
                                 const std::function<double(const OsimSkeleton&)>& of);

/// Length of the lines through the points of a <GeometryPath>, and around what they wrap over (wraps.hpp).
double path_length(const OsimSkeleton& skeleton, pugi::xml_node path);

/// Forces of the model that act.
std::vector<pugi::xml_node> acting_forces(pugi::xml_node model);

}  // namespace alembert::oracles
