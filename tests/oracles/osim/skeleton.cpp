#include "oracles/osim/skeleton.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace alembert::oracles {
namespace {

using SimTK::MobilizedBody;
using SimTK::Transform;
using SimTK::Vec3;

Vec3 vec3(pugi::xml_node element, const Vec3& otherwise = Vec3(0)) {
  const std::vector<double> n = numbers_in(element);
  return n.size() == 3 ? Vec3(n[0], n[1], n[2]) : otherwise;
}

Transform offset(pugi::xml_node shift, pugi::xml_node turn) {
  const Vec3 a = vec3(turn);
  return {SimTK::Rotation(SimTK::BodyRotationSequence, a[0], SimTK::XAxis, a[1], SimTK::YAxis, a[2],
                          SimTK::ZAxis),
          vec3(shift)};
}

std::string last_of(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

std::string text_of(pugi::xml_node element, const char* child) {
  const std::string older = std::string(child) + "_connectee_name";
  std::string text = element.child(element.child(child) ? child : older.c_str()).child_value();
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  return text.substr(std::min(text.find_first_not_of(" \t\n"), text.size()));
}

std::vector<std::string> words_in(pugi::xml_node element) {
  std::istringstream text(element.child_value());
  std::vector<std::string> out;
  for (std::string word; text >> word;) out.push_back(word);
  return out;
}

bool is_true(pugi::xml_node element, const char* child) {
  return text_of(element, child) == "true";
}

std::vector<pugi::xml_node> coordinate_elements(pugi::xml_node joint) {
  std::vector<pugi::xml_node> out;
  for (const pugi::xml_node c : joint.child("coordinates").children("Coordinate")) out.push_back(c);
  for (const pugi::xml_node c : joint.child("CoordinateSet").child("objects").children("Coordinate"))
    out.push_back(c);
  return out;
}

}  // namespace

OsimSkeleton::OsimSkeleton(const std::string& file) {
  if (!document_.load_file(file.c_str())) throw std::runtime_error("no XML: " + file);
  model_ = document_.document_element().child("Model");
  bodies_["ground"] = matter_.updGround();
  std::vector<pugi::xml_node> joints;
  for (const pugi::xml_node body : model_.child("BodySet").child("objects").children("Body")) {
    const std::string name = body.attribute("name").value();
    if (name == "ground") continue;
    const Vec3 com = vec3(body.child("mass_center"));
    std::vector<double> I = numbers_in(body.child("inertia"));
    if (I.empty())
      for (const char* entry : {"xx", "yy", "zz", "xy", "xz", "yz"})
        I.push_back(body.child((std::string("inertia_") + entry).c_str()).text().as_double());
    const double mass = body.child("mass").text().as_double();
    // Simbody doubts inertias that published models have.
    SimTK::Inertia central;
    const_cast<SimTK::SymMat33&>(central.asSymMat33()) = SimTK::SymMat33(I[0], I[3], I[1], I[4], I[5], I[2]);
    SimTK::SymMat33 about = central.asSymMat33();
    const Vec3 p = com;
    about += mass * SimTK::SymMat33(p[1] * p[1] + p[2] * p[2], -p[0] * p[1], p[0] * p[0] + p[2] * p[2],
                                    -p[0] * p[2], -p[1] * p[2], p[0] * p[0] + p[1] * p[1]);
    if (mass > 0) {
      SimTK::UnitInertia unit;
      const_cast<SimTK::SymMat33&>(unit.asSymMat33()) = about / mass;
      SimTK::MassProperties properties;
      properties.setMassProperties(mass, com, unit);
      rigid_[name] = SimTK::Body::Rigid(properties);
    } else {
      rigid_[name] = SimTK::Body::Rigid(SimTK::MassProperties(0, Vec3(0), SimTK::Inertia(0)));
    }
    for (const pugi::xml_node joint : body.child("Joint").children()) joints.push_back(joint);
  }
  for (const pugi::xml_node joint : model_.child("JointSet").child("objects").children())
    if (joint.type() == pugi::node_element) joints.push_back(joint);
  read_frames();
  const std::vector<std::string> free = without_joint(joints);
  const std::vector<pugi::xml_node> closing = take_closing(joints, free);
  for (const std::string& body : free) {
    const MobilizedBody moved =
        MobilizedBody::Free(matter_.updGround(), Transform(), rigid_.at(body), Transform());
    bodies_[body] = moved;
    for (int i = 0; i < 6; ++i) slots_["free_" + body + "_coord_" + std::to_string(i)] = {moved, i};
  }
  for (std::size_t added = 1; added > 0 && !joints.empty();) {
    const std::size_t before = joints.size();
    std::vector<pugi::xml_node> left;
    for (const pugi::xml_node joint : joints)
      if (!add_joint(joint)) left.push_back(joint);
    added = before - left.size();
    joints = left;
  }
  if (!joints.empty()) throw std::runtime_error("joints that the ground does not reach");
  for (const pugi::xml_node joint : closing) add_closing(joint);
  read_followers();
  add_contacts();
  state_ = system_.realizeTopology();
  matter_.setUseEulerAngles(state_, true);
  system_.realizeModel(state_);
}

void OsimSkeleton::read_frames() {
  struct Walker : pugi::xml_tree_walker {
    std::vector<pugi::xml_node> found;
    bool for_each(pugi::xml_node& node) override {
      const std::string kind = node.name();
      if (kind == "PhysicalOffsetFrame" || kind == "StationDefinedFrame" || kind == "Station" ||
          kind == "Marker")
        found.push_back(node);
      return true;
    }
  } walker;
  model_.traverse(walker);
  for (const pugi::xml_node frame : walker.found)
    frames_[std::string(frame.parent().parent().attribute("name").value()) + "/" +
            frame.attribute("name").value()] = frame;
}

OsimSkeleton::Place OsimSkeleton::find(const std::string& socket, const std::string& owner) const {
  const std::string name = socket == ".." ? owner : last_of(socket);
  auto frame = frames_.find(owner + "/" + name);
  if (frame == frames_.end() && (name == "ground" || rigid_.count(name) > 0)) return {name, Transform()};
  if (frame == frames_.end()) {
    const std::string before = socket.substr(0, socket.size() - std::min(socket.size(), name.size() + 1));
    frame = frames_.find(last_of(before) + "/" + name);
  }
  for (auto any = frames_.begin(); frame == frames_.end() && any != frames_.end(); ++any)
    if (last_of(any->first) == name) frame = any;
  if (frame == frames_.end()) throw std::runtime_error("no frame " + socket);
  const pugi::xml_node element = frame->second;
  const std::string its_owner = frame->first.substr(0, frame->first.find('/'));
  if (element.name() == std::string("StationDefinedFrame")) return find_by_stations(element);
  if (element.name() != std::string("PhysicalOffsetFrame")) {
    Place place = find(text_of(element, "socket_parent_frame"), its_owner);
    place.in_body = place.in_body * Transform(vec3(element.child("location")));
    return place;
  }
  Place place = find(text_of(element, "socket_parent"), its_owner);
  place.in_body = place.in_body * offset(element.child("translation"), element.child("orientation"));
  return place;
}

OsimSkeleton::Place OsimSkeleton::find_by_stations(pugi::xml_node frame) const {
  const auto station = [&](const char* socket) { return find(text_of(frame, socket), ""); };
  const Place origin = station("socket_origin_point");
  const Vec3 a = station("socket_point_a").in_body.p();
  const Vec3 ab = station("socket_point_b").in_body.p() - a, ac = station("socket_point_c").in_body.p() - a;
  const auto axis = [&](const char* property, const SimTK::CoordinateAxis& otherwise) {
    const std::string text = text_of(frame, property);
    return text.empty() ? otherwise : SimTK::CoordinateAxis(text.back() - 'x');
  };
  const auto signed_by = [&](const char* property, const Vec3& v) {
    return SimTK::UnitVec3(text_of(frame, property)[0] == '-' ? Vec3(-v) : v);
  };
  // Simbody makes the second direction normal to the first, which it is already.
  return {origin.body, Transform(SimTK::Rotation(signed_by("ab_axis", ab), axis("ab_axis", SimTK::XAxis),
                                                 signed_by("ab_x_ac_axis", SimTK::cross(ab, ac)),
                                                 axis("ab_x_ac_axis", SimTK::YAxis)),
                                 origin.in_body.p())};
}

std::pair<OsimSkeleton::Place, OsimSkeleton::Place> OsimSkeleton::ends(pugi::xml_node joint) const {
  const std::string name = joint.attribute("name").value();
  Place parent, child;
  if (!text_of(joint, "socket_parent_frame").empty()) {
    parent = find(text_of(joint, "socket_parent_frame"), name);
    child = find(text_of(joint, "socket_child_frame"), name);
  } else {
    parent = {text_of(joint, "parent_body"),
              offset(joint.child("location_in_parent"), joint.child("orientation_in_parent"))};
    child = {joint.parent().parent().attribute("name").value(),
             offset(joint.child("location"), joint.child("orientation"))};
    if (is_true(joint, "reverse")) std::swap(parent, child);
  }
  return {parent, child};
}

std::vector<std::string> OsimSkeleton::without_joint(const std::vector<pugi::xml_node>& joints) const {
  SimTK::MultibodyGraphMaker graph;
  graph.addJointType("joint", 1, false);
  graph.addBody("ground", 0, false);
  for (const pugi::xml_node body : model_.child("BodySet").child("objects").children("Body"))
    if (const std::string name = body.attribute("name").value(); name != "ground")
      graph.addBody(name, 1, false);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto [parent, child] = ends(joints[i]);
    graph.addJoint(std::to_string(i), "joint", parent.body, child.body, false);
  }
  graph.generateGraph();
  std::vector<std::string> out;
  for (int i = 0; i < graph.getNumJoints(); ++i)
    if (const auto& joint = graph.getJoint(i); joint.isAddedBaseJoint)
      out.push_back(graph.getBody(joint.childBodyNum).name);
  return out;
}

std::vector<pugi::xml_node> OsimSkeleton::take_closing(std::vector<pugi::xml_node>& joints,
                                                       const std::vector<std::string>& free) {
  std::set<std::string> reached(free.begin(), free.end());
  reached.insert("ground");
  std::vector<pugi::xml_node> tree;
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const pugi::xml_node joint : joints) {
      if (std::find(tree.begin(), tree.end(), joint) != tree.end()) continue;
      const auto [parent, child] = ends(joint);
      if (reached.count(parent.body) == reached.count(child.body)) continue;
      reached.insert(parent.body);
      reached.insert(child.body);
      tree.push_back(joint);
    }
  }
  std::vector<pugi::xml_node> closing;
  std::map<std::string, int> shares;
  for (const pugi::xml_node joint : joints) {
    if (std::find(tree.begin(), tree.end(), joint) != tree.end()) continue;
    const auto [parent, child] = ends(joint);
    if (joint.name() != std::string("WeldJoint")) ++shares[child.body == "ground" ? parent.body : child.body];
    closing.push_back(joint);
  }
  for (const auto& [body, copies] : shares) {
    SimTK::MassProperties mass = rigid_.at(body).getDefaultRigidBodyMassProperties();
    mass.setMassProperties(mass.getMass() / (copies + 1), mass.getMassCenter(), mass.getUnitInertia());
    rigid_[body] = SimTK::Body::Rigid(mass);
  }
  joints = tree;
  return closing;
}

void OsimSkeleton::add_closing(pugi::xml_node joint) {
  if (joint.name() == std::string("WeldJoint")) return;
  auto [parent, child] = ends(joint);
  const bool backward = child.body == "ground";
  if (backward) std::swap(parent, child);
  bodies_[child.body + " at " + joint.attribute("name").value()] =
      add_mobilizers(joint, bodies_.at(parent.body), parent.in_body, rigid_.at(child.body), child.in_body,
                     backward ? MobilizedBody::Reverse : MobilizedBody::Forward);
}

bool OsimSkeleton::add_joint(pugi::xml_node joint) {
  auto [parent, child] = ends(joint);
  const bool forward = bodies_.count(parent.body) > 0, backward = bodies_.count(child.body) > 0;
  if (forward == backward) return false;
  if (backward) std::swap(parent, child);
  bodies_[child.body] =
      add_mobilizers(joint, bodies_.at(parent.body), parent.in_body, rigid_.at(child.body), child.in_body,
                     backward ? MobilizedBody::Reverse : MobilizedBody::Forward);
  return true;
}

MobilizedBody OsimSkeleton::add_mobilizers(pugi::xml_node joint, MobilizedBody inboard, const Transform& in,
                                           const SimTK::Body& body, const Transform& out,
                                           MobilizedBody::Direction direction) {
  const std::string type = joint.name();
  std::vector<std::string> names;
  for (const pugi::xml_node c : coordinate_elements(joint)) names.push_back(c.attribute("name").value());
  const auto slots = [&](const MobilizedBody& moved, std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count && first + i < names.size(); ++i)
      slots_[names[first + i]] = {moved, static_cast<int>(i)};
    return moved;
  };
  const auto all = [&](const MobilizedBody& moved) { return slots(moved, 0, names.size()); };
  if (type == "PinJoint") return all(MobilizedBody::Pin(inboard, in, body, out, direction));
  if (type == "SliderJoint") return all(MobilizedBody::Slider(inboard, in, body, out, direction));
  if (type == "WeldJoint") return MobilizedBody::Weld(inboard, in, body, out);
  if (type == "UniversalJoint") return all(MobilizedBody::Universal(inboard, in, body, out, direction));
  if (type == "BallJoint") return all(MobilizedBody::Ball(inboard, in, body, out, direction));
  if (type == "GimbalJoint") return all(MobilizedBody::Gimbal(inboard, in, body, out, direction));
  if (type == "FreeJoint") return all(MobilizedBody::Free(inboard, in, body, out, direction));
  if (type == "PlanarJoint") return all(MobilizedBody::Planar(inboard, in, body, out, direction));
  if (type == "EllipsoidJoint") {
    MobilizedBody::Ellipsoid ellipsoid(inboard, in, body, out, direction);
    ellipsoid.setDefaultRadii(vec3(joint.child("radii_x_y_z")));
    return all(ellipsoid);
  }
  if (type == "ScapulothoracicJoint") {
    const SimTK::Rotation quarter(SimTK::Pi / 2, SimTK::ZAxis);
    const Vec3 r = vec3(joint.child("thoracic_ellipsoid_radii_x_y_z"));
    MobilizedBody::Ellipsoid on(inboard, in * Transform(quarter), SimTK::Body::Massless(),
                                Transform(quarter));
    on.setDefaultRadii(Vec3(r[1], r[0], r[2]));
    slots(on, 0, 3);
    const std::vector<double> o = numbers_in(joint.child("scapula_winging_axis_origin"));
    const double w = joint.child("scapula_winging_axis_direction").text().as_double();
    const Transform wing(SimTK::Rotation(SimTK::UnitVec3(-std::sin(w), std::cos(w), 0), SimTK::ZAxis),
                         Vec3(o[0], o[1], 0));
    MobilizedBody::Pin pin(on, wing, SimTK::Body::Massless(), wing);
    slots(pin, 3, 1);
    return MobilizedBody::Weld(pin, Transform(), body, out);
  }
  if (type != "CustomJoint" || direction == MobilizedBody::Reverse)
    throw std::runtime_error("the oracle knows no " + type);
  // Simbody's FunctionBased has a wrong derivative of its hinges where a coordinate turns all three axes; here each axis
  // has a slider or pin of its own, which follows the coordinates.
  const std::string own = joint.attribute("name").value();
  MobilizedBody on = inboard;
  Transform before = in;
  for (const char* which :
       {"translation1", "translation2", "translation3", "rotation1", "rotation2", "rotation3"}) {
    const pugi::xml_node axis =
        joint.child("SpatialTransform").find_child_by_attribute("TransformAxis", "name", which);
    const std::vector<std::string> of = words_in(axis.child("coordinates"));
    Law law;
    law.weights.assign(of.size(), 1);
    if (const pugi::xml_node function = law_element(axis, "function")) law = read_law(function, of.size());
    followers_.push_back({own + "/" + which, of, law, of.empty()});
    const bool turns = which[0] == 'r', last = std::string(which) == "rotation3";
    const SimTK::CoordinateAxis which_axis(turns ? 2 : 0);
    const Transform along(SimTK::Rotation(SimTK::UnitVec3(vec3(axis.child("axis"))), which_axis));
    const SimTK::Body carried = last ? body : SimTK::Body(SimTK::Body::Massless());
    const Transform outboard = last ? out * along : along;
    if (turns)
      on = MobilizedBody::Pin(on, before * along, carried, outboard);
    else
      on = MobilizedBody::Slider(on, before * along, carried, outboard);
    slots_[own + "/" + which] = {on, 0};
    before = Transform();
  }
  return on;
}

void OsimSkeleton::read_followers() {
  std::vector<pugi::xml_node> joints;
  for (const pugi::xml_node body : model_.child("BodySet").child("objects").children("Body"))
    for (const pugi::xml_node joint : body.child("Joint").children()) joints.push_back(joint);
  for (const pugi::xml_node joint : model_.child("JointSet").child("objects").children())
    joints.push_back(joint);
  for (const pugi::xml_node joint : joints)
    for (const pugi::xml_node c : coordinate_elements(joint)) {
      Follower follower{c.attribute("name").value(), {}, {}, false};
      follower.law.offset = c.child("default_value").text().as_double();
      follower.law.weights = {0};
      if (is_true(c, "prescribed") && !is_true(c, "locked"))
        follower.law = read_law(law_element(c, "prescribed_function"), 1);
      else if (!is_true(c, "locked"))
        continue;
      followers_.push_back(follower);
    }
  for (const pugi::xml_node coupler :
       model_.child("ConstraintSet").child("objects").children("CoordinateCouplerConstraint")) {
    if (text_of(coupler, "isEnforced") == "false" || is_true(coupler, "isDisabled")) continue;
    const std::vector<std::string> of = words_in(coupler.child("independent_coordinate_names"));
    followers_.push_back({text_of(coupler, "dependent_coordinate_name"), of,
                          read_law(law_element(coupler, "coupled_coordinates_function"), of.size())
                              .times(coupler.child("scale_factor").text().as_double(1)),
                          false});
  }
  // Those that others follow come first.
  std::vector<Follower> ordered;
  while (!followers_.empty()) {
    std::vector<Follower> later;
    for (const Follower& follower : followers_) {
      const bool waits = std::any_of(follower.of.begin(), follower.of.end(), [&](const std::string& name) {
        return std::any_of(followers_.begin(), followers_.end(),
                           [&](const Follower& f) { return f.name == name; });
      });
      (waits ? later : ordered).push_back(follower);
    }
    if (later.size() == followers_.size()) throw std::runtime_error("coordinates that follow themselves");
    followers_ = later;
  }
  followers_ = ordered;
}

void OsimSkeleton::set(const std::map<std::string, double>& q, const std::map<std::string, double>& u,
                       double time) {
  values_.clear();
  for (const auto& [name, value] : q) values_[name] = {value, u.at(name), 0, {{name, 1.0}}};
  for (const Follower& follower : followers_) {
    std::vector<double> x;
    Value out;
    if (follower.constant) {
      out.q = follower.law.value({});
      values_[follower.name] = out;
      continue;
    }
    if (follower.of.empty()) {
      x = {time};
      out.u = follower.law.first(x, 0);
      out.rate = follower.law.second(x, 0, 0);
    }
    for (const std::string& name : follower.of) x.push_back(values_[name].q);
    out.q = follower.law.value(x);
    for (std::size_t i = 0; i < follower.of.size(); ++i) {
      const Value& of = values_[follower.of[i]];
      const double slope = follower.law.first(x, i);
      out.u += slope * of.u;
      out.rate += slope * of.rate;
      for (const auto& [name, by] : of.by) out.by[name] += slope * by;
      for (std::size_t j = 0; j < follower.of.size(); ++j)
        out.rate += follower.law.second(x, i, j) * of.u * values_[follower.of[j]].u;
    }
    values_[follower.name] = out;
  }
  SimTK::Vector rates(state_.getNQ(), 0.0), u_of(state_.getNU());
  for (const auto& [name, slot] : slots_) state_.updQ()[place(slot)] = values_[name].q;
  system_.realize(state_, SimTK::Stage::Position);
  for (const auto& [name, slot] : slots_) rates[place(slot)] = values_[name].u;
  matter_.multiplyByNInv(state_, false, rates, u_of);
  state_.updU() = u_of;
  system_.realize(state_, SimTK::Stage::Velocity);
}

int OsimSkeleton::place(const std::pair<MobilizedBody, int>& slot) const {
  return static_cast<int>(slot.first.getFirstQIndex(state_)) + slot.second;
}

std::vector<SimTK::Vector> OsimSkeleton::rates_by(const std::vector<std::string>& order) const {
  std::vector<SimTK::Vector> columns(order.size(), SimTK::Vector(state_.getNQ(), 0.0));
  for (const auto& [name, slot] : slots_)
    for (std::size_t k = 0; k < order.size(); ++k)
      if (const auto by = values_.at(name).by.find(order[k]); by != values_.at(name).by.end())
        columns[k][place(slot)] = by->second;
  return columns;
}

Eigen::VectorXd OsimSkeleton::project(const std::vector<SimTK::Vector>& rates,
                                      const SimTK::Vector& force) const {
  SimTK::Vector in_q;
  matter_.multiplyByNInv(state_, true, force, in_q);
  Eigen::VectorXd out(static_cast<Eigen::Index>(rates.size()));
  for (std::size_t k = 0; k < rates.size(); ++k) out(static_cast<Eigen::Index>(k)) = ~rates[k] * in_q;
  return out;
}

void OsimSkeleton::add_contacts() {
  const auto geometry = [&](const std::string& path) {
    return model_.child("ContactGeometrySet")
        .child("objects")
        .find_child_by_attribute("name", last_of(path).c_str());
  };
  const auto place_of = [&](pugi::xml_node of) {
    const Place on =
        find(text_of(of, of.child("socket_frame") ? "socket_frame" : "body_name"), "contactgeometryset");
    return Place{on.body, on.in_body * offset(of.child("location"), of.child("orientation"))};
  };
  const auto number = [](pugi::xml_node of, const char* child, double otherwise) {
    return of.child(child).text().as_double(otherwise);
  };
  std::vector<pugi::xml_node> all = {};
  for (const pugi::xml_node parent : {model_.child("ForceSet").child("objects"), model_.child("components")})
    for (const pugi::xml_node force : parent.children()) all.push_back(force);
  for (const pugi::xml_node force : all) {
    const std::string name = force.attribute("name").value();
    if (force.name() == std::string("SmoothSphereHalfSpaceForce")) {
      SimTK::SmoothSphereHalfSpaceForce law(forces_);
      const pugi::xml_node sphere = geometry(text_of(force, "socket_sphere")),
                           plane = geometry(text_of(force, "socket_half_space"));
      const Place center = place_of(sphere), ground = place_of(plane);
      law.setContactSphereBody(bodies_.at(center.body));
      law.setContactSphereLocationInBody(center.in_body.p());
      law.setContactSphereRadius(number(sphere, "radius", 0));
      law.setContactHalfSpaceBody(bodies_.at(ground.body));
      law.setContactHalfSpaceFrame(ground.in_body);
      law.setParameters(number(force, "stiffness", 1), number(force, "dissipation", 0),
                        number(force, "static_friction", 0), number(force, "dynamic_friction", 0),
                        number(force, "viscous_friction", 0), number(force, "transition_velocity", 0.01),
                        number(force, "constant_contact_force", 1e-5), number(force, "hertz_smoothing", 300),
                        number(force, "hunt_crossley_smoothing", 50));
      contact_forces_[name] = law.getForceIndex();
    } else if (force.name() == std::string("HuntCrossleyForce")) {
      const SimTK::ContactSetIndex set = contacts_.createContactSet();
      SimTK::HuntCrossleyForce law(forces_, contacts_, set);
      law.setTransitionVelocity(number(force, "transition_velocity", 0.01));
      for (const pugi::xml_node group :
           force.child("HuntCrossleyForce::ContactParametersSet").child("objects").children())
        for (const std::string& path : words_in(group.child("geometry"))) {
          const pugi::xml_node of = geometry(path);
          const Place at = place_of(of);
          if (of.name() == std::string("ContactSphere"))
            contacts_.addBody(set, bodies_.at(at.body),
                              SimTK::ContactGeometry::Sphere(number(of, "radius", 0)), at.in_body);
          else
            contacts_.addBody(set, bodies_.at(at.body), SimTK::ContactGeometry::HalfSpace(), at.in_body);
          law.setBodyParameters(SimTK::ContactSurfaceIndex(contacts_.getNumBodies(set) - 1),
                                number(group, "stiffness", 0), number(group, "dissipation", 0),
                                number(group, "static_friction", 0), number(group, "dynamic_friction", 0),
                                number(group, "viscous_friction", 0));
        }
      contact_forces_[name] = law.getForceIndex();
    }
  }
}

Eigen::VectorXd OsimSkeleton::contact(const std::string& name, const std::vector<std::string>& order) {
  system_.realize(state_, SimTK::Stage::Dynamics);
  SimTK::Vector_<SimTK::SpatialVec> on_bodies;
  SimTK::Vector_<Vec3> on_particles;
  SimTK::Vector on_speeds, pulled;
  forces_.getForce(contact_forces_.at(name))
      .calcForceContribution(state_, on_bodies, on_particles, on_speeds);
  matter_.multiplyBySystemJacobianTranspose(state_, on_bodies, pulled);
  return project(rates_by(order), pulled);
}

SkeletonDynamics OsimSkeleton::dynamics(const std::vector<std::string>& order) {
  const auto n = static_cast<Eigen::Index>(order.size());
  const std::vector<SimTK::Vector> columns = rates_by(order);
  SimTK::Vector rest(state_.getNQ(), 0.0);
  for (const auto& [name, slot] : slots_) rest[place(slot)] = values_[name].rate;
  SkeletonDynamics out{Eigen::MatrixXd(n, n), {}, {}};
  for (Eigen::Index k = 0; k < n; ++k) {
    SimTK::Vector u, Mu;
    matter_.multiplyByNInv(state_, false, columns[static_cast<std::size_t>(k)], u);
    matter_.multiplyByM(state_, u, Mu);
    out.M.col(k) = project(columns, Mu);
  }
  const Vec3 gravity = vec3(model_.child("gravity"), Vec3(0, -9.80665, 0));
  SimTK::Vector_<SimTK::SpatialVec> weights(matter_.getNumBodies(), SimTK::SpatialVec(Vec3(0), Vec3(0)));
  for (const auto& [name, body] : bodies_) {
    if (name == "ground") continue;
    const SimTK::MassProperties& mass = body.getBodyMassProperties(state_);
    const Vec3 force = mass.getMass() * gravity;
    weights[body.getMobilizedBodyIndex()] = SimTK::SpatialVec(
        SimTK::cross(body.expressVectorInGroundFrame(state_, mass.getMassCenter()), force), force);
  }
  SimTK::Vector pulled, NDotu, rates, residual;
  matter_.multiplyBySystemJacobianTranspose(state_, weights, pulled);
  out.g = -project(columns, pulled);
  matter_.multiplyByNDot(state_, false, state_.getU(), NDotu);
  matter_.multiplyByNInv(state_, false, SimTK::Vector(rest - NDotu), rates);
  matter_.calcResidualForceIgnoringConstraints(state_, SimTK::Vector(state_.getNU(), 0.0), weights, rates,
                                               residual);
  out.c = project(columns, residual);
  return out;
}

Vec3 OsimSkeleton::point(const std::string& frame, const Vec3& at) const {
  const Place place = find(frame, "");
  return bodies_.at(place.body).findStationLocationInGround(state_, place.in_body * at);
}

Transform OsimSkeleton::pose(const std::string& frame, const std::string& owner) const {
  const Place place = find(frame, owner);
  return bodies_.at(place.body).getBodyTransform(state_) * place.in_body;
}

}  // namespace alembert::oracles
