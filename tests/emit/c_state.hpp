// Random states of a mechanism as arrays for C, what the interpreter makes of them, and how near results must be.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "emit/c_library.hpp"
#include "emit/sample.hpp"
#include "mechanism/model.hpp"
#include "program/interpret.hpp"

namespace sample {

using alembert::ArgumentKind;
using alembert::Mechanism;
using alembert::Program;

/// 1e-12 of the largest entry of an array, in units of the last place of double; as many of float are
/// allowed.
inline constexpr double kFloatTolerance = 1e-12 * 0x1p29;

/// Whether it is a sample, whose functions are random ones.
inline bool random_functions(const Mechanism& mechanism) {
  return mechanism.name.starts_with("sample_");
}

/// A random state as arrays of numbers that Real holds exactly.
template <class Real>
struct CState {
  std::vector<Real> q, qd, qdd, tau, mu, parameters, wrenches;
  Real t;

  CState(const Mechanism& mechanism, std::uint64_t seed) {
    Random random(seed);
    const bool wide = random_functions(mechanism);
    const auto near = [&](double x, double by) { return static_cast<Real>(x + random.uniform(-by, by)); };
    for (const alembert::Coordinate& c : mechanism.coordinates) {
      double square = 0;
      const std::size_t first = q.size();
      for (const double x : c.initial) {
        q.push_back(wide ? near(0, 2) : near(x, 0.5));
        square += static_cast<double>(q.back()) * static_cast<double>(q.back());
      }
      for (std::size_t i = first; i < q.size() && c.type == alembert::CoordinateType::quaternion; ++i)
        q[i] = static_cast<Real>(static_cast<double>(q[i]) / std::sqrt(square));
    }
    for (std::vector<Real>* array : {&qd, &qdd, &tau, &mu})
      for (int i = 0; i < mechanism.nv; ++i) array->push_back(near(0, 2));
    for (const alembert::Parameter& p : mechanism.parameters)
      if (p.runtime) parameters.push_back(wide ? near(1.25, 0.75) : near(p.value, 0.1 * std::abs(p.value)));
    for (const alembert::Body& body : mechanism.bodies)
      for (int i = 0; i < 6 && body.external_wrench; ++i) wrenches.push_back(near(0, 3));
    t = near(1, 1);
  }
  /// Parameters of the description, and no wrenches.
  void set_defaults(const Mechanism& mechanism) {
    parameters.clear();
    for (const alembert::Parameter& p : mechanism.parameters)
      if (p.runtime) parameters.push_back(static_cast<Real>(p.value));
    wrenches.assign(wrenches.size(), 0);
  }
  const std::vector<Real>& array(ArgumentKind kind) const {
    switch (kind) {
      case ArgumentKind::q:
        return q;
      case ArgumentKind::qd:
        return qd;
      case ArgumentKind::qdd:
        return qdd;
      case ArgumentKind::tau:
        return tau;
      case ArgumentKind::mu:
        return mu;
      case ArgumentKind::parameter:
        return parameters;
      case ArgumentKind::wrench:
        return wrenches;
      case ArgumentKind::time:
        break;
    }
    throw std::invalid_argument("no array");
  }
  std::vector<double> interpreted(const Program& program) const {
    std::vector<double> inputs, scratch;
    for (const alembert::InputSlot& slot : program.inputs)
      inputs.push_back(
          static_cast<double>(slot.kind == ArgumentKind::time ? t : array(slot.kind)[slot.index]));
    std::size_t size = 0;
    for (const alembert::OutputArray& output : program.outputs) size += output.values.size();
    std::vector<double> outputs(size);
    alembert::interpret(program, inputs, outputs, scratch);
    return outputs;
  }
};

/// A function's results in C, one array after the other; arrays that it needs may be null.
template <class Real>
struct CCall {
  std::vector<Real> results;
  int status;

  CCall(const CLibrary<Real>& library, std::size_t function, const Program& program,
        const CState<Real>& state, bool defaults = false, bool no_argument = false) {
    std::size_t size = 0;
    for (const alembert::OutputArray& output : program.outputs) size += output.values.size();
    results.assign(size, std::numeric_limits<Real>::quiet_NaN());
    std::vector<const Real*> arguments;
    for (const ArgumentKind kind : alembert::find_function(program.function)->arguments)
      arguments.push_back(no_argument ? nullptr : state.array(kind).data());
    std::vector<Real*> to;
    std::size_t first = 0;
    for (const alembert::OutputArray& output : program.outputs) {
      to.push_back(results.data() + first);
      first += output.values.size();
    }
    if (no_argument && arguments.empty()) to.back() = nullptr;
    status = library(function, arguments, state.t, defaults ? nullptr : state.parameters.data(),
                     defaults ? nullptr : state.wrenches.data(), to);
  }
};

/// One NaN is as good as another; random functions have some.
template <class Real>
bool same(Real x, Real y) {
  return x == y || (std::isnan(x) && std::isnan(y));
}

inline void expect_near(const Program&, const std::vector<double>& results,
                        const std::vector<double>& expected, const std::string& what) {
  EXPECT_TRUE(std::ranges::equal(results, expected, same<double>))
      << what << ": " << testing::PrintToString(results) << " and " << testing::PrintToString(expected);
}
inline void expect_near(const Program& program, const std::vector<float>& results,
                        const std::vector<double>& expected, const std::string& what) {
  std::size_t i = 0;
  for (const alembert::OutputArray& output : program.outputs) {
    const std::size_t end = i + output.values.size();
    double largest = 0;
    for (std::size_t k = i; k < end; ++k) largest = std::max(largest, std::abs(expected[k]));
    for (; i < end; ++i)
      EXPECT_NEAR(static_cast<double>(results[i]), expected[i], kFloatTolerance * largest)
          << what << ", " << output.name;
  }
}

}  // namespace sample
