// Bodies as they are and move, apart from the mechanism that moves them. In: a mechanism and its state. Out:
// pose and velocities of each body; bodies of one mechanism in their places in another. No heap, no
// exceptions.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include "alembert/mechanism.hpp"

namespace alembert {

/// Where a body is and how it moves, in world axes.
template <class S>
struct BodyMotion {
  bool known = false;
  Eigen::Matrix<S, 3, 4> pose = Eigen::Matrix<S, 3, 4>::Zero();     ///< [R p] of its frame
  Eigen::Matrix<S, 3, 1> angular = Eigen::Matrix<S, 3, 1>::Zero();  ///< angular velocity, rad/s
  Eigen::Matrix<S, 3, 1> linear = Eigen::Matrix<S, 3, 1>::Zero();   ///< velocity of its centre of mass, m/s
};

namespace detail {

template <class M, class = void>
struct HasBodies : std::false_type {};

template <class M>
struct HasBodies<M, std::void_t<decltype(M::kNbodies),
                                decltype(M::body_poses(std::declval<const CoordinateVector<M>&>(),
                                                       std::declval<const typename M::Inputs&>())[0]),
                                decltype(M::body_jacobians(std::declval<const CoordinateVector<M>&>(),
                                                           std::declval<const typename M::Inputs&>())),
                                decltype(M::body_inertias(std::declval<const typename M::Inputs&>()))>>
    : std::bool_constant<(M::kNbodies > 0)> {};

}  // namespace detail

/// True if M also has body_poses, body_jacobians and body_inertias: generate it with these functions.
template <class M>
inline constexpr bool has_bodies_v = is_mechanism_v<M>&& detail::HasBodies<M>::value;

/// Where the bodies of a mechanism are and how they move.
/// \param q, qd, in  state and inputs
/// \return           not finite where these are not; what takes bodies (topology.hpp) says so by its status
template <class M>
std::array<BodyMotion<typename M::Scalar>, static_cast<std::size_t>(M::kNbodies)> body_motions(
    const CoordinateVector<M>& q, const SpeedVector<M>& qd, const typename M::Inputs& in) {
  static_assert(has_bodies_v<M>, "generate M with body_poses, body_jacobians and body_inertias");
  std::array<BodyMotion<typename M::Scalar>, static_cast<std::size_t>(M::kNbodies)> out;
  const auto poses = M::body_poses(q, in);
  const auto J = M::body_jacobians(q, in);
  for (int b = 0; b < M::kNbodies; ++b) {
    auto& body = out[static_cast<std::size_t>(b)];
    body.known = true;
    body.pose = poses[static_cast<std::size_t>(b)];
    for (int k = 0; k < M::kNv; ++k) {
      body.angular += J.template block<3, 1>(6 * b, k) * qd(k);
      body.linear += J.template block<3, 1>(6 * b + 3, k) * qd(k);
    }
  }
  return out;
}

/// For each name in `to` the index of the same name in `from`, or -1: bodies that are in both mechanisms.
template <std::size_t n, std::size_t m>
constexpr std::array<int, m> same_names(const std::array<std::string_view, n>& from,
                                        const std::array<std::string_view, m>& to) {
  std::array<int, m> out{};
  for (std::size_t i = 0; i < m; ++i) {
    out[i] = -1;
    for (std::size_t k = 0; k < n && out[i] < 0; ++k)
      if (from[k] == to[i]) out[i] = static_cast<int>(k);
  }
  return out;
}

/// Copies bodies of one mechanism to their places in another; to be called for each mechanism that the other
/// takes bodies from.
/// \param from     bodies of the one
/// \param indices  for each body of the other its index in `from`, or -1: that one is left as it was
/// \param to       bodies of the other
template <class S, std::size_t n, std::size_t m>
constexpr void take_bodies(const std::array<BodyMotion<S>, n>& from, const std::array<int, m>& indices,
                           std::array<BodyMotion<S>, m>& to) {
  for (std::size_t i = 0; i < m; ++i)
    if (indices[i] >= 0) to[i] = from[static_cast<std::size_t>(indices[i])];
}

}  // namespace alembert
