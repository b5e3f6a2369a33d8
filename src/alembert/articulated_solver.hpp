// Solves M X = B for many right-hand sides at once, by articulated bodies: each column in time proportional to the number
// of speeds, however long the branches are. In: a tree of axes. Out: solutions; or a status that says why there are
// none. No heap unless M is a HeapMatrix (matrix.hpp), no exceptions.
//
// After Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7, without bias forces. s is the twist of a speed, a
// its armature. From the tips on, I is the inertia of its body and f = 0, plus what the speeds that it carries pass on:
//
//   U = I s,  D = s . U + a,  W = -U / D;  it passes on I + U W^T
//   y = b + s . f;                         it passes on f + W y
//
// From the root on, with z = 0 at the world: x = y / D + W . z, and what it carries has z + s x.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "alembert/axis_state.hpp"
#include "alembert/axis_tree.hpp"
#include "alembert/column_solver.hpp"
#include "alembert/matrix.hpp"
#include "alembert/mechanism.hpp"
#include "alembert/status.hpp"

namespace alembert {
namespace detail {
inline namespace ALEMBERT_INSTRUCTIONS {

/// Whether articulated bodies take less time than factors of M. Measured: where a row is carried by more than so many
/// others in the mean, as in long chains.
inline constexpr int kDeepByBodies = EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS >= 32 ? 14 : 22;
template <class M>
constexpr bool solves_by_bodies() {
  if constexpr (kByAxes<M>) {
    int depths[M::kNv] = {}, sum = 0;
    for (std::size_t k = 0; k < M::kNv; ++k) {
      const int parent = M::Axes::kParents[k];
      depths[k] = parent < 0 ? 0 : depths[parent] + 1;
      sum += depths[k];
    }
    return sum > kDeepByBodies * M::kNv;
  } else {
    return false;
  }
}
template <class M>
inline constexpr bool kSolvesByBodies = solves_by_bodies<M>();

/// Packets that are done together.
inline constexpr int kPacketsOfBodies = 4;

/// Rows that follow each other in one run, of which none but the last carries several.
template <std::size_t n>
struct RowSegments {
  struct Segment {
    int first = 0, end = 0, parent = -1, carried = 0;  ///< segments that it carries
  };
  Segment all[n] = {};
  int count = 0;
};
template <class Tables, std::size_t n>
constexpr RowSegments<n> segments_of(const Tables& tables, const std::array<int, n>& parents) {
  RowSegments<n> out;
  int segments[n] = {}, children[n] = {};
  for (const int parent : parents)
    if (parent >= 0) ++children[parent];
  for (std::size_t k = 0; k < n; ++k) {
    const int row = static_cast<int>(k), parent = parents[k];
    const bool goes_on = parent >= 0 && parent == row - 1 && children[parent] == 1 && tables.starts[k] != row;
    if (!goes_on) {
      auto& own = out.all[out.count++];
      own.first = row;
      own.parent = parent < 0 ? -1 : segments[parent];
      if (parent >= 0) ++out.all[own.parent].carried;
    }
    segments[k] = out.count - 1;
    out.all[out.count - 1].end = row + 1;
  }
  return out;
}

/// Symmetric 6 x 6: [A, B; B^T, C] times (xi, d) is (moment, force).
template <class S>
struct ArticulatedInertia {
  S A[6], B[3][3], C[6];  ///< A and C: xx yy zz xy xz yz

  /// Where a symmetric matrix has entry (r, c), and the row and column of each.
  static constexpr int kAt[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  static constexpr int kRows[6] = {0, 1, 2, 0, 0, 1}, kColumns[6] = {0, 1, 2, 1, 2, 2};

  void add(const ArticulatedInertia& more) {
    for (int c = 0; c < 6; ++c) A[c] += more.A[c];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) B[r][c] += more.B[r][c];
    for (int c = 0; c < 6; ++c) C[c] += more.C[c];
  }
  void add_body(const S mass, const S* h, const S* J) {
    for (int c = 0; c < 6; ++c) A[c] += J[c];
    for (int c = 0; c < 3; ++c) C[c] += mass;
    for (int c = 0; c < 3; ++c) {
      const int y = (c + 1) % 3, z = (c + 2) % 3;
      B[z][y] += h[c];
      B[y][z] -= h[c];
    }
  }
  void times(const S* xi, const S* d, S* out) const {
    for (int r = 0; r < 3; ++r) {
      out[r] = (A[kAt[r][0]] * xi[0] + A[kAt[r][1]] * xi[1] + A[kAt[r][2]] * xi[2]) +
               (B[r][0] * d[0] + B[r][1] * d[1] + B[r][2] * d[2]);
      out[3 + r] = (B[0][r] * xi[0] + B[1][r] * xi[1] + B[2][r] * xi[2]) +
                   (C[kAt[r][0]] * d[0] + C[kAt[r][1]] * d[1] + C[kAt[r][2]] * d[2]);
    }
  }
  /// Adds u w^T, which is symmetric.
  void add_product(const S* u, const S* w) {
    for (int c = 0; c < 6; ++c) A[c] += u[kRows[c]] * w[kColumns[c]];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) B[r][c] += u[r] * w[3 + c];
    for (int c = 0; c < 6; ++c) C[c] += u[3 + kRows[c]] * w[3 + kColumns[c]];
  }
  /// About another point, from where `way` leads to the first: X^T I X with X = [1, 0; -way x, 1].
  void shift(const S* way) {
    S shifted[3][3];  // B + way x C
    for (int c = 0; c < 3; ++c) {
      const S column[3] = {C[kAt[0][c]], C[kAt[1][c]], C[kAt[2][c]]};
      for (int r = 0; r < 3; ++r) shifted[r][c] = B[r][c] + crossed(way, column, r);
    }
    for (int c = 0; c < 6; ++c)
      A[c] += crossed(way, B[kColumns[c]], kRows[c]) + crossed(way, shifted[kRows[c]], kColumns[c]);
    for (int r = 0; r < 3; ++r) std::copy_n(shifted[r], 3, B[r]);
  }
};

/// \tparam M  has a struct Axes: right-hand sides stand by its rows, solutions by speeds
template <class M>
class ArticulatedSolver
    : public ColumnSolver<ArticulatedSolver<M>, typename M::Scalar, M::kNv, kPacketsOfBodies> {
  using S = typename M::Scalar;
  static constexpr int N = M::kNv;
  using Base = ColumnSolver<ArticulatedSolver, S, N, kPacketsOfBodies>;
  friend Base;
  using Base::kLanes;
  using typename Base::Packet;
  static constexpr bool kByRows = true;
  static constexpr auto kParents = M::Axes::kParents;
  static constexpr auto kOrder = order_of_speeds<static_cast<std::size_t>(N)>(M::Axes::kSpeeds);
  static constexpr auto kSegments = segments_of(kAxisTables<M>, kParents);

 public:
  /// \return  not_finite or not_positive_definite as of factor_ldlt
  [[nodiscard]] Status factor(const AxisTree<S, N>& tree) {
    std::array<ArticulatedInertia<S>, static_cast<std::size_t>(kSegments.count)> inertias{};
    for (int n = kSegments.count; n-- > 0;) {
      const auto& segment = kSegments.all[n];
      ArticulatedInertia<S> inertia = inertias[index(n)];
      for (int k = segment.end; k-- > segment.first;) {
        const auto joint = tree.joint(k);
        inertia.add_body(joint.mass, joint.moment, joint.inertia);
        const S *const xi = joint.twist, *const d = joint.twist + 3;
        S u[6];
        inertia.times(xi, d, u);
        const S pivot = joint.armature + ((xi[0] * u[0] + xi[1] * u[1] + xi[2] * u[2]) +
                                          (d[0] * u[3] + d[1] * u[4] + d[2] * u[5]));
        if (const Status status = status_of_pivot(pivot, joint.inertia_of_all, N); status != Status::ok)
          return status;
        Row& row = rows_[index(k)];
        row.inverse_pivot = S(1) / pivot;
        for (int c = 0; c < 6; ++c) {
          row.twist[c] = joint.twist[c];
          row.yield[c] = -u[c] * row.inverse_pivot;
        }
        inertia.add_product(u, row.yield);
      }
      if (segment.parent < 0) continue;
      const auto& way = ways_[index(n)] = tree.way(kParents[index(segment.first)], segment.first);
      inertia.shift(way.data());
      inertias[index(segment.parent)].add(inertia);
    }
    return Status::ok;
  }

  using Base::solve;
  /// x = M^-1 x.
  void solve(Eigen::Matrix<S, N, 1>& x) const {
    typename Base::template Rows<kLanes> all;
    sweep(std::make_index_sequence<1>(), all.data(), N, S(1),
          [&](int row, auto) { return Eigen::internal::pset1<Packet>(x(row)); });
    for (int i = 0; i < N; ++i) x(i) = all.data()[i * kLanes];
  }

 private:
  struct Row {
    S twist[6], yield[6], inverse_pivot;  ///< s, W, 1 / D
  };
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static int given(int row) { return row; }
  static bool is_tip(int row) { return row + 1 == N || kParents[index(row) + 1] != row; }

  /// Twists, or moments and forces, of `count` packets of columns. All loops are written out, so that they stay in
  /// registers.
  template <int count, class = std::make_index_sequence<6 * count>>
  class Sixes;
  template <int count, std::size_t... at>
  class Sixes<count, std::index_sequence<at...>> {
   public:
    static constexpr int kSize = 6 * count * kLanes;

    explicit Sixes(const S* from) : of_{Eigen::internal::pload<Packet>(from + at * kLanes)...} {}
    void store(S* to) const { (Eigen::internal::pstore(to + at * kLanes, of_[at]), ...); }
    void add_to(S* sum) const {
      using namespace Eigen::internal;
      (pstore(sum + at * kLanes, padd(pload<Packet>(sum + at * kLanes), of_[at])), ...);
    }
    /// x += k . this. Of one packet in two sums, which need not wait for each other.
    EIGEN_ALWAYS_INLINE void dot(const S* k, Packet (&x)[count]) const {
      using namespace Eigen::internal;
      if constexpr (count == 1) {
        Packet sums[] = {x[0], pset1<Packet>(S(0))};
        ((sums[at / 3] = pmadd(pset1<Packet>(k[at]), of_[at], sums[at / 3])), ...);
        x[0] = padd(sums[0], sums[1]);
      } else {
        ((x[at % count] = pmadd(pset1<Packet>(k[at / count]), of_[at], x[at % count])), ...);
      }
    }
    /// this += k x.
    EIGEN_ALWAYS_INLINE void add(const S* k, const Packet (&x)[count]) {
      using namespace Eigen::internal;
      ((of_[at] = pmadd(pset1<Packet>(k[at / count]), x[at % count], of_[at])), ...);
    }
    /// Adds way x the other three to the three from `first` on.
    template <std::size_t first>
    void add_crossed(const S* way) {
      add_crossed<first>(way, std::make_index_sequence<3 * count>());
    }

   private:
    template <std::size_t first, std::size_t... of_three>
    EIGEN_ALWAYS_INLINE void add_crossed(const S* way, std::index_sequence<of_three...>) {
      using namespace Eigen::internal;
      constexpr auto of = [](std::size_t from, std::size_t place, std::size_t more) {
        return (from + (place / count + more) % 3) * count + place % count;
      };
      ((of_[of(first, of_three, 0)] =
            pmadd(pset1<Packet>(way[(of_three / count + 1) % 3]), of_[of(3 - first, of_three, 2)],
                  pmadd(pset1<Packet>(-way[(of_three / count + 2) % 3]), of_[of(3 - first, of_three, 1)],
                        of_[of(first, of_three, 0)]))),
       ...);
    }

    Packet of_[6 * count];
  };

  /// As of ColumnSolver.
  template <std::size_t... p, class Given>
  void sweep(std::index_sequence<p...>, S* rows, int end, S factor, Given&& given) const {
    using namespace Eigen::internal;
    constexpr int kCount = static_cast<int>(sizeof...(p));
    using Of = Sixes<kCount>;
    const auto packet = [&](int row, std::size_t at) {
      return rows + (row * kCount + static_cast<int>(at)) * kLanes;
    };
    // Of each segment before `end` first moments and forces, then twists.
    Scratch<S, N, kSegments.count * Of::kSize> all;
    const auto of = [&](int segment) { return all.data() + segment * Of::kSize; };
    int count = 0;
    while (count < kSegments.count && kSegments.all[count].first < end) ++count;
    // One that carries one, the next, has what that gives it.
    for (int n = 0; n < count; ++n)
      if (kSegments.all[n].carried != 1 || n + 1 == count) std::fill_n(of(n), Of::kSize, S(0));
    for (int n = count; n-- > 0;) {
      const auto& segment = kSegments.all[n];
      Of f(of(n));
      for (int k = std::min(segment.end, end); k-- > segment.first;) {
        const Row& row = rows_[index(k)];
        Packet y[] = {given(k, std::integral_constant<int, static_cast<int>(p)>())...};
        f.dot(row.twist, y);
        (pstore(packet(k, p), y[p]), ...);
        f.add(row.yield, y);
      }
      if (segment.parent < 0) continue;
      f.template add_crossed<0>(ways_[index(n)].data());
      if (kSegments.all[segment.parent].carried == 1)
        f.store(of(segment.parent));
      else
        f.add_to(of(segment.parent));
    }
    alignas(64) static constexpr S kAtRest[Of::kSize] = {};
    for (int n = 0; n < count; ++n) {
      const auto& segment = kSegments.all[n];
      Of z(segment.parent < 0 ? kAtRest : of(segment.parent));
      if (segment.parent >= 0) {
        const auto& way = ways_[index(n)];
        const S back[] = {-way[0], -way[1], -way[2]};
        z.template add_crossed<3>(back);
      }
      for (int k = segment.first; k < std::min(segment.end, end); ++k) {
        const Row& row = rows_[index(k)];
        const Packet scale = pset1<Packet>(factor * row.inverse_pivot);
        Packet x[] = {pmul(scale, pload<Packet>(packet(k, p)))...};
        z.dot(row.yield, x);
        (pstore(packet(k, p), x[p]), ...);
        z.add(row.twist, x);
      }
      z.store(of(n));
    }
  }

  std::array<Row, static_cast<std::size_t>(N)> rows_;
  std::array<std::array<S, 3>, static_cast<std::size_t>(kSegments.count)> ways_;  ///< to each segment's O
};

}  // namespace ALEMBERT_INSTRUCTIONS
}  // namespace detail
}  // namespace alembert
