// What a program's time is likely to be spent on, estimated from its operations. In: a program. Out: shares.
#pragma once

#include "program/program.hpp"

namespace alembert {

/// Shares of the time, 1 together. Each operation takes its weight (support/operation.hpp), reading an entry of an
/// argument and writing one of a result that of an addition: what caches, the compiler's spills and operations
/// side by side make of it is not known here.
struct TimeShares {
  double arithmetic = 0;  ///< + - *
  double division = 0;
  double trig = 0;    ///< sin, cos, tan
  double other = 0;   ///< sqrt, exp, ...
  double memory = 0;  ///< arguments read, results written
};
TimeShares estimated_shares(const Program& program);

}  // namespace alembert
