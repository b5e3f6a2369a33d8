#include "oracles/osim/imported.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "oracles/alembert_process.hpp"
#include "oracles/osim/wraps.hpp"

namespace alembert::oracles {

TemporaryFile::TemporaryFile(const std::string& extension) {
  static int count = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("alembert_osim_" + std::to_string(getpid()) + "_" + std::to_string(++count) + extension);
}

TemporaryFile::~TemporaryFile() {
  std::filesystem::remove(path_);
}

Imported::Imported(const std::string& model) {
  const Run run = run_alembert(ALEMBERT_EXECUTABLE, {"import", model, "--out", path()}, "");
  if (run.status != 0) throw std::runtime_error(run.err);
  description_ = read_description(path());
}

std::string Imported::text() const {
  std::ifstream file(path());
  return {std::istreambuf_iterator<char>(file), {}};
}

NamedMotion::NamedMotion(const Description& description, const State& state) : time(state.time) {
  for (const Coordinate& c : description.coordinates) {
    q[c.name] = state.q[static_cast<std::size_t>(c.first_q)];
    u[c.name] = state.speeds[static_cast<std::size_t>(c.first_speed)];
    order.push_back(c.name);
  }
}

Eigen::VectorXd numeric_gradient(OsimSkeleton& skeleton, const NamedMotion& motion,
                                 const std::function<double(const OsimSkeleton&)>& of) {
  constexpr double kStep = 2e-4;
  Eigen::VectorXd out(static_cast<Eigen::Index>(motion.order.size()));
  for (std::size_t k = 0; k < motion.order.size(); ++k) {
    const auto at = [&](double steps) {
      NamedMotion moved = motion;
      moved.q[motion.order[k]] += steps * kStep;
      moved.apply(skeleton);
      return of(skeleton);
    };
    out(static_cast<Eigen::Index>(k)) = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * kStep);
  }
  motion.apply(skeleton);
  return out;
}

double path_length(const OsimSkeleton& skeleton, pugi::xml_node path) {
  const auto text = [](pugi::xml_node point, std::initializer_list<const char*> names) {
    for (const char* name : names)
      for (const char* end : {"", "_connectee_name"})
        if (const pugi::xml_node found = point.child((std::string(name) + end).c_str()))
          return std::string(found.child_value());
    return std::string();
  };
  const auto coordinate = [&](const std::string& path_to) {
    return skeleton.coordinate(path_to.substr(path_to.find_last_of('/') + 1));
  };
  std::vector<PathStop> points;
  std::size_t number = 0;
  for (const pugi::xml_node point : path.child("PathPointSet").child("objects").children()) {
    if (point.type() != pugi::node_element) continue;
    const std::string type = point.name();
    const std::size_t here = number++;
    SimTK::Vec3 location(0);
    if (type == "MovingPathPoint") {
      for (int i = 0; i < 3; ++i) {
        const std::string letter(1, static_cast<char>('x' + i));
        const std::string of =
            text(point, {("socket_" + letter + "_coordinate").c_str(), (letter + "_coordinate").c_str()});
        const pugi::xml_node law = law_element(point, (letter + "_location").c_str());
        location[i] = read_law(law, 1).value({of.empty() ? 0 : coordinate(of)});
      }
    } else {
      const std::vector<double> given = numbers_in(point.child("location"));
      location = SimTK::Vec3(given[0], given[1], given[2]);
    }
    if (type == "ConditionalPathPoint") {
      const std::vector<double> range = numbers_in(point.child("range"));
      const double q = coordinate(text(point, {"socket_coordinate", "coordinate"}));
      if (q < range[0] || q > range[1]) continue;
    }
    const auto has_condition = [](pugi::xml_node of) {
      return of.name() == std::string("ConditionalPathPoint");
    };
    points.push_back({skeleton.point(text(point, {"socket_parent_frame", "body"}), location), here,
                      has_condition(point) || has_condition(point.next_sibling())});
  }
  return wrapped_length(skeleton, path, points);
}

std::vector<pugi::xml_node> acting_forces(pugi::xml_node model) {
  std::vector<pugi::xml_node> out;
  for (const pugi::xml_node force : model.child("ForceSet").child("objects").children()) {
    const std::string applies = force.child("appliesForce").child_value(),
                      off = force.child("isDisabled").child_value();
    if (force.type() == pugi::node_element && applies != "false" && off != "true") out.push_back(force);
  }
  return out;
}

}  // namespace alembert::oracles
