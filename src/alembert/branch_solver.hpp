// Solves M X = B for many right-hand sides at once. In: a mass matrix. Out: its factors, without the zeros
// between branches, and solutions; or a status that says why there are none. No heap unless M is a HeapMatrix
// (matrix.hpp), no exceptions.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "alembert/floating_point.hpp"
#include "alembert/matrix.hpp"
#include "alembert/status.hpp"

namespace alembert {
namespace detail {

/// A = L^T D L for a symmetric positive definite A, from the last row up: where rows are speeds of a tree, each
/// joint after those that carry it, L keeps the zeros of A between branches. After Featherstone, Rigid Body
/// Dynamics Algorithms, 2008, section 6.5. Rows are kept branch by branch; up to four that follow each other in a
/// branch are done together, so that each row that they take is loaded once for all of them.
template <class S, int N>
class BranchSolver {
  static_assert(N > 0, "the size must be positive");

 public:
  /// \param A  n x n, column by column, both triangles; where entries may be not finite, look first: -ffast-math takes
  ///           NaN for zero
  /// \return   not_finite or not_positive_definite as of factor_ldlt
  template <class Square>
  [[nodiscard]] Status factor(const Square& A) {
    take_rows(A);
    carried_.clear();
    std::array<bool, static_cast<std::size_t>(N)> differ{};
    for (int last = N - 1; last >= 0;) {
      Plain plain;
      // The row before the group, if it has taken what the group adds to it, but takes others too.
      bool next_is_ready = false;
      Status status = Status::ok;
      int width = 0;
      const auto joins = [&](auto before) {
        const int k = last - before;
        if (k < 0) return false;
        if constexpr (before > 0) {
          if (starts_columns(k + 1) || is_zero(plain[0][k])) return false;
          add_rows<before>(plain, last, k);
          next_is_ready = !same_zeros(row(k), plain[0], k);
          if (next_is_ready) return false;
        }
        status = scale(k, A(speed(k), speed(k)), plain[before]);
        if (status != Status::ok) return false;
        ++width;
        return true;
      };
      static_assert(kTogether == 4);
      static_cast<void>(joins(Constant<0>()) && joins(Constant<1>()) && joins(Constant<2>()) &&
                        joins(Constant<3>()));
      if (status != Status::ok) return status;
      const int first = last - width + 1;
      int* const others = carried_.begin(first, width);
      int count = 0;
      bool has = false;
      for (int i = 0; i < first; ++i) {
        const bool had = std::exchange(has, !is_zero(plain[0][i]));
        differ[static_cast<std::size_t>(i)] |= has != had;
        others[count] = i;
        count += has ? 1 : 0;
      }
      if (!has) differ[static_cast<std::size_t>(first)] = true;
      carried_.end(count);
      with_width(width, [&](auto w) {
        for (int e = 0; e < count - (next_is_ready ? 1 : 0); ++e) add_rows<w>(plain, last, others[e]);
      });
      last = first - 1;
    }
    find_carrying(differ);
    return Status::ok;
  }

  /// x = A^-1 x.
  void solve(Eigen::Matrix<S, N, 1>& x) const {
    Rows<kLanes> all;
    S* const rows = all.data();
    std::fill(rows, rows + N * kLanes, S(0));
    for (int i = 0; i < N; ++i) rows[place(i) * kLanes] = x(i);
    sweep<kLanes>(rows, N, std::make_index_sequence<1>());
    for (int i = 0; i < N; ++i) x(i) = rows[place(i) * kLanes];
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
    const auto store_columns = [this](const S* from, int columns, auto&& target) {
      for (int column = 0; column < columns; column += kLanes) {
        S* to[kLanes];
        const int width = std::min(kLanes, columns - column);
        for (int j = 0; j < width; ++j) to[j] = target(column + j);
        store<kApart>(from + column, width, to);
      }
    };
    store_columns(rows, kColumns, [&](int column) { return sides[column / N].columns + column % N * N; });
    store_columns(unit, N, [&](int column) { return inverse + speed(column) * N; });
    // The inverse is symmetric: what is missing below a block of columns stands in its rows.
    constexpr int kInBlock = block_columns(kUnitPackets, kUnitBlocks);
    for (int i = 0; i < N; ++i)
      for (int column = (i / kInBlock + 1) * kInBlock; column < N; ++column)
        inverse[speed(i) * N + speed(column)] = unit[i * kApart + column];
    return Status::ok;
  }

 private:
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
  // Rows and packets of columns that are done together: as many sums as there are registers for.
  static constexpr int kTogether = 4;
#ifdef EIGEN_HAS_SINGLE_INSTRUCTION_MADD
  static constexpr int kMostPackets = EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS >= 32 ? 4 : 3;
#else
  static constexpr int kMostPackets = 2;
#endif
  static constexpr int kUnitPackets = kPadded / kLanes;
  static constexpr int kUnitBlocks = (kUnitPackets + kMostPackets - 1) / kMostPackets;
  /// Columns of each block but the last.
  static constexpr int block_columns(int packets, int blocks) {
    return (packets + blocks - 1) / blocks * kLanes;
  }
  static constexpr std::size_t kMost = N > 1 ? static_cast<std::size_t>(N) * (N - 1) / 2 : 1;
  /// Of up to 8 speeds zeros are not looked for: that would take longer than what they save.
  static constexpr bool kHasZeros = N > 8;

  template <int value>
  using Constant = std::integral_constant<int, value>;
  /// Rows of a group before they are scaled.
  using Plain = S[kTogether][kPadded];
  /// Rows one after the other that take the same others, besides those of the group.
  struct Group {
    int first, width;
    int others, count;  // where they are listed
  };
  /// Groups from the last row up, and their lists.
  class Groups {
   public:
    void clear() { count_ = used_ = 0; }
    /// Where the others of a new group are to be listed, one after the other.
    int* begin(int first, int width) {
      groups_[static_cast<std::size_t>(count_)] = {first, width, used_, 0};
      return others_.data() + used_;
    }
    void end(int count) {
      groups_[static_cast<std::size_t>(count_++)].count = count;
      used_ += count;
    }
    int size() const { return count_; }
    const Group& operator[](int at) const { return groups_[static_cast<std::size_t>(at)]; }
    const int* others(const Group& of) const { return others_.data() + of.others; }

   private:
    std::array<Group, static_cast<std::size_t>(N)> groups_;
    std::array<int, kMost> others_;
    int count_ = 0, used_ = 0;
  };

  static bool is_zero(S entry) {
    return kHasZeros && entry == S(0);
  }
  S* row(int k) {
    return &rows_(0, k);
  }
  int speed(int at) const {
    return speeds_[static_cast<std::size_t>(at)];
  }
  int place(int of) const {
    return places_[static_cast<std::size_t>(of)];
  }
  /// Whether columns of the inverse that are done together start here. No group has rows before and after.
  static bool starts_columns(int k) {
    return k % block_columns(kUnitPackets, kUnitBlocks) == 0;
  }
  template <int count, class Call>
  static void each(Call&& call) {
    each(call, std::make_integer_sequence<int, count>());
  }
  template <class Call, int... at>
  static void each(Call& call, std::integer_sequence<int, at...>) {
    (call(Constant<at>()), ...);
  }
  template <class Call>
  static void with_width(int width, Call&& call) {
    switch (width) {
      case 1:
        return call(Constant<1>());
      case 2:
        return call(Constant<2>());
      case 3:
        return call(Constant<3>());
      default:
        return call(Constant<kTogether>());
    }
  }

  /// Takes the rows of A branch by branch.
  template <class Square>
  void take_rows(const Square& A) {
    bool in_order = true;
    for (int k = 1; k < N; ++k) in_order = in_order && !is_zero(A(k - 1, k));
    if (in_order) {
      std::iota(speeds_.begin(), speeds_.end(), 0);
      places_ = speeds_;
    } else {
      in_order = find_branches(A);
    }
    if (in_order) {
      rows_.template topRows<N>() = A;
    } else {
      for (int k = 0; k < N; ++k) {
        const S* const from = &A(0, speed(k));
        S* const own = row(k);
        for (int i = 0; i <= k; ++i) own[i] = from[speed(i)];
        std::fill(own + k + 1, own + (k / kLanes + 1) * kLanes, S(0));
      }
    }
    rows_.template bottomRows<kPadded - N>().setZero();
  }
  /// Puts each speed after what carries it, the last one before it to which A ties it, and branch by branch.
  /// \return  whether they are in this order anyway
  template <class Square>
  bool find_branches(const Square& A) {
    constexpr int kNone = -1;
    // The first one that a speed carries, and the next one with the same carrier; at N what nothing carries.
    std::array<int, static_cast<std::size_t>(N) + 1> first, next, carrier;
    const auto of = [](auto& all, int k) -> int& { return all[static_cast<std::size_t>(k)]; };
    first.fill(kNone);
    for (int k = N; k-- > 0;) {
      const S* const column = &A(0, k);
      int by = k - 1;
      while (by >= 0 && is_zero(column[by])) --by;
      if (by < 0) by = N;
      of(carrier, k) = by;
      of(next, k) = std::exchange(of(first, by), k);
    }
    bool in_order = true;
    for (int k = 0, at = of(first, N); k < N; ++k) {
      of(speeds_, k) = at;
      of(places_, at) = k;
      in_order = in_order && at == k;
      if (of(first, at) != kNone) {
        at = of(first, at);
        continue;
      }
      while (at != N && of(next, at) == kNone) at = of(carrier, at);
      if (at != N) at = of(next, at);
    }
    return in_order;
  }

  /// Makes row k, which has taken all, one of -L.
  /// \param whole  its pivot as it was in A
  /// \param plain  where it goes as it is now
  [[nodiscard]] Status scale(int k, S whole, S* plain) {
    using namespace Eigen::internal;
    S* const own = row(k);
    const S pivot = own[k];
    if (!is_finite(pivot)) return Status::not_finite;
    if (!(pivot > S(0)) || !(pivot > S(N) * std::numeric_limits<S>::epsilon() * whole))
      return Status::not_positive_definite;
    inverse_pivot_[static_cast<std::size_t>(k)] = S(1) / pivot;
    const Packet factor = pset1<Packet>(S(-1) / pivot);
    for (int at = 0; at < k; at += kLanes) {
      const Packet entries = ploadu<Packet>(own + at);
      pstoreu(plain + at, entries);
      pstoreu(own + at, pmul(factor, entries));
    }
    return Status::ok;
  }

  /// Adds to row i of A what the rows from `last` down have for it.
  template <int width>
  void add_rows(const Plain& plain, int last, int i) {
    using namespace Eigen::internal;
    const S* const from = row(last);
    S* const own = row(i);
    Packet factors[width];
    each<width>([&](auto r) { factors[r] = pset1<Packet>(plain[r][i]); });
    // What lies beyond the diagonal is not used.
    for (int at = 0; at <= i; at += kLanes) {
      Packet sum = ploadu<Packet>(own + at);
      each<width>([&](auto r) { sum = pmadd(factors[r], ploadu<Packet>(from + at - r * kPadded), sum); });
      pstoreu(own + at, sum);
    }
  }

  /// Whether the first n entries are zero in both or in none.
  static bool same_zeros(const S* a, const S* b, int n) {
    using namespace Eigen::internal;
    if (!kHasZeros) return true;
    const Packet zero = pset1<Packet>(S(0)), one = pset1<Packet>(S(1));
    Packet differ = zero;
    int i = 0;
    for (; i + kLanes <= n; i += kLanes) {
      const Packet of_a = pcmp_eq(ploadu<Packet>(a + i), zero), of_b = pcmp_eq(ploadu<Packet>(b + i), zero);
      differ = por(differ, pand(one, pxor(of_a, of_b)));
    }
    bool same = predux(differ) == S(0);
    for (; i < n; ++i) same = same && (a[i] == S(0)) == (b[i] == S(0));
    return same;
  }

  /// Groups rows by what they carry.
  /// \param differ  at k, whether a row from k on has a zero in one only of columns k - 1 and k of L
  void find_carrying(const std::array<bool, static_cast<std::size_t>(N)>& differ) {
    carrying_.clear();
    for (int last = N - 1; last >= 0;) {
      int first = last;
      while (first > 0 && last - first + 1 < kTogether && !starts_columns(first) &&
             !differ[static_cast<std::size_t>(first)])
        --first;
      int* const others = carrying_.begin(first, last - first + 1);
      int count = 0;
      for (int e = N - 1; e > last; --e) {
        others[count] = e;
        count += is_zero(row(e)[last]) ? 0 : 1;
      }
      carrying_.end(count);
      last = first - 1;
    }
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
  void load(const S* from, S* all) const {
    using namespace Eigen::internal;
    for (int i = 0; i < N; ++i) {
      S* const rows = all + place(i) * apart;
      const S* const own = from + i * N;
      int j = 0;
      for (; j + kLanes <= N; j += kLanes) pstoreu(rows + j, pnegate(ploadu<Packet>(own + j)));
      for (; j < N; ++j) rows[j] = -own[j];
    }
  }
  /// Up to kLanes columns.
  template <int apart>
  void store(const S* rows, int width, S* const* to) const {
    using namespace Eigen::internal;
    if (N < kLanes || width < kLanes) {
      for (int j = 0; j < width; ++j)
        for (int i = 0; i < N; ++i) to[j][i] = rows[place(i) * apart + j];
      return;
    }
    const auto turn = [&](int first) {
      Block block;
      for (int i = 0; i < kLanes; ++i) block.packet[i] = pload<Packet>(rows + place(first + i) * apart);
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
    for (int at = 0; at < carrying_.size(); ++at) {
      const Group& group = carrying_[at];
      if (group.first >= end) continue;
      const int* others = carrying_.others(group);
      const int* const others_end = others + group.count;
      while (others < others_end && *others >= end) ++others;
      with_width(group.width, [&](auto width) {
        add<apart, width, true>(packets, group.first, others, others_end, rows);
      });
    }
    for (int at = carried_.size(); at-- > 0;) {
      const Group& group = carried_[at];
      if (group.first >= end) break;
      const int* const others = carried_.others(group);
      with_width(group.width, [&](auto width) {
        add<apart, width, false>(packets, group.first, others, others + group.count, rows);
      });
    }
  }

  /// To rows from `first` on, for some packets, entries of -L times other rows: of those that they carry, or, after
  /// division by the pivots, of those that carry them.
  template <int apart, int width, bool carrying, std::size_t... p>
  void add(std::index_sequence<p...>, int first, const int* others, const int* others_end, S* rows) const {
    using namespace Eigen::internal;
    constexpr int kPackets = static_cast<int>(sizeof...(p));
    // Where entries stand in rows_: from one row of the group to the next, from one of the others to the next.
    constexpr int kRowApart = carrying ? 1 : kPadded, kOtherApart = carrying ? kPadded : 1;
    const S* const entries = rows_.data() + first * kRowApart;
    S* const own = rows + first * apart;
    Packet x[width * kPackets];
    each<width>([&](auto r) {
      ((x[r * kPackets + p] = pload<Packet>(own + r * apart + p * kLanes)), ...);
      if constexpr (!carrying) {
        const Packet factor = pset1<Packet>(inverse_pivot_[static_cast<std::size_t>(first + r)]);
        ((x[r * kPackets + p] = pmul(factor, x[r * kPackets + p])), ...);
      }
    });
    for (; others < others_end; ++others) {
      const S* const from = rows + *others * apart;
      const S* const l = entries + *others * kOtherApart;
      const Packet z[] = {pload<Packet>(from + p * kLanes)...};
      each<width>([&](auto r) {
        const Packet factor = pset1<Packet>(l[r * kRowApart]);
        ((x[r * kPackets + p] = pmadd(factor, z[p], x[r * kPackets + p])), ...);
      });
    }
    // Then rows of the group, each when it has taken all.
    each<width>([&](auto turn) {
      constexpr int done = carrying ? width - 1 - turn : turn;
      const S* const l = entries + (first + done) * kOtherApart;
      each<width>([&](auto r) {
        if constexpr (carrying ? r < done : r > done) {
          const Packet factor = pset1<Packet>(l[r * kRowApart]);
          ((x[r * kPackets + p] = pmadd(factor, x[done * kPackets + p], x[r * kPackets + p])), ...);
        }
      });
    });
    each<width>([&](auto r) { (pstore(own + r * apart + p * kLanes, x[r * kPackets + p]), ...); });
  }

  std::array<int, static_cast<std::size_t>(N)> speeds_,
      places_;                       // the speed of each row, and the row of each
  SizedMatrix<S, kPadded, N> rows_;  // row k of A, then of -L, in column k up to the diagonal
  std::array<S, static_cast<std::size_t>(N)> inverse_pivot_;
  Groups carried_, carrying_;  // rows by what carries them, and by what they carry
};

}  // namespace detail
}  // namespace alembert
