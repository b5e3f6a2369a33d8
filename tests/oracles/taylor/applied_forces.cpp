// Virtual work (see the header).
#include "oracles/taylor/applied_forces.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace alembert::oracles {

namespace {

template <class R>
struct Layout;
template <class R>
std::vector<Jet<R>> variables_along(const Description& description, const StateOf<R>& state,
                                    const std::vector<Jet<R>>& q, const Layout<R>& along);

/// Where a path bends: a point in the world, held by a frame; and from there to the next, along an arc, if it is one.
template <class R>
struct Bend {
  std::size_t frame;
  Vector3<Jet<R>> point;
  std::optional<Jet<R>> arc = {};
};

/// The two points where a line leaves something round, and the arc between them; nothing where it passes it by. The tangent
/// points are worked out as vectors, as MuJoCo does it (see generator/mechanism/wrapped_path.hpp for the laws).
/// \param half  of a cylinder's length
template <class R>
std::vector<Bend<R>> bends_around(const std::vector<RigidMotion<Jet<R>>>& frames, const PathObstacle& around,
                                  const Jet<R>& r, double half, std::size_t from, std::size_t to) {
  using J = Jet<R>;
  using V = Vector3<J>;
  using std::acos;
  using std::sqrt;
  const RigidMotion<J>& own = frames[around.frame];
  const auto seen = [&](std::size_t frame) {
    const V away = frames[frame].translation + J(-1.0) * own.translation;
    return V{dot(own.column[0], away), dot(own.column[1], away), dot(own.column[2], away)};
  };
  V a = seen(from), b = seen(to), s{};
  if (around.side) s = seen(*around.side);
  const J begin = a[2], rise = b[2] - a[2];
  if (around.cylinder) a[2] = b[2] = s[2] = J(0.0);
  const J aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
  if (!(leading(aa - r * r) > 0) || !(leading(bb - r * r) > 0)) return {};
  const J whole_turn = J(4.0) * acos(J(0.0)), angle = acos(ab / sqrt(aa * bb)), reach_a = acos(r / sqrt(aa)),
          reach_b = acos(r / sqrt(bb));
  const J near = angle - reach_a - reach_b, far = whole_turn - angle - reach_a - reach_b;
  // Perpendicular to each point in the plane, of its length, towards the other one.
  const J area = sqrt(aa * bb - ab * ab);
  const V to_b = (aa / area) * b + (J(-1.0) * ab / area) * a,
          to_a = (bb / area) * a + (J(-1.0) * ab / area) * b;
  const auto tangents = [&](double sign) {
    return std::pair((r * r / aa) * a + (J(sign) * r * sqrt(aa - r * r) / aa) * to_b,
                     (r * r / bb) * b + (J(sign) * r * sqrt(bb - r * r) / bb) * to_a);
  };
  bool far_way = false;
  if (around.side) {
    const V step = b + J(-1.0) * a;
    const R part = (J(-1.0) * dot(a, step) / dot(step, step)).value;
    const J clamped = leading(part) < 0   ? J(0.0)
                      : leading(part) > 1 ? J(1.0)
                                          : J(-1.0) * dot(a, step) / dot(step, step);
    if (!(leading(near) > 0) && !(leading(dot(a + clamped * step, s)) < 0)) return {};
    const auto goodness = [&](double sign) {
      const auto [first, second] = tangents(sign);
      const V sum = first + second;
      return dot(sum, s) / sqrt(dot(sum, sum));
    };
    const J apart = reach_a - reach_b;
    const bool crosses = !(leading(near) > 0) && leading(angle) > std::abs(leading(apart));
    far_way = crosses || leading(goodness(-1) - goodness(1)) > 0;
  } else if (!(leading(near) > 0)) {
    return {};
  }
  const J arc = far_way ? far : leading(near) > 0 ? near : near + whole_turn;
  auto [first, second] = tangents(far_way ? -1 : 1);
  J length = r * arc;
  if (around.cylinder) {
    const J straight_a = sqrt(aa - r * r), all = straight_a + length + sqrt(bb - r * r);
    first[2] = begin + rise * straight_a / all;
    second[2] = begin + rise * (straight_a + length) / all;
    const auto beyond = [&](const V& point) { return std::abs(leading(point[2])) > half; };
    if (beyond(first) && beyond(second)) return {};
    const J climb = rise * length / all;
    length = sqrt(length * length + climb * climb);
  }
  const auto placed = [&](const V& p) {
    return own.translation + p[0] * own.column[0] + p[1] * own.column[1] + p[2] * own.column[2];
  };
  return {{around.frame, placed(first), length}, {around.frame, placed(second)}};
}

/// Frames, and the lengths of paths between them, as jets along a motion.
template <class R>
struct Layout {
  std::vector<RigidMotion<Jet<R>>> frames;
  std::vector<Jet<R>> lengths;
  std::vector<std::vector<Bend<R>>> ways;  ///< by path

  Layout(const Description& description, const StateOf<R>& state, const std::vector<Jet<R>>& q,
         const Jet<R>& t)
      : frames(frame_poses(description, q, t)) {
    for (const FramePath& path : description.paths) {
      if (path.value) {
        lengths.push_back(evaluate(path.value, variables_along(description, state, q, *this), t));
        ways.emplace_back();
        continue;
      }
      std::vector<Bend<R>> on_it;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        if (!point.when ||
            leading(evaluate(point.when, variables_along(description, state, q, *this), t)) > 0)
          on_it.push_back({point.frame, frames[point.frame].translation});
        const auto found = path.obstacles.find(i);
        if (found == path.obstacles.end()) continue;
        const PathObstacle& around = found->second;
        const std::vector<Jet<R>> values = variables_along(description, state, q, *this);
        const Jet<R> radius = evaluate(around.radius, values, t);
        const double half = around.length ? leading(evaluate(around.length, values, t)) / 2
                                          : std::numeric_limits<double>::infinity();
        for (const Bend<R>& bend :
             bends_around(frames, around, radius, half, point.frame, path.points[i + 1].frame))
          on_it.push_back(bend);
      }
      lengths.push_back(length_over(on_it));
      ways.push_back(std::move(on_it));
    }
  }

 private:
  /// Between frames that stay at one place there is no way.
  static Jet<R> length_over(const std::vector<Bend<R>>& bends) {
    Jet<R> length(0.0);
    for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
      if (bends[i].arc) {
        length = length + *bends[i].arc;
        continue;
      }
      const Vector3<Jet<R>> step = bends[i + 1].point + Jet<R>(-1.0) * bends[i].point;
      const Jet<R> square = dot(step, step);
      if (!vanishes(square)) length = length + sqrt(square);
    }
    return length;
  }
};

/// Values of variables, in the order of description/forces.hpp.
template <class S>
struct VariableList {
  std::vector<S> values;
  void add(const S& value) { values.push_back(value); }
  void add(const std::vector<S>& several) { values.insert(values.end(), several.begin(), several.end()); }
  void add(const Vector3<S>& three) { values.insert(values.end(), three.begin(), three.end()); }
};

/// Inputs and states, which have their initial values where the state says no other.
template <class R>
std::vector<R> given_numbers(const Description& description, const StateOf<R>& state) {
  std::vector<R> values;
  const auto add = [&values](const auto& given, const std::map<std::string, R>& at) {
    const auto found = at.find(given.name);
    values.push_back(found == at.end() ? R(given.initial) : found->second);
  };
  for (const Input& input : description.inputs) add(input, state.inputs);
  for (const Integrated& integrated : description.states) add(integrated, state.states);
  return values;
}

/// Row by row, each entry by `of`.
template <class S, class R, class Of>
void add_rotation(VariableList<S>& list, const RigidMotion<Jet<R>>& pose, Of of) {
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) list.add(of(pose.column[column][row]));
}

/// At the state itself; `moving` is along its motion in time.
template <class R>
std::vector<R> variables_at(const Description& description, const StateOf<R>& state,
                            const Layout<R>& moving) {
  const auto value = [](const Jet<R>& x) { return x.value; };
  const auto rate = [](const Jet<R>& x) { return x.first; };
  const auto each = [](const Vector3<Jet<R>>& v, auto of) {
    return Vector3<R>{of(v[0]), of(v[1]), of(v[2])};
  };
  VariableList<R> list;
  list.add(state.q);
  list.add(state.speeds);
  for (const auto& frame : moving.frames) list.add(each(frame.translation, value));
  list.add(given_numbers(description, state));
  for (const auto& frame : moving.frames) {
    list.add(each(frame.translation, rate));
    add_rotation(list, frame, value);
    list.add(angular_velocity(frame));
  }
  for (const Jet<R>& length : moving.lengths) {
    list.add(length.value);
    list.add(length.first);
  }
  return list.values;
}

/// Along one speed: what a potential is a function of. It is none of speeds, which are no numbers here. There are as
/// many lengths as are known so far.
template <class R>
std::vector<Jet<R>> variables_along(const Description& description, const StateOf<R>& state,
                                    const std::vector<Jet<R>>& q, const Layout<R>& along) {
  const Jet<R> none(std::numeric_limits<double>::quiet_NaN());
  VariableList<Jet<R>> list;
  list.add(q);
  list.add(std::vector<Jet<R>>(state.speeds.size(), none));
  for (const auto& frame : along.frames) list.add(frame.translation);
  for (const R& value : given_numbers(description, state)) list.add(Jet<R>(value, R(0.0), R(0.0)));
  for (const auto& frame : along.frames) {
    list.add(Vector3<Jet<R>>{none, none, none});
    add_rotation(list, frame, [](const Jet<R>& x) { return x; });
    list.add(Vector3<Jet<R>>{none, none, none});
  }
  for (const Jet<R>& length : along.lengths) {
    list.add(length);
    list.add(none);
  }
  return list.values;
}

/// How strong a force is, at a state: a number, or force and torque in world axes.
template <class R>
struct Strength {
  const std::vector<R>& variables;
  const R& t;
  const Layout<R>& layout;
  using Result = std::array<Vector3<R>, 2>;

  R value(const Expression& e) const { return evaluate(e, variables, t); }
  Vector3<R> in_world(const FrameForce& f, const Expression3& e) const {
    const Vector3<R> v{value(e[0]), value(e[1]), value(e[2])};
    if (f.world_axes) return v;
    Vector3<R> turned{R(0.0), R(0.0), R(0.0)};
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t i = 0; i < 3; ++i)
        turned[row] = turned[row] + layout.frames[f.frame].column[i][row].value * v[i];
    return turned;
  }
  static Result scalar(const R& x) { return {Vector3<R>{x, R(0.0), R(0.0)}, Vector3<R>{}}; }
  Result operator()(const SpeedForce& f) const { return scalar(value(f.value)); }
  Result operator()(const Potential&) const { return scalar(R(-1.0)); }
  Result operator()(const Tension& f) const { return scalar(-value(f.tension)); }
  Result operator()(const ForceAlong& f) const { return scalar(value(f.value)); }
  Result operator()(const FrameForce& f) const { return {in_world(f, f.force), in_world(f, f.torque)}; }
};

/// What it works along a unit of speed k, by its strength.
template <class R>
struct WorkAlong {
  int k;
  const std::vector<Jet<R>>& variables;
  const Jet<R>& t;
  const Layout<R>& layout;
  const typename Strength<R>::Result& strength;

  R operator()(const SpeedForce& f) const { return f.speed == k ? strength[0][0] : R(0.0); }
  R operator()(const Potential& f) const { return strength[0][0] * evaluate(f.value, variables, t).first; }
  R operator()(const Tension& f) const { return strength[0][0] * layout.lengths[f.path].first; }
  R operator()(const ForceAlong& f) const { return strength[0][0] * layout.lengths[f.path].first; }
  R operator()(const FrameForce& f) const {
    const RigidMotion<Jet<R>>& frame = layout.frames[f.frame];
    const Vector3<Jet<R>>& p = frame.translation;
    return dot(strength[0], Vector3<R>{p[0].first, p[1].first, p[2].first}) +
           dot(strength[1], angular_velocity(frame));
  }
};

template <class R>
std::vector<R> forces_of_coordinates(const Description& description, const StateOf<R>& state) {
  using std::tanh;
  std::vector<R> Q;
  for (const Coordinate& c : description.coordinates) {
    for (int i = 0; i < (c.quaternion ? 3 : 1); ++i) {
      const R& u = state.speeds[static_cast<std::size_t>(c.first_speed + i)];
      R force = R(-c.damping) * u;
      if (c.friction != 0) force = force - R(c.friction) * tanh(u / R(c.friction_velocity));
      if (c.stiffness != 0)
        force = force - R(c.stiffness) * (state.q[static_cast<std::size_t>(c.first_q)] - R(c.rest));
      Q.push_back(force);
    }
  }
  return Q;
}

template <class R>
Layout<R> moving_layout(const Description& description, const StateOf<R>& state) {
  const std::vector<R> no_rates(state.speeds.size(), R(0.0));
  return {description, state, trajectory(description, state, no_rates), Jet<R>(state.time, R(1.0), R(0.0))};
}

}  // namespace

template <class R>
std::vector<R> applied_forces(const Description& description, const StateOf<R>& state) {
  std::vector<R> Q = forces_of_coordinates(description, state);
  if (description.forces.empty()) return Q;
  const Layout<R> moving = moving_layout(description, state);
  const std::vector<R> variables = variables_at(description, state, moving);
  std::vector<typename Strength<R>::Result> strengths;
  for (const AppliedForce& force : description.forces)
    strengths.push_back(std::visit(Strength<R>{variables, state.time, moving}, force));
  const Jet<R> t(state.time, R(0.0), R(0.0));
  for (int k = 0; k < description.nv; ++k) {
    const std::vector<Jet<R>> q = unit_motion(description, state, k);
    const Layout<R> layout(description, state, q, t);
    const std::vector<Jet<R>> along = variables_along(description, state, q, layout);
    R& sum = Q[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < strengths.size(); ++i)
      sum = sum + std::visit(WorkAlong<R>{k, along, t, layout, strengths[i]}, description.forces[i]);
  }
  return Q;
}

namespace {

/// What forces do to frames that hold potentials and paths: a strength times the derivatives of these.
template <class R>
class FramePull {
 public:
  FramePull(const Description& description, const StateOf<R>& state)
      : description_(description),
        t_(state.time, R(0.0), R(0.0)),
        moving_(moving_layout(description, state)),
        variables_(variables_at(description, state, moving_)),
        positions_(state.q.size() + state.speeds.size()),
        after_(positions_ + 3 * description.frames.size() + description.inputs.size() +
               description.states.size()),
        on_(description.frames.size()) {}

  std::vector<FrameWrench<R>> of_all() {
    for (const AppliedForce& force : description_.forces) {
      const auto strength = std::visit(Strength<R>{variables_, t_.value, moving_}, force);
      if (const auto* at = std::get_if<FrameForce>(&force)) {
        on_[at->frame].force = on_[at->frame].force + strength[0];
        on_[at->frame].torque = on_[at->frame].torque + strength[1];
      } else if (const auto* tension = std::get_if<Tension>(&force)) {
        add_path(tension->path, strength[0][0]);
      } else if (const auto* along = std::get_if<ForceAlong>(&force)) {
        add_path(along->path, strength[0][0]);
      } else if (const auto* potential = std::get_if<Potential>(&force)) {
        add_expression(potential->value, strength[0][0]);
      }
    }
    return on_;
  }

 private:
  void add_path(std::size_t path, const R& strength) {
    if (const Expression& value = description_.paths[path].value)
      add_expression(value, strength);
    else
      add_line(path, strength);
  }
  void add_line(std::size_t path, const R& strength) {
    const auto at = [](const Vector3<Jet<R>>& p) { return Vector3<R>{p[0].value, p[1].value, p[2].value}; };
    const auto push_at = [&](const Bend<R>& bend, const Vector3<R>& push) {
      FrameWrench<R>& on = on_[bend.frame];
      on.force = on.force + push;
      on.torque =
          on.torque + cross(at(bend.point) + R(-1.0) * at(moving_.frames[bend.frame].translation), push);
    };
    const std::vector<Bend<R>>& way = moving_.ways[path];
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const Vector3<R> apart = at(way[i + 1].point) + R(-1.0) * at(way[i].point);
      if (way[i].arc || vanishes(dot(apart, apart))) continue;
      const Vector3<R> push = strength * normalized(apart);
      push_at(way[i], R(-1.0) * push);
      push_at(way[i + 1], push);
    }
  }
  void add_expression(const Expression& of, const R& strength) {
    const auto slope = [&](std::size_t variable) {
      std::vector<Jet<R>> moved;
      for (const R& x : variables_) moved.emplace_back(x, R(0.0), R(0.0));
      moved[variable].first = R(1.0);
      return strength * evaluate(of, moved, t_).first;
    };
    for (std::size_t frame = 0; frame < on_.size(); ++frame) {
      for (std::size_t i = 0; i < 3; ++i)
        on_[frame].force[i] = on_[frame].force[i] + slope(positions_ + 3 * frame + i);
      for (std::size_t column = 0; column < 3; ++column) {
        Vector3<R> axis, by;
        for (std::size_t row = 0; row < 3; ++row) {
          axis[row] = moving_.frames[frame].column[column][row].value;
          by[row] = slope(after_ + 15 * frame + 3 + 3 * row + column);
        }
        on_[frame].torque = on_[frame].torque + cross(axis, by);
      }
    }
    for (std::size_t path = 0; path < moving_.lengths.size(); ++path)
      if (const R by = slope(after_ + 15 * on_.size() + 2 * path); !vanishes(by)) add_path(path, by);
  }

  const Description& description_;
  Jet<R> t_;
  Layout<R> moving_;
  std::vector<R> variables_;
  std::size_t positions_, after_;  ///< of frames, and of what moves, among the variables
  std::vector<FrameWrench<R>> on_;
};

}  // namespace

template <class R>
std::vector<FrameWrench<R>> wrenches_on_frames(const Description& description, const StateOf<R>& state) {
  if (description.forces.empty()) return std::vector<FrameWrench<R>>(description.frames.size());
  return FramePull<R>(description, state).of_all();
}
template std::vector<FrameWrench<double>> wrenches_on_frames(const Description&, const StateOf<double>&);
template std::vector<FrameWrench<long double>> wrenches_on_frames(const Description&,
                                                                  const StateOf<long double>&);

template <class R>
R potential_of_forces(const Description& description, const StateOf<R>& state) {
  R sum(0.0);
  for (const Coordinate& c : description.coordinates) {
    if (c.quaternion) continue;
    const R stretch = state.q[static_cast<std::size_t>(c.first_q)] - R(c.rest);
    sum = sum + R(0.5 * c.stiffness) * stretch * stretch;
  }
  if (description.forces.empty()) return sum;
  const std::vector<R> variables = variables_at(description, state, moving_layout(description, state));
  for (const AppliedForce& force : description.forces) {
    if (const Potential* potential = std::get_if<Potential>(&force))
      sum = sum + evaluate(potential->value, variables, state.time);
  }
  return sum;
}

template <class R>
OutputsOf<R> numeric_outputs(const Description& description, const StateOf<R>& state) {
  OutputsOf<R> result;
  const std::vector<R> no_rates(state.speeds.size(), R(0.0));
  const std::vector<Jet<R>> q = trajectory(description, state, no_rates);
  const Layout<R> moving = moving_layout(description, state);
  const std::vector<R> now = variables_at(description, state, moving);
  const std::vector<Jet<R>> in_time = variables_along(description, state, q, moving);
  for (const Output& output : description.outputs) {
    result.values.push_back(evaluate(output.value, now, state.time));
    const Jet<R> moved = evaluate(output.value, in_time, Jet<R>(state.time, R(1.0), R(0.0)));
    result.rate.push_back(moved.first);
    result.bias.push_back(moved.second);
  }
  const Jet<R> t(state.time, R(0.0), R(0.0));
  for (int k = 0; k < description.nv; ++k) {
    const std::vector<Jet<R>> along_k = unit_motion(description, state, k);
    const std::vector<Jet<R>> variables =
        variables_along(description, state, along_k, Layout<R>(description, state, along_k, t));
    std::vector<R>& column = result.along.emplace_back();
    for (const Output& output : description.outputs)
      column.push_back(evaluate(output.value, variables, t).first);
  }
  return result;
}

template <class R>
std::vector<R> state_rates(const Description& description, const StateOf<R>& state) {
  const std::vector<R> variables = variables_at(description, state, moving_layout(description, state));
  std::vector<R> rates;
  for (const Integrated& integrated : description.states)
    rates.push_back(evaluate(integrated.rate, variables, state.time));
  return rates;
}

#define ALEMBERT_FORCES(R)                                                       \
  template std::vector<R> applied_forces(const Description&, const StateOf<R>&); \
  template R potential_of_forces(const Description&, const StateOf<R>&);         \
  template std::vector<R> state_rates(const Description&, const StateOf<R>&);
template OutputsOf<double> numeric_outputs(const Description&, const StateOf<double>&);
template OutputsOf<long double> numeric_outputs(const Description&, const StateOf<long double>&);
ALEMBERT_FORCES(double)
ALEMBERT_FORCES(long double)
ALEMBERT_FORCES(Jet<double>)
ALEMBERT_FORCES(Jet<long double>)
#undef ALEMBERT_FORCES

}  // namespace alembert::oracles
