// Inertias that no body can have: bodies in, warnings out. Bodies that are fixed together are judged as one,
// since many files spread the inertia of one over several, and only the sum counts.
#include "mechanism/inertia_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "mechanism/loading.hpp"
#include "mechanism/symbols_below.hpp"
#include "mechanism/transform_checks.hpp"
#include "mechanism/transforms.hpp"
#include "support/error.hpp"
#include "support/overloaded.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert {
namespace {

constexpr double kInertiaTolerance = 1e-6;  // of the largest moment: inertias are written with so many digits
constexpr double kPointInertia = 1e-12;     // m^2, of the mass: it is a point then, and the rest is rounding

/// Of one or several bodies.
struct Inertia {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d about_centre = Eigen::Matrix3d::Zero();

  Inertia& operator+=(const Inertia& other) {
    about_centre += other.about_centre;
    const double both = mass + other.mass;
    if (both == 0) return *this;
    const Eigen::Vector3d apart = other.centre - centre;
    about_centre += mass * other.mass / both *
                    (apart.squaredNorm() * Eigen::Matrix3d::Identity() - apart * apart.transpose());
    centre += other.mass / both * apart;
    mass = both;
    return *this;
  }
  Inertia moved(const Eigen::Isometry3d& pose) const {
    return {mass, pose * centre, pose.linear() * about_centre * pose.linear().transpose()};
  }
};

/// What is wrong with the moments of an inertia, or nothing.
std::string objection_to(const Inertia& inertia) {
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia.about_centre, Eigen::EigenvaluesOnly)
          .eigenvalues();
  const double tolerance =
      std::max(kInertiaTolerance * moments.cwiseAbs().maxCoeff(), kPointInertia * inertia.mass);
  const std::string found =
      fmt::format("its principal moments are {:.6g}, {:.6g} and {:.6g}", moments[0], moments[1], moments[2]);
  if (moments[0] < -tolerance) return found + "; none can be negative";
  if (moments[0] + moments[1] < moments[2] - tolerance)
    return found + "; none can exceed the sum of the others";
  return {};
}

class InertiaChecks {
 public:
  explicit InertiaChecks(Loading& loading)
      : loading_(loading), bodies_(loading.mechanism.bodies), symbols_(loading.graph.symbol_count(), 0.0) {
    for (const auto& [symbol, value] : loading.initial_state)
      symbols_[loading.graph.symbol_index(symbol.ref().node())] = value;
  }

  void warn() {
    std::vector<std::size_t> doubtful;
    read_inertias();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!objection(inertias_[b]).empty()) doubtful.push_back(b);
    }
    if (doubtful.empty()) return;
    merge();
    for (const std::size_t b : doubtful) {
      const int whole = first_of_[b];
      if (whole < 0) continue;  // fixed to the world: it moves nothing
      const Inertia& all = merged_[static_cast<std::size_t>(whole)];
      const bool alone = std::ranges::count(first_of_, whole) == 1;
      const std::string wrong = all.mass == 0 ? objection(inertias_[b]) : objection_to(inertias_[b]);
      if (wrong.empty() || objection(all).empty()) continue;
      const auto place = loading_.inertia_places.find(bodies_[b].name);
      loading_.mechanism.warnings.push_back(
          {place == loading_.inertia_places.end() ? bodies_[b].where : place->second,
           fmt::format("no mass distribution has the inertia of body '{}'{}: {}; it is used as it is",
                       bodies_[b].name, alone ? "" : ", nor with what is fixed to it", wrong),
           {},
           all.mass == 0 ? "inertia without mass" : "inertia of no body"});
    }
  }

 private:
  static std::string objection(const Inertia& inertia) {
    if (inertia.mass == 0 && !inertia.about_centre.isZero(0)) return "it has no mass";
    return objection_to(inertia);
  }

  void read_inertias() {
    std::vector<Expr> entries;
    for (const Body& body : bodies_) {
      const auto& [mass, com, inertia] = body.mass_properties;
      entries.push_back(mass);
      entries.insert(entries.end(), com.entries.begin(), com.entries.end());
      entries.insert(entries.end(), inertia.entries.begin(), inertia.entries.end());
    }
    constexpr std::size_t kEntries = 13;
    const std::vector<double> values = evaluate(entries, symbols_);
    for (const double* v = values.data(); inertias_.size() < bodies_.size(); v += kEntries)
      inertias_.push_back({v[0], Eigen::Vector3d(v + 1), Eigen::Matrix3d(v + 4)});
  }

  /// Sums of what is fixed together, each at its first body.
  void merge() {
    const SymbolsBelow below(loading_.graph, loading_.mechanism);
    std::vector<bool> constant;
    std::vector<Expr> entries;
    for (const Body& body : bodies_) {
      constant.push_back(is_constant(body.transform, below));
      if (!constant.back()) continue;
      const std::vector<Expr> own = expressions_of(body.transform.factors, loading_.mechanism);
      entries.insert(entries.end(), own.begin(), own.end());
    }
    const std::vector<double> values = evaluate(entries, symbols_);
    const double* next = values.data();
    std::vector<Eigen::Isometry3d> poses;  // in the first body
    merged_ = inertias_;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const Body& body = bodies_[b];
      first_of_.push_back(static_cast<int>(b));
      poses.push_back(Eigen::Isometry3d::Identity());
      if (!constant[b]) continue;
      const Eigen::Isometry3d pose = pose_of(body.transform, next);
      first_of_[b] = body.parent < 0 ? -1 : first_of_[static_cast<std::size_t>(body.parent)];
      if (first_of_[b] < 0) continue;
      poses[b] = poses[static_cast<std::size_t>(body.parent)] * pose;
      merged_[static_cast<std::size_t>(first_of_[b])] += inertias_[b].moved(poses[b]);
    }
  }

  bool is_constant(const Transform& transform, const SymbolsBelow& below) const {
    return std::ranges::none_of(expressions_of(transform.factors, loading_.mechanism),
                                [&](const Expr& x) { return moves(below.kinds(x)); });
  }

  /// The pose of factors that are constant, from the values of their expressions, which are read off `next`.
  static Eigen::Isometry3d pose_of(const Transform& transform, const double*& next) {
    using Eigen::Isometry3d, Eigen::Vector3d, Eigen::AngleAxisd;
    const auto vector = [&] {
      next += 3;
      return Vector3d(next - 3);
    };
    const Overloaded pose_of_value{
        [&](const Translation&) { return Isometry3d(Eigen::Translation3d(vector())); },
        [&](const AxisRotation& turn) { return Isometry3d(AngleAxisd(*next++, Vector3d::Unit(turn.axis))); },
        [&](const VectorRotation&) {
          const Vector3d axis = vector();
          return Isometry3d(AngleAxisd(*next++, axis.normalized()));
        },
        [&](const RigidMatrix&) {
          Isometry3d rigid = Isometry3d::Identity();
          rigid.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(next);
          next += 9;
          rigid.translation() = vector();
          return rigid;
        },
        [](const OneOf<QuaternionRotation, CurveFrame, SurfaceFrame> auto&) -> Isometry3d {
          throw InternalError("a frame that always moves is taken for a constant");
        }};
    Isometry3d pose = Isometry3d::Identity();
    for (const Factor& factor : transform.factors) {
      const Isometry3d own = std::visit(pose_of_value, factor.value);
      pose = pose * (factor.inverse ? own.inverse() : own);
    }
    return pose;
  }

  Loading& loading_;
  const std::vector<Body>& bodies_;
  std::vector<double> symbols_;    ///< values at the initial state
  std::vector<Inertia> inertias_;  ///< by body
  std::vector<int> first_of_;      ///< by body: the first of those that it is fixed to; -1: the world
  std::vector<Inertia> merged_;    ///< by body, if it is the first
};

}  // namespace

void check_inertias(Loading& loading) {
  InertiaChecks(loading).warn();
}

}  // namespace alembert
