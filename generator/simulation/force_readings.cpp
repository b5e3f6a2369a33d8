// Forces along a motion (see the header).
#include "simulation/force_readings.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include "dynamics/recursions/frame_values.hpp"
#include "dynamics/recursions/outputs.hpp"
#include "viewer/value_units.hpp"

namespace alembert {

namespace {

constexpr const char* kAxes[] = {".x", ".y", ".z"};

/// Fills in what is read, and the expressions of it.
class ReadingsBuilder {
 public:
  ReadingsBuilder(const Mechanism& mechanism, ExprGraph& graph, Acting& acting)
      : mechanism_(mechanism), acting_(acting), units_(InitialValues(mechanism, graph)) {}

  /// Series first, then points; symbols of frames, paths and inputs with a law still stand in them.
  std::vector<Expr> build(std::span<const Expr> poses) {
    for (std::size_t i = 0; i < mechanism_.forces.size(); ++i) add_force(i, poses);
    for (const Parameter& parameter : mechanism_.parameters) {
      if (parameter.role == ParameterRole::parameter) continue;
      const Expr symbol = mechanism_.time.graph().symbol(parameter.name);
      std::vector<Series>& series = parameter.is_input() ? acting_.inputs : acting_.states;
      add(series, parameter.is_input() ? inputs_ : states_, parameter.name, units_.of(symbol), symbol);
      series.back().limits = parameter.limits;
    }
    for (const Output& output : mechanism_.outputs)
      add(acting_.outputs, outputs_, output.name, units_.of(output.value), output.value);
    std::vector<Expr> all;
    for (const std::vector<Expr>* some :
         {&forces_, &inputs_, &states_, &outputs_, &line_points_, &contact_points_})
      all.insert(all.end(), some->begin(), some->end());
    return all;
  }

 private:
  static void add(std::vector<Series>& series, std::vector<Expr>& values, const std::string& name,
                  const std::string& unit, const Expr& value) {
    series.push_back({name, {}, unit, {}});
    values.push_back(value);
  }
  void add_force(const std::string& name, const std::string& unit, const Expr& value) {
    add(acting_.forces, forces_, name, unit, value);
  }

  void add_force(std::size_t i, std::span<const Expr> poses) {
    const Force& force = mechanism_.forces[i];
    switch (force.kind) {
      case ForceKind::on_speed:
        add_force(force.name + axis_of(force), units_.along(force.speed), force.value);
        break;
      case ForceKind::along:
        add_force(force.name, "", force.value);
        break;
      case ForceKind::potential:
        add_force(force.name, "J", force.value);
        break;
      case ForceKind::path: {
        SceneLine line{acting_.forces.size(), {}};
        line.points.resize(add_line(force, poses));
        acting_.lines.push_back(std::move(line));
        add_force(force.name, "N", force.value);
        break;
      }
      case ForceKind::wrench:
        if (add_contact(force.name, poses)) return;
        add_vector(force.name, "N", force.force);
        add_vector(force.name + " torque", "N m", force.torque);
        break;
    }
  }

  /// Which speed of a quaternion, of those that `damping` and others act on alike.
  std::string axis_of(const Force& force) const {
    for (const Coordinate& coordinate : mechanism_.coordinates) {
      const int axis = force.speed - coordinate.first_speed;
      if (coordinate.nv() > 1 && axis >= 0 && axis < coordinate.nv()) return kAxes[axis];
    }
    return "";
  }

  /// The components that there are; one alone needs no axis.
  void add_vector(const std::string& name, const std::string& unit, const Vec3& vector) {
    int count = 0;
    for (const Expr& entry : vector.entries) count += entry.is_zero() ? 0 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!vector[i].is_zero()) add_force(count == 1 ? name : name + kAxes[i], unit, vector[i]);
    }
  }

  static Vec3 origin_of(int frame, std::span<const Expr> poses) {
    const std::span<const Expr> pose = poses.subspan(12 * static_cast<std::size_t>(frame), 12);
    return {{pose[3], pose[7], pose[11]}};
  }
  /// The number of points. One that the path does not lead over is where the one before it is.
  std::size_t add_line(const Force& force, std::span<const Expr> poses) {
    const std::size_t had = line_points_.size();
    const auto add = [&](const Vec3& point) {
      line_points_.insert(line_points_.end(), point.entries.begin(), point.entries.end());
    };
    Vec3 before = origin_of(force.path.front().frame, poses);
    for (std::size_t i = 0; i < force.path.size(); ++i) {
      const PathPoint& point = force.path[i];
      Vec3 origin = origin_of(point.frame, poses);
      if (point.when)
        for (std::size_t r = 0; r < 3; ++r)
          origin[r] = if_positive(*point.when, origin[r]) + unless_positive(*point.when, before[r]);
      add(origin);
      before = origin;
      if (const auto found = force.obstacles.find(i); found != force.obstacles.end())
        for (const Vec3& bend :
             bends(found->second, origin, origin_of(force.path[i + 1].frame, poses), poses))
          add(bend);
    }
    return (line_points_.size() - had) / 3;
  }
  /// Along an arc, from end to end.
  static std::vector<Vec3> bends(const PathObstacle& around, const Vec3& from, const Vec3& to,
                                 std::span<const Expr> poses) {
    constexpr int kPoints = 9;
    const std::span<const Expr> pose = poses.subspan(12 * static_cast<std::size_t>(around.frame), 12);
    const Mat3 axes{{pose[0], pose[1], pose[2], pose[4], pose[5], pose[6], pose[8], pose[9], pose[10]}};
    const Vec3 origin = origin_of(around.frame, poses);
    const auto seen = [&](const Vec3& point) { return transpose(axes) * (point - origin); };
    const std::optional<Vec3> side =
        around.side ? std::optional(seen(origin_of(*around.side, poses))) : std::nullopt;
    std::vector<Vec3> out = points_around(around.shape, seen(from), seen(to), side, kPoints);
    for (Vec3& point : out) point = origin + axes * point;
    return out;
  }

  /// The contact that the force is of, if it is of one: contacts have one or two forces each, in the same order.
  bool add_contact(const std::string& force, std::span<const Expr> poses) {
    const std::size_t next = acting_.contacts.size();
    if (next > 0 && mechanism_.contacts[next - 1].name == force) return true;
    if (next == mechanism_.contacts.size() || mechanism_.contacts[next].name != force) return false;
    const SphereContact& contact = mechanism_.contacts[next];
    acting_.contacts.push_back({acting_.forces.size(), {}});
    add_force(contact.name, "N", contact.strength);
    const Vec3 deepest = origin_of(contact.frame, poses) - contact.radius * contact.normal;
    contact_points_.insert(contact_points_.end(), deepest.entries.begin(), deepest.entries.end());
    return true;
  }

  const Mechanism& mechanism_;
  Acting& acting_;
  ValueUnits units_;
  std::vector<Expr> forces_, inputs_, states_, outputs_, line_points_, contact_points_;
};

}  // namespace

ForceReadings::ForceReadings(const CompiledMechanism& compiled) {
  const Mechanism& mechanism = *compiled.mechanism;
  if (mechanism.forces.empty() && mechanism.outputs.empty() &&
      std::ranges::none_of(mechanism.parameters, &Parameter::is_state))
    return;
  ExprGraph& graph = *compiled.graph;
  const SpeedDerivatives derivatives(mechanism, graph);
  const MotionTree tree = motion_tree(mechanism, derivatives, graph);
  const std::vector<Expr> poses = frame_poses(mechanism, tree, graph);
  std::vector<Expr> values = with_moving_values(ReadingsBuilder(mechanism, graph, empty_).build(poses),
                                                mechanism, tree, derivatives, graph);
  program_ = StateProgram(std::move(values), compiled);
}

std::span<const double> ForceReadings::forces(const EvaluationState& state) {
  return program_(state).first(empty_.forces.size());
}

void ForceReadings::append(const EvaluationState& state, Acting& acting) {
  if (program_.empty()) return;
  std::span<const double> rest = program_(state);
  const auto next = [&](std::size_t count) {
    const std::span<const double> values = rest.first(count);
    rest = rest.subspan(count);
    return values;
  };
  for (std::vector<Series>* all : {&acting.forces, &acting.inputs, &acting.states, &acting.outputs})
    for (Series& series : *all) series.values.push_back(next(1)[0]);
  const auto add_point = [&](std::vector<Eigen::Vector3d>& points) {
    points.emplace_back(Eigen::Map<const Eigen::Vector3d>(next(3).data()));
  };
  for (SceneLine& line : acting.lines)
    for (std::vector<Eigen::Vector3d>& points : line.points) add_point(points);
  for (SceneContact& contact : acting.contacts) add_point(contact.points);
}

}  // namespace alembert
