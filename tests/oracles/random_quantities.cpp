// Draws values (see the header).
#include "oracles/random_quantities.hpp"

namespace alembert::oracles {

QuantityWriter::QuantityWriter(std::uint64_t seed, const Description& given, const ForceUnits& units)
    : draw_(seed), units_(units) {
  for (const Coordinate& c : given.coordinates) (c.quaternion ? quaternions_ : reals_).push_back(c.name);
}

std::string QuantityWriter::constant(double low, double high, double unit) {
  const std::string value = decimal(unit * draw_.between(low, high));
  if (!draw_.chance(0.3)) return value;
  const std::string name = "k" + std::to_string(parameter_count_++);
  parameters_[name] = draw_.chance(0.6) ? "{value: " + value + ", runtime: true}" : value;
  return name;
}

std::string QuantityWriter::coordinate() {
  if (reals_.empty()) return decimal(draw_.between(0.1, 1));
  const std::string& name = one_of(reals_);
  return per(unit_of(name), name);
}

std::string QuantityWriter::any_speed() {
  const std::size_t reals = reals_.size();
  const auto which = static_cast<std::size_t>(draw_.below(static_cast<int>(reals + quaternions_.size())));
  if (which < reals) return per(unit_of(reals_[which]), "d(" + reals_[which] + ")");
  return "d(" + quaternions_[which - reals] + ")" + component();
}

std::string QuantityWriter::two_frames(const std::string& between) {
  const int first = draw_.below(static_cast<int>(frames_.size()) - 1);
  const int second = first + 1 + draw_.below(static_cast<int>(frames_.size()) - 1 - first);
  return frames_[static_cast<std::size_t>(first)] + between + frames_[static_cast<std::size_t>(second)];
}

std::string QuantityWriter::quantity() {
  switch (draw_.below(with_speeds_ ? 13 : 9)) {
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
      return length("length(path" + std::to_string(draw_.below(paths_)) + ")");
    case 9:
      return any_speed();
    case 10: {
      const std::string frame = one_of(frames_);
      return length("velocity(" + frame + ")" + component());
    }
    case 11: {
      const std::string frame = one_of(frames_);
      return "angular_velocity(" + frame + ")" + component();
    }
    default:
      return length("rate(path" + std::to_string(draw_.below(paths_)) + ")");
  }
}

std::string QuantityWriter::table(const std::string& function, const std::string& x) {
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

std::string QuantityWriter::value(int depth) {
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
    case 3:
      return a + "*" + x + "*abs(" + x + ")";
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

std::string QuantityWriter::three_values(double unit) {
  std::vector<std::string> entries;
  for (int i = 0; i < 3; ++i)
    entries.push_back(draw_.chance(0.3) ? decimal(unit * draw_.between(-2, 2)) : times(unit, value()));
  return list(entries);
}

std::string QuantityWriter::tension() {
  const std::string length = this->length("length"), rate = this->length("rate");
  switch (draw_.below(3)) {
    case 0: {
      const std::string stiff = constant(3, 20), rest = constant(0.1, 1), damp = constant(0.1, 0.5);
      return stiff + "*max(0, " + length + " - " + rest + ") + " + damp + "*" + rate;
    }
    case 1: {
      const std::string in = one_of(inputs_);
      return "(" + in + " + 1)*exp(-(" + length + " - 0.8)^2)*smoothstep(0.5 - " + rate + "/4)";
    }
    default:
      return value() + " + 0.5*" + length;
  }
}

}  // namespace alembert::oracles
