// A model file of OpenSim in Simbody, by the oracle's own reading of it: bodies, joints, and coordinates that are
// locked, prescribed or coupled.
#pragma once

#include <Simbody.h>

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "oracles/osim/laws.hpp"

namespace alembert::oracles {

/// M rates + c = 0 without forces but gravity, whose part of c is g; over the coordinates that are free.
struct SkeletonDynamics {
  Eigen::MatrixXd M;
  Eigen::VectorXd c, g;
};

class OsimSkeleton {
 public:
  explicit OsimSkeleton(const std::string& file);

  /// Positions and speeds of the free coordinates, by name.
  void set(const std::map<std::string, double>& q, const std::map<std::string, double>& u, double time);
  /// Of speeds in this order.
  SkeletonDynamics dynamics(const std::vector<std::string>& order);
  /// What a contact force of Simbody adds to the generalized forces, over speeds in this order.
  Eigen::VectorXd contact(const std::string& name, const std::vector<std::string>& order);
  /// World position of a point in a frame, given as the file names frames.
  SimTK::Vec3 point(const std::string& frame, const SimTK::Vec3& at) const;
  /// Pose of a frame that an element owns, or of any other.
  SimTK::Transform pose(const std::string& frame, const std::string& owner) const;
  double coordinate(const std::string& name) const { return values_.at(name).q; }
  double speed(const std::string& name) const { return values_.at(name).u; }
  pugi::xml_node model() const { return model_; }
  /// A coordinate's rate of change with each of the free ones.
  std::map<std::string, double> gradient(const std::string& name) const { return values_.at(name).by; }

 private:
  struct Place {
    std::string body;
    SimTK::Transform in_body;
  };
  using Slot = std::pair<SimTK::MobilizedBody, int>;
  struct Follower {
    std::string name;
    std::vector<std::string> of;  ///< empty: of time
    Law law;
    bool constant = false;
  };
  /// Its value and speed, what its rate is without rates of free ones, and its gradient by them.
  struct Value {
    double q = 0, u = 0, rate = 0;
    std::map<std::string, double> by;
  };
  void read_frames();
  void read_followers();
  Place find(const std::string& socket, const std::string& owner) const;
  /// Where a joint stands on two bodies.
  std::pair<Place, Place> ends(pugi::xml_node joint) const;
  bool add_joint(pugi::xml_node joint);
  /// The bodies that Simbody's own maker of graphs lets move freely, since no joint leads to them from the ground.
  std::vector<std::string> without_joint(const std::vector<pugi::xml_node>& joints) const;
  /// Takes the joints that close chains out of `joints`, and shares out the masses of the bodies that they move.
  std::vector<pugi::xml_node> take_closing(std::vector<pugi::xml_node>& joints,
                                           const std::vector<std::string>& free);
  void add_closing(pugi::xml_node joint);
  /// Of a frame that three stations and an origin tell.
  Place find_by_stations(pugi::xml_node frame) const;
  SimTK::MobilizedBody add_mobilizers(pugi::xml_node joint, SimTK::MobilizedBody inboard,
                                      const SimTK::Transform& in, const SimTK::Body& body,
                                      const SimTK::Transform& out, SimTK::MobilizedBody::Direction direction);
  int place(const Slot& slot) const;
  void add_contacts();
  /// Rates of Simbody's q by each of the free speeds.
  std::vector<SimTK::Vector> rates_by(const std::vector<std::string>& order) const;
  /// A force over Simbody's speeds as one over the free ones.
  Eigen::VectorXd project(const std::vector<SimTK::Vector>& rates, const SimTK::Vector& force) const;

  pugi::xml_document document_;
  pugi::xml_node model_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::GeneralContactSubsystem contacts_{system_};
  std::map<std::string, SimTK::ForceIndex> contact_forces_;
  SimTK::State state_;
  std::map<std::string, SimTK::Body::Rigid> rigid_;
  std::map<std::string, SimTK::MobilizedBody> bodies_;
  std::map<std::string, pugi::xml_node> frames_;  ///< by "owner/name"
  std::map<std::string, Slot> slots_;             ///< by coordinate: where its q is
  std::vector<Follower> followers_;
  std::map<std::string, Value> values_;
};

}  // namespace alembert::oracles
