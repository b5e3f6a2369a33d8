// Solves M X = B for many right-hand sides at once. In: a mass matrix. Out: its factors, without the zeros
// between branches, and solutions; or a status that says why there are none. No heap unless M is a HeapMatrix
// (matrix.hpp), no exceptions.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include "alembert/floating_point.hpp"
#include "alembert/matrix.hpp"
#include "alembert/status.hpp"

namespace alembert {
namespace detail {

/// A = L^T D L for a symmetric positive definite A, from the last row up: where rows are speeds of a tree, each
/// joint after those that carry it, L keeps the zeros of A between branches. After Featherstone, Rigid Body
/// Dynamics Algorithms, 2008, section 6.5. `in_pairs`: whether two rows are solved for at once where they take the same
/// others, each of which is then loaded once; of fewer than 32 vector registers it takes too many.
template <class S, int N, bool in_pairs = (EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS >= 32)>
class BranchSolver {
  static_assert(N > 0, "the size must be positive");

 public:
  /// \param A  n x n; only the upper triangle is used
  /// \return   not_finite or not_positive_definite as of factor_ldlt
  template <class Square>
  [[nodiscard]] Status factor(const Square& A) {
    const S rounding = S(N) * std::numeric_limits<S>::epsilon();
    rows_.template topRows<N>() = A;
    rows_.template bottomRows<kPadded - N>().setZero();
    carried_count_.fill(0);
    std::array<std::bitset<N>, static_cast<std::size_t>(N)> carrying_rows, carried_rows;
    for (int k = N; k-- > 0;) {
      const auto at = static_cast<std::size_t>(k);
      const S* const row = &rows_(0, k);
      const S pivot = row[k];
      if (!is_finite(pivot)) return Status::not_finite;
      if (!(pivot > S(0)) || !(pivot > rounding * A(k, k))) return Status::not_positive_definite;
      const S inverse = inverse_pivot_[at] = S(1) / pivot;
      int count = 0;
      for (int i = 0; i < k; ++i) {
        if (row[i] == S(0)) continue;
        const S l = -row[i] * inverse;
        carrying(k)[count++] = {l, i};
        carried(i)[carried_count_[static_cast<std::size_t>(i)]++] = {l, k};
        if constexpr (in_pairs)
          carrying_rows[at][static_cast<std::size_t>(i)] = carried_rows[static_cast<std::size_t>(i)][at] =
              true;
        // What lies beyond the diagonal is not used.
        add_row(l, row, i / kLanes + 1, &rows_(0, i));
      }
      carrying_count_[at] = count;
    }
    if constexpr (in_pairs) {
      for (std::size_t k = 0; k < static_cast<std::size_t>(N); ++k) {
        const auto adds_row = [&](std::bitset<N> first, const std::bitset<N>& second) {
          first[k] = true;
          return first == second;
        };
        carried_pairs_[k] = k > 0 && adds_row(carried_rows[k], carried_rows[k - 1]);
        carrying_pairs_[k] = k + 1 < N && adds_row(carrying_rows[k], carrying_rows[k + 1]);
      }
    }
    return Status::ok;
  }

  /// x = A^-1 x.
  void solve(Eigen::Matrix<S, N, 1>& x) const {
    for (int k = N; k-- > 1;) {
      const S of_k = x(k);
      for (int e = 0; e < carrying_count_[static_cast<std::size_t>(k)]; ++e)
        x(carrying(k)[e].row) += carrying(k)[e].value * of_k;
    }
    for (int k = 0; k < N; ++k) {
      S sum = x(k) * inverse_pivot_[static_cast<std::size_t>(k)];
      for (int e = 0; e < carrying_count_[static_cast<std::size_t>(k)]; ++e)
        sum += carrying(k)[e].value * x(carrying(k)[e].row);
      x(k) = sum;
    }
  }

  /// An n x n matrix B, row by row; and where -A^-1 B goes, column by column.
  struct Sides {
    const S* rows;
    S* columns;
  };
  /// \param inverse  where A^-1 goes, column by column
  /// \return         not_finite, with all solutions left as they were, if a solution has such entries
  template <std::size_t count>
  [[nodiscard]] Status solve(const Sides (&sides)[count], S* inverse) const {
    constexpr int kColumns = static_cast<int>(count) * N, kPackets = (kColumns + kLanes - 1) / kLanes;
    constexpr int kApart = kPackets * kLanes + kPadded;
    constexpr int kBlocks = (kPackets + kMostPackets - 1) / kMostPackets;
    Rows<kApart> all;
    S* const rows = all.data();
    for (int side = 0; side < static_cast<int>(count); ++side)
      load<kApart>(sides[side].rows, rows + side * N);
    for (int i = 0; i < N; ++i) {
      std::fill(rows + i * kApart + kColumns, rows + (i + 1) * kApart, S(0));
      rows[i * kApart + kPackets * kLanes + i] = S(1);
    }
    sweep_blocks<kApart, kPackets, kBlocks>(rows, false);
    S* const unit = rows + kPackets * kLanes;
    sweep_blocks<kApart, kUnitPackets, kUnitBlocks>(unit, true);
    if (!all_finite(static_cast<std::size_t>(N) * kApart, static_cast<const S*>(rows)))
      return Status::not_finite;
    const auto store_columns = [](const S* from, int columns, auto&& target) {
      for (int column = 0; column < columns; column += kLanes) {
        S* to[kLanes];
        const int width = std::min(kLanes, columns - column);
        for (int j = 0; j < width; ++j) to[j] = target(column + j);
        store<kApart>(from + column, width, to);
      }
    };
    store_columns(rows, kColumns, [&](int column) { return sides[column / N].columns + column % N * N; });
    store_columns(unit, N, [&](int column) { return inverse + column * N; });
    for (int block = 0; block < kUnitBlocks - 1; ++block) {
      constexpr int kInBlock = block_columns(kUnitPackets, kUnitBlocks);
      const int first = block * kInBlock, end = first + kInBlock;
      for (int column = first; column < end; ++column)
        for (int i = end; i < N; ++i) inverse[column * N + i] = inverse[i * N + column];
    }
    return Status::ok;
  }

 private:
  /// An entry of -L, and the row that it multiplies.
  struct Entry {
    S value;
    int row;
  };
  using Packet = typename Eigen::internal::packet_traits<S>::type;
  static constexpr int kLanes = Eigen::internal::unpacket_traits<Packet>::size;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"
#endif
  using Block = Eigen::internal::PacketBlock<Packet, kLanes>;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
  static constexpr int kPadded = (N + kLanes - 1) / kLanes * kLanes;
  // Columns that are done together, in so many registers: sums that do not wait for each other.
  static constexpr int kMostPackets = 8, kFewPackets = 5;
  static constexpr int kUnitPackets = kPadded / kLanes;
  static constexpr int kUnitBlocks =
      kUnitPackets < kFewPackets ? 1 : std::max(2, (kUnitPackets + kMostPackets - 1) / kMostPackets);
  /// Columns of each block but the last.
  static constexpr int block_columns(int packets, int blocks) {
    return (packets + blocks - 1) / blocks * kLanes;
  }
  static constexpr std::size_t kMost = N > 1 ? static_cast<std::size_t>(N) * (N - 1) / 2 : 1;

  /// Row k of L: what carries k.
  Entry* carrying(int k) {
    return carrying_.data() + k * (k - 1) / 2;
  }
  const Entry* carrying(int k) const {
    return carrying_.data() + k * (k - 1) / 2;
  }
  /// Column k of L: what k carries.
  Entry* carried(int k) {
    return carried_.data() + k * (2 * N - 1 - k) / 2;
  }
  const Entry* carried(int k) const {
    return carried_.data() + k * (2 * N - 1 - k) / 2;
  }

  /// Rows of some columns, on the stack where M is.
  template <int columns>
  struct RowsOnStack {
    S* data() { return entries; }
    alignas(64) S entries[static_cast<std::size_t>(N) * columns];
  };
  template <int columns>
  using Rows = std::conditional_t<fits_stack_v<S, N, N>, RowsOnStack<columns>, HeapMatrix<S, columns, N>>;

  /// The negative of a matrix that stands row by row, into rows so far apart.
  template <int apart>
  static void load(const S* from, S* rows) {
    using namespace Eigen::internal;
    for (int i = 0; i < N; ++i, rows += apart) {
      const S* const row = from + i * N;
      int j = 0;
      for (; j + kLanes <= N; j += kLanes) pstoreu(rows + j, pnegate(ploadu<Packet>(row + j)));
      for (; j < N; ++j) rows[j] = -row[j];
    }
  }
  /// Up to kLanes columns.
  template <int apart>
  static void store(const S* rows, int width, S* const* to) {
    using namespace Eigen::internal;
    if (N < kLanes || width < kLanes) {
      for (int j = 0; j < width; ++j)
        for (int i = 0; i < N; ++i) to[j][i] = rows[i * apart + j];
      return;
    }
    const auto turn = [&](int first) {
      Block block;
      for (int i = 0; i < kLanes; ++i) block.packet[i] = pload<Packet>(rows + (first + i) * apart);
      ptranspose(block);
      for (int j = 0; j < kLanes; ++j) pstoreu(to[j] + first, block.packet[j]);
    };
    int first = 0;
    for (; first + kLanes <= N; first += kLanes) turn(first);
    if (first < N) turn(N - kLanes);
  }

  /// All columns, block by block. Of the `identity`, only what is above the end of a block: the inverse is symmetric.
  template <int apart, int packets, int blocks>
  void sweep_blocks(S* rows, bool identity) const {
    constexpr int kColumns = block_columns(packets, blocks), kPackets = kColumns / kLanes;
    for (int block = 0; block < blocks - 1; ++block)
      sweep<apart>(rows + block * kColumns, identity ? (block + 1) * kColumns : N,
                   std::make_index_sequence<kPackets>());
    sweep<apart>(rows + (blocks - 1) * kColumns, N,
                 std::make_index_sequence<packets - (blocks - 1) * kPackets>());
  }
  /// Some columns, the rows of which are zero from `end` on, and of the solution not wanted.
  template <int apart, class Packets>
  void sweep(S* rows, int end, Packets packets) const {
    for (int k = end; k-- > 0;) {
      const Entry* entries = carried(k);
      int count = carried_count_[static_cast<std::size_t>(k)], gone = 0;
      while (gone < count && entries[gone].row >= end) ++gone;
      count -= gone;
      if (k > 0 && carried_pairs_[static_cast<std::size_t>(k)]) {
        add_two<apart>(packets, entries + gone, carried(k - 1) + gone, count, S(1), S(1), rows,
                       rows + k * apart, rows + (k - 1) * apart);
        --k;
      } else if (count > 0) {
        add<apart>(packets, entries + gone, count, S(1), rows, rows + k * apart);
      }
    }
    for (int k = 0; k < end; ++k) {
      const int count = carrying_count_[static_cast<std::size_t>(k)];
      const S* const inverse = &inverse_pivot_[static_cast<std::size_t>(k)];
      if (k + 1 < end && carrying_pairs_[static_cast<std::size_t>(k)]) {
        add_two<apart>(packets, carrying(k), carrying(k + 1), count, inverse[0], inverse[1], rows,
                       rows + k * apart, rows + (k + 1) * apart);
        ++k;
      } else {
        add<apart>(packets, carrying(k), count, inverse[0], rows, rows + k * apart);
      }
    }
  }

  /// row = scale row + (entries times their rows), for some packets.
  template <int apart, std::size_t... p>
  static void add(std::index_sequence<p...>, const Entry* entries, int count, S scale, const S* rows,
                  S* row) {
    using namespace Eigen::internal;
    const Packet factor = pset1<Packet>(scale);
    Packet x[] = {pmul(factor, pload<Packet>(row + p * kLanes))...};
    for (int e = 0; e < count; ++e) {
      const Packet l = pset1<Packet>(entries[e].value);
      const S* const from = rows + entries[e].row * apart;
      ((x[p] = pmadd(l, pload<Packet>(from + p * kLanes), x[p])), ...);
    }
    (pstore(row + p * kLanes, x[p]), ...);
  }

  /// The same for two rows, where the entries of the second are at the rows of the first's, and one more at the first.
  template <int apart, std::size_t... p>
  static void add_two(std::index_sequence<p...>, const Entry* of_first, const Entry* of_second, int count,
                      S scale_first, S scale_second, const S* rows, S* first, S* second) {
    using namespace Eigen::internal;
    const Packet factor_x = pset1<Packet>(scale_first), factor_y = pset1<Packet>(scale_second);
    Packet x[] = {pmul(factor_x, pload<Packet>(first + p * kLanes))...};
    Packet y[] = {pmul(factor_y, pload<Packet>(second + p * kLanes))...};
    for (int e = 0; e < count; ++e) {
      const Packet l = pset1<Packet>(of_first[e].value), m = pset1<Packet>(of_second[e].value);
      const S* const from = rows + of_first[e].row * apart;
      const Packet z[] = {pload<Packet>(from + p * kLanes)...};
      ((x[p] = pmadd(l, z[p], x[p])), ...);
      ((y[p] = pmadd(m, z[p], y[p])), ...);
    }
    const Packet m = pset1<Packet>(of_second[count].value);
    ((y[p] = pmadd(m, x[p], y[p])), ...);
    (pstore(first + p * kLanes, x[p]), ...);
    (pstore(second + p * kLanes, y[p]), ...);
  }

  /// row += l times another one, for some packets.
  static void add_row(S l, const S* from, int packets, S* row) {
    using namespace Eigen::internal;
    const Packet factor = pset1<Packet>(l);
    for (int at = 0; at < packets * kLanes; at += kLanes)
      pstoreu(row + at, pmadd(factor, ploadu<Packet>(from + at), ploadu<Packet>(row + at)));
  }

  SizedMatrix<S, kPadded, N> rows_;  // row k of A, then of L times its pivot, in column k up to the diagonal
  std::array<S, static_cast<std::size_t>(N)> inverse_pivot_;
  std::array<Entry, kMost> carrying_, carried_;  // the latter from the last row up
  std::array<int, static_cast<std::size_t>(N)> carrying_count_, carried_count_;
  // Rows k whose entries another row has too, and one more, at row k: row k + 1 of those carrying, row k - 1 of those
  // carried. The two are solved for at once. None unless in_pairs.
  std::bitset<N> carrying_pairs_, carried_pairs_;
};

}  // namespace detail
}  // namespace alembert
