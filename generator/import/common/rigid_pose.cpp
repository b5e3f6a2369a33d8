#include "import/common/rigid_pose.hpp"

namespace alembert {

RigidPose operator*(const RigidPose& first, const RigidPose& then) {
  return {first.shift + first.turn * then.shift, (first.turn * then.turn).normalized(),
          std::max(first.longest(), then.longest())};
}

RigidPose inverse(const RigidPose& pose) {
  return {-(pose.turn.conjugate() * pose.shift), pose.turn.conjugate(), pose.longest()};
}

}  // namespace alembert
