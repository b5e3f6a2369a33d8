// Draws frames and rows (see the header).
#include "oracles/random_constraints.hpp"

namespace alembert::oracles {

namespace {

class ConstraintWriter {
 public:
  ConstraintWriter(RandomExpressions& draw, int bodies) : draw_(draw), bodies_(bodies) {}

  std::string write(const std::vector<RollingBody>& rolling) {
    int room = draw_.speeds() - 1;
    for (const RollingBody& body : rolling) {
      if (room < 2 || draw_.chance(0.2)) continue;
      room -= 2;
      const bool swapped = draw_.chance(0.3);
      const std::string child = "[" + body.name + ", " + body.u2 + ", " + body.v2 + "]";
      const std::string parent = "[" + body.parent + ", " + body.u1 + ", " + body.v1 + "]";
      add("rolling, of: " + (swapped ? parent : child) + ", on: " + (swapped ? child : parent));
    }
    const int more = draw_.below(3);
    for (int i = 0; i < more && room > 0; ++i) room -= draw_.chance(0.4) ? pfaffian(room) : holonomic(room);
    if (constraints_.empty()) return "";
    return (frames_.empty() ? "" : "frames:\n" + frames_) + "constraints:\n" + constraints_;
  }

 private:
  void add(const std::string& rest) {
    constraints_ += "  - {name: c" + std::to_string(count_++) + ", type: " + rest + "}\n";
  }

  std::string row() {
    std::string text;
    const int terms = 1 + draw_.below(3);
    for (int i = 0; i < terms; ++i) {
      const std::string speed = draw_.any_speed();
      const std::string coordinate = draw_.any_coordinate();
      const std::string factor = draw_.chance(0.3) ? draw_.constant(0.4, 1.4) : draw_.curved(coordinate);
      text += (i == 0 ? "(" : " + (") + factor + ")*" + speed;
    }
    if (draw_.chance(0.3)) {
      const std::string size = decimal(draw_.between(0.1, 0.5));
      const std::string coordinate = draw_.any_coordinate();
      text += " - " + size + "*cos(t + " + coordinate + ")";
    }
    return text;
  }
  int pfaffian(int room) {
    std::vector<std::string> rows{row()};
    if (room > 1 && draw_.chance(0.4)) rows.push_back(row());
    add("pfaffian, rows: " + list(rows));
    return static_cast<int>(rows.size());
  }

  /// A frame somewhere on a body (-1: the world).
  std::string frame(int body) {
    const std::string name = "f" + std::to_string(frame_count_++);
    const std::string x = decimal(draw_.between(-0.5, 0.5)), y = decimal(draw_.between(-0.5, 0.5)),
                      z = decimal(draw_.between(-0.5, 0.5));
    const std::string about = draw_.axis();
    frames_ += "  - {name: " + name + ", body: " + (body < 0 ? "world" : "body" + std::to_string(body)) +
               ", transform: [{rotate: {axis: " + about + ", angle: 0.4}}, {translate: " + list({x, y, z}) +
               "}]}\n";
    return "position(" + name + ").";
  }
  int holonomic(int room) {
    if (draw_.chance(0.25)) {
      const std::string a = draw_.any_coordinate();
      const std::string b = draw_.any_coordinate();
      const std::string f = draw_.curved(a);
      const std::string g = draw_.curved(b);
      add("holonomic, equations: " + list({f + " - 0.7*(" + g + ") - 0.2*sin(t)"}));
      return 1;
    }
    const int first = draw_.below(bodies_);
    const int second = draw_.below(first + 1) - 1;
    const std::string a = frame(first), b = frame(second);
    const auto difference = [&](char axis) { return a + axis + " - " + b + axis; };
    std::vector<std::string> equations;
    if (draw_.chance(0.3)) {
      std::string square;
      for (const char axis : {'x', 'y', 'z'}) square += "(" + difference(axis) + ")^2 + ";
      equations.push_back(square + "t - 1.2");
    } else {
      for (const char axis : {'x', 'y', 'z'}) {
        if (static_cast<int>(equations.size()) < room && draw_.chance(0.6))
          equations.push_back(difference(axis));
      }
      if (equations.empty()) equations.push_back(difference('x') + " + 0.1*cos(t)");
    }
    add("holonomic, equations: " + list(equations));
    return static_cast<int>(equations.size());
  }

  RandomExpressions& draw_;
  int bodies_;
  int count_ = 0, frame_count_ = 0;
  std::string frames_, constraints_;
};

}  // namespace

std::string random_constraints(RandomExpressions& draw, int bodies, const std::vector<RollingBody>& rolling) {
  return ConstraintWriter(draw, bodies).write(rolling);
}

}  // namespace alembert::oracles
