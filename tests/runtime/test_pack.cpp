// Arithmetic of packs: products, which are rounded only where they are used, are operands of every operation.
// Windows: whatever their rows and lines, every state is done, counted once, and written where it belongs.
#define ALEMBERT_PACK_NAMESPACE packs_of_test
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "alembert/pack.hpp"
#include "alembert/pack_window.hpp"

namespace alembert::packs_of_test {
namespace {

void expect_lanes(const Pack& found, double expected) {
  double lanes[Pack::kLanes];
  found.store(lanes);
  for (const double lane : lanes) EXPECT_EQ(lane, expected);
}

TEST(Pack, ProductsAreOperandsOfEveryOperation) {
  const Pack a(3), b(4), c(0.5), d(1.5);
  expect_lanes(a * b + c * d, 12.75);
  expect_lanes(a * b - c * d, 11.25);
  expect_lanes(a * b * (c * d), 9);
  expect_lanes(a * b / (c * d), 16);
  expect_lanes(a + c * d, 3.75);
  expect_lanes(a - c * d, 2.25);
  expect_lanes(a * (c * d), 2.25);
  expect_lanes(a / (c * d), 4);
  expect_lanes(a * b + c, 12.5);
  expect_lanes(a * b - c, 11.5);
  expect_lanes(a * b * c, 6);
  expect_lanes(a * b / c, 24);
  expect_lanes(-(a * b), -12);
  expect_lanes(-(a * b) / -(c * d), 16);
  expect_lanes(sqrt(b * b), 4);
  expect_lanes(abs(-(a * b)), 12);
  expect_lanes(sign(-(a * b)), -1);
  expect_lanes(pow(c * b, a * Pack(1)), 8);
}

TEST(PackWindow, WritesEveryStateAndCountsItOnce) {
  constexpr std::size_t kRows = 3, kMost = 150;
  constexpr double kUntouched = -1;
  constexpr std::array<int, kRows> kRowOf = {1, 0, 1};
  for (const bool past_caches : {false, true})
    for (const std::size_t stride : {kMost + 10, kMost + 13})
      for (std::size_t offset = 0; offset < kLine; ++offset)
        for (const std::size_t first : {0U, 3U, 8U})
          for (std::size_t last = first + 1; last <= kMost; last += last < 40 ? 1 : 11) {
            std::vector<double> in(2 * stride), memory(kRows * stride + kLine, kUntouched);
            for (std::size_t k = 0; k < in.size(); ++k) in[k] = static_cast<double>(k);
            double* const out = memory.data() + offset;
            const std::size_t counted =
                for_each_window<4>(first, last, past_caches ? out : nullptr, [&](const Window& window) {
                  Pack packs[4 * 2];
                  window.load(2, in.data(), stride, packs);
                  window.store(kRows, kRowOf, 2, packs, out, stride);
                  std::size_t states = 0;
                  for (int k = 0; k < window.packs; ++k) states += window.count_not_finite(Pack(1.0));
                  return states;
                });
            ASSERT_EQ(counted, last - first);
            for (std::size_t row = 0; row < kRows; ++row)
              for (std::size_t k = 0; k < stride; ++k)
                ASSERT_EQ(out[row * stride + k], k < first || k >= last
                                                     ? kUntouched
                                                     : in[static_cast<std::size_t>(kRowOf[row]) * stride + k])
                    << "row " << row << ", state " << k << " of " << first << " to " << last;
          }
}

}  // namespace
}  // namespace alembert::packs_of_test
