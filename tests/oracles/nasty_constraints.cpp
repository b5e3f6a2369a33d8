// Draws frames and rows (see the header).
#include "oracles/nasty_constraints.hpp"

#include <algorithm>

namespace alembert::oracles {

namespace {

class NastyConstraintWriter {
 public:
  NastyConstraintWriter(RandomExpressions& draw, NastyNumbers& numbers, LateFunctions& late, bool is_late,
                        const Constrainable& of)
      : draw_(draw), numbers_(numbers), late_(late), is_late_(is_late), of_(of) {}

  ConstraintSections write() {
    int room = static_cast<int>(of_.speeds.size()) - 1;
    for (const RollingBody& body : of_.rolling) {
      if (room < 2) break;
      room -= 2;
      const std::string child = "[" + body.name + ", " + body.u2 + ", " + body.v2 + "]";
      const std::string parent = "[" + body.parent + ", " + body.u1 + ", " + body.v1 + "]";
      const bool swapped = draw_.chance(0.3);
      add("rolling, of: " + (swapped ? parent : child) + ", on: " + (swapped ? child : parent));
    }
    const int more = 1 + draw_.below(2);
    for (int i = 0; i < more && room > 0; ++i) {
      switch (draw_.below(4)) {
        case 0:
          room -= gear();
          break;
        case 1:
          room -= coupling();
          break;
        default:
          room -= loop(room);
      }
    }
    if (!out_.constraints.empty()) out_.constraints = "constraints:\n" + out_.constraints;
    return out_;
  }

 private:
  void add(const std::string& rest) {
    out_.constraints += "  - {name: c" + std::to_string(count_++) + ", type: " + rest + "}\n";
  }
  const std::string& any(const std::vector<std::string>& names) {
    return names[static_cast<std::size_t>(draw_.below(static_cast<int>(names.size())))];
  }

  /// A ratio: six digits, next to nothing, or a function.
  std::string ratio() {
    switch (draw_.below(4)) {
      case 0:
        return numbers_.tiny();
      case 1:
        return is_late_ ? late_.function(any(of_.angles), 1) : numbers_.number(0.2, 3);
      case 2:
        return "cos(" + any(of_.angles) + " + " + numbers_.right_angle() + ")";
      default:
        return numbers_.number(-3, 3);
    }
  }
  int gear() {
    if (of_.angles.empty()) return 0;
    const std::string first = numbers_.number(0.5, 2);
    std::string row = first + "*" + any(of_.speeds);
    const int terms = 1 + draw_.below(2);
    for (int i = 0; i < terms; ++i) {
      const std::string factor = ratio();
      row += " - (" + factor + ")*" + any(of_.speeds);
    }
    if (draw_.chance(0.3)) row += " - " + numbers_.number(0.1, 0.5) + "*cos(t)";
    add("pfaffian, rows: " + list({row}));
    return 1;
  }
  /// One coordinate follows another.
  int coupling() {
    if (of_.angles.empty()) return 0;
    const std::string a = any(of_.coordinates), b = any(of_.angles), factor = ratio();
    add("holonomic, equations: " + list({a + " - (" + factor + ")*sin(" + b + ") - " + numbers_.tiny()}));
    return 1;
  }

  /// A frame on a body (-1: the world).
  std::string frame(int body) {
    const std::string name = "loop" + std::to_string(frame_count_++);
    const std::string shift = numbers_.shift(), turn = numbers_.turn('x'), then = numbers_.shift();
    out_.frames += "  - {name: " + name + ", body: " + (body < 0 ? "world" : "body" + std::to_string(body)) +
                   ", transform: [" + shift + ", " + turn + ", " + then + "]}\n";
    return "position(" + name + ").";
  }
  int loop(int room) {
    const int from = of_.bodies - 1, to = draw_.below(of_.bodies) - 1;
    const std::string a = frame(from), b = frame(to);
    const auto difference = [&](char axis) { return a + axis + " - " + b + axis; };
    std::vector<std::string> equations;
    if (draw_.chance(0.3)) {
      std::string square;
      for (const char axis : {'x', 'y', 'z'}) square += "(" + difference(axis) + ")^2 + ";
      equations.push_back(square + numbers_.tiny(of_.length * of_.length));
    } else {
      for (const char axis : {'x', 'y', 'z'}) {
        if (static_cast<int>(equations.size()) < room && draw_.chance(0.6))
          equations.push_back(difference(axis));
      }
      if (equations.empty()) equations.push_back(difference('x'));
    }
    add("holonomic, equations: " + list(equations));
    return static_cast<int>(equations.size());
  }

  RandomExpressions& draw_;
  NastyNumbers& numbers_;
  LateFunctions& late_;
  bool is_late_;
  const Constrainable& of_;
  ConstraintSections out_;
  int count_ = 0, frame_count_ = 0;
};

}  // namespace

ConstraintSections nasty_constraints(RandomExpressions& draw, NastyNumbers& numbers, LateFunctions& late,
                                     bool is_late, const Constrainable& of) {
  return NastyConstraintWriter(draw, numbers, late, is_late, of).write();
}

}  // namespace alembert::oracles
