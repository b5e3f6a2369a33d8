// The table of operations: each row agrees with itself. What follows from it elsewhere (that expressions,
// programs and files know every row) is tested in tests/program/test_operations.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>

#include "support/operation.hpp"

namespace alembert {
namespace {

constexpr double kPoints[] = {0.3, -0.7, 0.9, 1.4, -2.2};

TEST(OperationTable, HasARowForEachOperationAndNoNameTwice) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kOperations; ++i) {
    const OperationFacts& row = kOperationFacts[i];
    EXPECT_EQ(static_cast<std::size_t>(row.operation), i);
    EXPECT_EQ(row.name.empty(), is_leaf(row.operation)) << i;
    if (is_call(row.operation)) {
      EXPECT_TRUE(names.insert(row.name).second) << row.name;
    }
    EXPECT_EQ(row.weight == 0, row.counted == Counted::free) << row.name;
    if (row.in_language) {
      EXPECT_TRUE(is_call(row.operation)) << row.name;
    }
  }
  EXPECT_EQ(names.size(), 19u);
}

TEST(OperationTable, ParitiesAreThoseOfTheValues) {
  for (const OperationFacts& row : kOperationFacts) {
    if (row.operands != 1) continue;
    for (const double x : kPoints) {
      const double value = apply(row.operation, x, 0.0), mirrored = apply(row.operation, -x, 0.0);
      if (std::isnan(value) || std::isnan(mirrored)) continue;
      if (row.parity == Parity::odd) {
        EXPECT_EQ(mirrored, -value) << row.name;
      }
      if (row.parity == Parity::even) {
        EXPECT_EQ(mirrored, value) << row.name;
      }
      if (row.parity == Parity::none) {
        EXPECT_NE(std::abs(mirrored), std::abs(value)) << row.name;
      }
    }
  }
}

TEST(OperationTable, BoundsHoldTheValues) {
  for (const OperationFacts& row : kOperationFacts) {
    if (is_leaf(row.operation)) continue;
    for (const double a : kPoints)
      for (const double b : kPoints) {
        const double value = apply(row.operation, a, b);
        if (std::isnan(value)) continue;
        for (const double width : {0.0, 0.2, 3.0}) {
          const Interval range =
              bounds_of(row.operation, {a - width, a + width / 2}, {b - width, b + width / 2});
          EXPECT_LE(range.lower, value) << row.name << " " << a << " " << b;
          EXPECT_GE(range.upper, value) << row.name << " " << a << " " << b;
        }
      }
  }
}

TEST(OperationTable, CarriedErrorsAreAtLeastWhatTheOperandsErrorsDo) {
  constexpr double kError = 1e-6;
  for (const OperationFacts& row : kOperationFacts) {
    if (is_leaf(row.operation)) continue;
    for (const double a : kPoints)
      for (const double b : kPoints) {
        const double value = apply(row.operation, a, b);
        if (std::isnan(value)) continue;
        const double bound = error_bound(row.operation, {a, kError}, {b, kError}, value);
        for (const double da : {-kError, kError})
          for (const double db : {-kError, kError})
            EXPECT_LE(std::abs(apply(row.operation, a + da, b + db) - value), bound * 1.0001)
                << row.name << " " << a << " " << b;
      }
  }
}

}  // namespace
}  // namespace alembert
