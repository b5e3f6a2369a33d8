// Draws what depends on the state of a mechanism (see the header).
#include "oracles/random_quantities.hpp"

namespace alembert::oracles {

RandomQuantities::RandomQuantities(const Description& given, std::uint64_t seed, const ForceUnits& units)
    : draw_(seed), units_(units) {
  for (const Coordinate& c : given.coordinates) (c.quaternion ? quaternions_ : reals_).push_back(c.name);
}

const std::string& RandomQuantities::one_of(const std::vector<std::string>& names) {
  return names[static_cast<std::size_t>(draw_.below(static_cast<int>(names.size())))];
}

std::string RandomQuantities::per(double unit, const std::string& x) {
  return unit == 1 ? x : "(" + x + "/" + decimal(unit) + ")";
}

std::string RandomQuantities::times(double unit, const std::string& x) {
  return unit == 1 ? x : decimal(unit) + "*(" + x + ")";
}

double RandomQuantities::unit_of(const std::string& coordinate) const {
  const auto found = units_.lengths.find(coordinate);
  return found == units_.lengths.end() ? 1 : found->second;
}

std::string RandomQuantities::constant(double low, double high, double unit) {
  const std::string value = decimal(unit * draw_.between(low, high));
  if (!draw_.chance(0.3)) return value;
  const std::string name = "k" + std::to_string(parameter_count_++);
  parameters_[name] = draw_.chance(0.6) ? "{value: " + value + ", runtime: true}" : value;
  return name;
}

std::string RandomQuantities::coordinate() {
  if (reals_.empty()) return decimal(draw_.between(0.1, 1));
  const std::string& name = one_of(reals_);
  return per(unit_of(name), name);
}

std::string RandomQuantities::any_speed() {
  const std::size_t reals = reals_.size();
  const auto which = static_cast<std::size_t>(draw_.below(static_cast<int>(reals + quaternions_.size())));
  if (which < reals) return per(unit_of(reals_[which]), "d(" + reals_[which] + ")");
  return "d(" + quaternions_[which - reals] + ")" + component();
}

std::string RandomQuantities::two_frames(const std::string& between) {
  const int first = draw_.below(static_cast<int>(frames_.size()) - 1);
  const int second = first + 1 + draw_.below(static_cast<int>(frames_.size()) - 1 - first);
  return frames_[static_cast<std::size_t>(first)] + between + frames_[static_cast<std::size_t>(second)];
}

std::string RandomQuantities::quantity() {
  switch (draw_.below(with_speeds_ ? 16 : 10)) {
    case 0:
    case 1:
      return coordinate();
    case 2:
      return "sin(" + decimal(draw_.between(0.5, 3)) + "*t)";
    case 3:
      return one_of(inputs_);
    case 4:
      return defined_.empty() ? one_of(inputs_) : one_of(defined_);
    case 5: {
      const std::string frame = one_of(frames_);
      return length("position(" + frame + ")" + component());
    }
    case 6: {
      const std::string frame = one_of(frames_), row = component();
      return "rotation(" + frame + ")" + row + component()[1];
    }
    case 7:
      return length("distance(" + two_frames(", ") + ")");
    case 8:
      return length("length(" + path(paths_) + ")");
    case 9:
      return one_of(states_);
    case 10:
      return any_speed();
    case 11: {
      const std::string frame = one_of(frames_);
      return length("velocity(" + frame + ")" + component());
    }
    case 12: {
      const std::string frame = one_of(frames_);
      return "angular_velocity(" + frame + ")" + component();
    }
    case 13:
      return outputs_.empty() ? one_of(states_) : one_of(outputs_);
    case 14:
      return path_ == 0 ? one_of(states_) : per(10 * units_.force, "tension(" + path(path_) + ")");
    default:
      return length("rate(" + path(paths_) + ")");
  }
}

std::string RandomQuantities::table(const std::string& function, const std::string& x) {
  const int knots = 2 + draw_.below(4);
  std::string at, through;
  double knot = draw_.between(-2, -1);
  for (int i = 0; i < knots; ++i) {
    at += (i > 0 ? ", " : "") + decimal(knot);
    through += (i > 0 ? ", " : "") + decimal(draw_.between(-2, 2));
    knot += draw_.between(0.3, 1.2);
  }
  const bool brackets = draw_.chance(0.7);
  return function + "(" + x + "; " +
         (brackets ? "[" + at + "]; [" + through + "])" : at + "; " + through + ")");
}

std::string RandomQuantities::value(int depth) {
  const auto argument = [&] {
    return depth > 0 && draw_.chance(0.35) ? "(" + value(depth - 1) + ")" : quantity();
  };
  const std::string x = argument(), a = constant(0.4, 3), c = decimal(draw_.between(0.05, 0.6));
  switch (draw_.below(17)) {
    case 0:
      return a + "*" + x + " + " + c;
    case 1:
      return a + "*tanh(" + x + ")";
    case 2:
      return a + "*sin(" + x + " + " + c + ")";
    case 3:  // at rest x may be zero, where a second derivative jumps
      return a + "*(" + x + " + " + c + ")*abs(" + x + " + " + c + ")";
    case 4:
      return a + "*min(" + x + ", " + argument() + " + " + c + ")";
    case 5:
      return a + "*max(" + c + ", " + x + ")^2";
    case 6:
      return "clamp(" + a + "*" + x + ", -0.7, 0.9)";
    case 7:
      return a + "*step(" + x + " - " + c + ")*" + argument();
    case 8:
      return a + "*smoothstep(" + x + " + 0.5)";
    case 9: {
      const std::string y = argument();
      return "select(" + x + " - " + c + ", " + a + "*" + y + ", " + argument() + ")";
    }
    case 10:
      return a + "*select(" + x + " + " + c + ", sqrt(" + x + " + " + c + "), 0)";
    case 11:
      return a + "*sign(" + x + " - " + c + ")*" + argument();
    case 12:
      return table("spline", x);
    case 13:
      return table("linear", x);
    case 14:
      return table("simm_spline", x);
    case 15:
      return a + "*max(" + x + ", " + argument() + " + " + c + ")";
    default:
      return a + "*exp(-" + x + "^2)";
  }
}

std::string RandomQuantities::three_values(double unit) {
  std::vector<std::string> entries;
  for (int i = 0; i < 3; ++i)
    entries.push_back(draw_.chance(0.3) ? decimal(unit * draw_.between(-2, 2)) : times(unit, value()));
  return list(entries);
}

std::string RandomQuantities::condition(int of) {
  const std::string c = decimal(draw_.between(0.05, 0.6));
  switch (draw_.below(6)) {
    case 0:
    case 1: {
      const std::string x = coordinate();
      return draw_.chance(0.5) ? x + " - " + c : c + " - " + x;
    }
    case 2: {
      const std::string x = coordinate();
      return "min(" + x + " + " + c + ", " + decimal(draw_.between(0.3, 1.2)) + " - " + x + ")";
    }
    case 3: {
      const std::string at = one_of(frames_);
      return length("position(" + at + ")" + component()) + " - " + c;
    }
    case 4: {
      if (of == 0) return one_of(states_) + " - " + c;
      const std::string x = length("length(" + path(of) + ")");
      return x + " - " + decimal(draw_.between(0.5, 1.5));
    }
    default: {
      const std::string x = one_of(draw_.chance(0.5) ? states_ : inputs_);
      return x + " + 0.2*" + coordinate() + " - " + c;
    }
  }
}

}  // namespace alembert::oracles
