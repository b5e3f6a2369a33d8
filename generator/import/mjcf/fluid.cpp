// Source of the laws: documentation of MuJoCo, Computation, fluid forces.
#include "import/mjcf/fluid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "import/common/snapped_angle.hpp"
#include "import/mjcf/sums.hpp"

namespace alembert {
namespace {

/// MuJoCo's own, for coefficients of a shape.
constexpr double kLeastDenominator = 1e-14;
/// Squares and products of speeds below which denominators and norms do not fall, so that they have derivatives at rest.
constexpr double kLeastSquare = 1e-100, kLeastProduct = 1e-150;

double square(double x) {
  return x * x;
}

/// a^2 factor_0 + ..., of three factors.
std::string squares_text(const std::array<double, 3>& factors, const std::array<std::string, 3>& of) {
  return sum_text({{factors[0], of[0] + "^2"}, {factors[1], of[1] + "^2"}, {factors[2], of[2] + "^2"}});
}

std::string root_text(const std::string& of) {
  return fmt::format("sqrt(max({}, {}))", number_text(kLeastSquare), of);
}

/// dx dy dz times the integral of 1/sqrt((dx^2 + l)^3 (dy^2 + l) (dz^2 + l)) over l from 0 to infinity, as MuJoCo takes it: by
/// Kronrod's rule of 15 points in x, with l = x^3/(1 - x)^2 in units of (dx^3 dy dz)^(2/5), and points and weights of eight digits.
double added_mass_integral(double dx, double dy, double dz) {
  constexpr double kPoints[] = {0.00427231, 0.02544604, 0.06756779, 0.12923441,
                                0.20695638, 0.29707742, 0.39610752, 0.5};
  constexpr double kWeights[] = {0.01146766, 0.03154605, 0.05239501, 0.07032663,
                                 0.08450236, 0.09517529, 0.10221647, 0.10474107};
  const double unit = std::pow(dx * dx * dx * dy * dz, 0.4);
  const auto at = [&](double x) {
    const double l = unit * x * x * x / square(1 - x),
                 slope = unit * x * x * (3 - x) / (square(1 - x) * (1 - x));
    const double a = 1 + l / (dx * dx), b = 1 + l / (dy * dy), c = 1 + l / (dz * dz);
    return slope / (a * std::sqrt(a * b * c));
  };
  double sum = 0;
  for (std::size_t i = 0; i < std::size(kPoints); ++i) {
    sum += kWeights[i] * at(kPoints[i]);
    if (kPoints[i] != 0.5) sum += kWeights[i] * at(1 - kPoints[i]);
  }
  return sum / (dx * dx);
}

/// Mass and moments of inertia of the fluid that moves with an ellipsoid, of density 1. Source: Lamb, Hydrodynamics (1932),
/// sections 114 and 115.
struct AddedMass {
  std::array<double, 3> mass, inertia;

  explicit AddedMass(const std::array<double, 3>& d) {
    const double volume = 4.0 / 3 * std::numbers::pi * d[0] * d[1] * d[2];
    std::array<double, 3> k;
    for (std::size_t i = 0; i < 3; ++i) {
      k[i] = added_mass_integral(d[i], d[(i + 1) % 3], d[(i + 2) % 3]);
      mass[i] = volume * k[i] / std::max(kLeastDenominator, 2 - k[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
      const double less = square(d[a]) - square(d[b]), sum = square(d[a]) + square(d[b]);
      inertia[i] = volume / 5 * square(less) * std::abs(k[b] - k[a]) /
                   std::max(kLeastDenominator, std::abs(2 * less + sum * (k[a] - k[b])));
    }
  }
};

}  // namespace

FluidLoads fluid_on_box(const MjcfModel& fluid, const std::array<double, 3>& edges,
                        const FluidMotion& motion) {
  const double diameter = (edges[0] + edges[1] + edges[2]) / 3;
  FluidLoads out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = edges[(k + 1) % 3], c = edges[(k + 2) % 3];
    const auto drag = [&](const std::string& speed, double linear, double quadratic) {
      return sum_text({{-linear, speed}, {-quadratic, "abs" + speed + "*" + speed}});
    };
    out.force[k] = drag(motion.velocity[k], 3 * std::numbers::pi * diameter * fluid.viscosity,
                        0.5 * fluid.density * a * c);
    out.torque[k] =
        drag(motion.angular_velocity[k], std::numbers::pi * std::pow(diameter, 3) * fluid.viscosity,
             fluid.density * edges[k] * (std::pow(a, 4) + std::pow(c, 4)) / 64);
  }
  return out;
}

/// With v, w the velocities, d the semiaxes, s_x = d_y d_z and so on, p = sum s_i^2 v_i^2, r = sum s_i^4 v_i^2:
///   area across the way      A = pi sqrt(r/p)
///   drag                     -(3 pi D mu + rho |v| (c_b A + c_s (A_max - A))) v,  D = 2/3 (d_x + d_y + d_z)
///   Kutta                    c_k rho A p/(|v| r) (p v - |v|^2 (s_x^2 v_x, s_y^2 v_y, s_z^2 v_z))
///   Magnus                   c_m rho V w x v
///   torque of drag           -(pi D^3 mu + rho |(m_x w_x, m_y w_y, m_z w_z)|) w,  m_i = c_a I_i + c_s (I_max - I_i),
///                            I_x = 8/15 pi d_x max(d_y, d_z)^4
///   added mass               rho (M v) x w, and the torque rho ((M v) x v + (I w) x w)
FluidLoads fluid_on_ellipsoid(const MjcfModel& fluid, const MjcfFluidShape& shape,
                              const FluidMotion& motion) {
  const auto& [blunt, slender, angular, kutta, magnus] = shape.coefficients;
  const auto& d = shape.semiaxes;
  const auto &v = motion.velocity, &w = motion.angular_velocity;
  const double rho = fluid.density, volume = 4.0 / 3 * std::numbers::pi * d[0] * d[1] * d[2];
  const double largest = std::max({d[0], d[1], d[2]}), least = std::min({d[0], d[1], d[2]}),
               middle = d[0] + d[1] + d[2] - largest - least;
  const AddedMass added(d);
  std::array<double, 3> s2, s4, moment;
  const double most = 8.0 / 15 * std::numbers::pi * middle * std::pow(largest, 4);
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = d[(i + 1) % 3], b = d[(i + 2) % 3];
    s2[i] = square(a * b);
    s4[i] = square(s2[i]);
    const double own = 8.0 / 15 * std::numbers::pi * d[i] * std::pow(std::max(a, b), 4);
    moment[i] = angular * own + slender * (most - own);
  }
  const std::string p = "(" + squares_text(s2, v) + ")", r = "(" + squares_text(s4, v) + ")",
                    speed = root_text(squares_text({1, 1, 1}, v));
  const std::string area = fmt::format("pi*{}/sqrt(max({}, {}))", root_text(r), number_text(kLeastSquare), p);
  const double diameter = 2.0 / 3 * (d[0] + d[1] + d[2]);
  const std::string drag =
      factor_text(sum_text({{3 * std::numbers::pi * diameter * fluid.viscosity, ""},
                            {rho * (blunt - slender), speed + "*" + area},
                            {rho * slender * std::numbers::pi * largest * middle, speed}}));
  const std::string turning =
      root_text(squares_text({square(moment[0]), square(moment[1]), square(moment[2])}, w));
  const std::string braking = factor_text(
      sum_text({{std::numbers::pi * std::pow(diameter, 3) * fluid.viscosity, ""}, {rho, turning}}));
  const std::string lift = fmt::format("{}*{}/max({}, {}*{})", area, p, number_text(kLeastProduct), speed, r);
  FluidLoads out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    std::vector<SumTerm> force = {{-1, drag + "*" + v[i]}};
    if (kutta != 0)
      force.push_back(
          {kutta * rho, fmt::format("{}*{}*({} - {}*{}^2)", lift, v[i], p, number_text(s2[i]), speed)});
    // rho ((M v) x w)_i and c_m rho V (w x v)_i
    force.push_back({rho * (added.mass[j] - magnus * volume), v[j] + "*" + w[k]});
    force.push_back({-rho * (added.mass[k] - magnus * volume), v[k] + "*" + w[j]});
    out.force[i] = sum_text(force);
    out.torque[i] = sum_text({{-1, braking + "*" + w[i]},
                              {rho * (added.mass[j] - added.mass[k]), v[j] + "*" + v[k]},
                              {rho * (added.inertia[j] - added.inertia[k]), w[j] + "*" + w[k]}});
  }
  return out;
}

}  // namespace alembert
