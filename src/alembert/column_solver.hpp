// Solutions for many right-hand sides at once, as packets of columns. In: what solves for some columns. Out: solutions,
// and an inverse, column by column; or a status that says that they are not finite. No heap unless matrices are
// HeapMatrix (matrix.hpp), no exceptions.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "alembert/floating_point.hpp"
#include "alembert/matrix.hpp"
#include "alembert/status.hpp"

namespace alembert {
namespace detail {
inline namespace ALEMBERT_INSTRUCTIONS {

/// Rows of a matrix of N columns by packets, as many numbers as an instruction takes, and packets in blocks of at
/// most so many that are done together.
template <class S, int N, int most = 1>
struct PacketColumns {
  using Packet = typename Eigen::internal::packet_traits<S>::type;
  static constexpr int kLanes = Eigen::internal::unpacket_traits<Packet>::size;
  /// Packets of a row, each of so many columns from column(packet) on: the last one starts early enough to be full.
  static constexpr int kPackets = (N + kLanes - 1) / kLanes, kWidth = N < kLanes ? N : kLanes;
  static constexpr int column(int packet) { return std::min(packet * kLanes, N - kWidth); }
  static constexpr int blocks_of(int packets) { return (packets + most - 1) / most; }
  /// Packets of each block but the last.
  static constexpr int block_packets(int packets) {
    return (packets + blocks_of(packets) - 1) / blocks_of(packets);
  }
  /// Whether a block of the packets of one row ends before column k.
  static constexpr bool ends_before(int k) { return k % (block_packets(kPackets) * kLanes) == 0; }
};

/// The speed of each row and the row of each speed.
template <std::size_t n>
struct SpeedOrder {
  int speeds[n] = {}, places[n] = {};
  bool as_rows = true;
};
template <std::size_t n, class Speeds>
constexpr SpeedOrder<n> order_of_speeds(const Speeds& speeds_of_rows) {
  SpeedOrder<n> out;
  for (std::size_t k = 0; k < n; ++k) {
    out.speeds[k] = speeds_of_rows[k];
    out.places[out.speeds[k]] = static_cast<int>(k);
    out.as_rows = out.as_rows && out.speeds[k] == static_cast<int>(k);
  }
  return out;
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"
#endif
/// Stores a packet of columns of N rows, up to row `end` or further: row(i) is where row i has it, to(j) where column j
/// of the packet goes.
template <class S, int N, class Row, class To>
void store_columns(int end, Row&& row, To&& to) {
  using namespace Eigen::internal;
  using Columns = PacketColumns<S, N>;
  constexpr int kLanes = Columns::kLanes;
  if constexpr (N < kLanes) {
    for (int j = 0; j < N; ++j)
      for (int i = 0; i < end; ++i) to(j)[i] = row(i)[j];
  } else {
    for (int p = 0; p * kLanes < end; ++p) {
      const int first = Columns::column(p);
      PacketBlock<typename Columns::Packet, kLanes> block;
      for (int i = 0; i < kLanes; ++i) block.packet[i] = ploadu<typename Columns::Packet>(row(first + i));
      ptranspose(block);
      for (int j = 0; j < kLanes; ++j) pstoreu(to(j) + first, block.packet[j]);
    }
  }
}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

/// Stores an N x N matrix that stands row by row, by rows of Order, column by column, by speeds.
template <class Order, class S>
void store_by_speeds(const S* rows, S* columns) {
  constexpr int N = static_cast<int>(Order::kSpeeds.size());
  static constexpr auto kOrder = order_of_speeds<static_cast<std::size_t>(N)>(Order::kSpeeds);
  using Columns = PacketColumns<S, N>;
  for (int p = 0; p < Columns::kPackets; ++p) {
    const int column = Columns::column(p);
    store_columns<S, N>(
        N, [&](int i) { return rows + kOrder.places[i] * N + column; },
        [&](int j) { return columns + kOrder.speeds[column + j] * N; });
  }
}

/// What solvers of A X = B have in common that take columns in packets, in the order of their rows. A Solver has
///   kOrder      SpeedOrder of its rows
///   kByRows     right-hand sides stand by rows; otherwise by speeds
///   given(k)    where row k stands in right-hand sides
///   is_tip(k)   whether row k carries no other
///   sweep(packets, rows, end, factor, given)
///               solves for as many packets as the sequence has numbers, row after row, and multiplies with factor:
///               given(row, p) is a packet of the right-hand side, which is asked for once. From row `end` on the
///               right-hand side is zero, and the solution is not wanted.
/// \tparam most  packets of one sweep at most
template <class Solver, class S, int N, int most>
class ColumnSolver {
 protected:
  using Columns = PacketColumns<S, N, most>;
  using Packet = typename Columns::Packet;
  static constexpr int kLanes = Columns::kLanes, kPackets = Columns::kPackets, kWidth = Columns::kWidth;

 public:
  /// An n x n matrix B, row by row; and where -A^-1 B goes, column by column.
  struct Sides {
    const S* rows;
    S* columns;
  };
  /// \param inverse  where A^-1 goes, column by column
  /// \return         not_finite, with all solutions left as they were, if a solution has such entries
  template <std::size_t count>
  [[nodiscard]] Status solve(const Sides (&sides)[count], S* inverse) const {
    using namespace Eigen::internal;
    constexpr int kOfSides = static_cast<int>(count) * kPackets;
    // Block after block, in each row after row.
    Rows<(kOfSides + kPackets) * kLanes> all;
    const auto at = [rows = all.data()](int packet) { return rows + packet * N * kLanes; };
    bool finite = true;
    each_block<kOfSides>([&](int first, auto packets) {
      constexpr int kCount = static_cast<int>(packets.size()), kApart = kCount * kLanes;
      const S* from[kCount];
      for (int p = 0; p < kCount; ++p)
        from[p] = sides[(first + p) / kPackets].rows + Columns::column((first + p) % kPackets);
      solver().sweep(packets, at(first), N, S(-1),
                     [&](int row, auto p) { return load(from[p], Solver::given(row)); });
      finite = finite && tips_finite<kApart>(at(first), N);
    });
    const auto end_of = [](int first, int packets) { return Columns::column(first + packets - 1) + kWidth; };
    each_block<kPackets>([&](int first, auto packets) {
      constexpr int kCount = static_cast<int>(packets.size()), kApart = kCount * kLanes;
      S* const rows = at(kOfSides + first);
      const int end = end_of(first, kCount);
      // Of rows in another order all are stored.
      if constexpr (!Solver::kOrder.as_rows) std::fill(rows + end * kApart, rows + N * kApart, S(0));
      solver().sweep(packets, rows, end, S(1),
                     [&](int row, auto p) { return unit(row - Columns::column(first + p)); });
      finite = finite && tips_finite<kApart>(rows, end);
    });
    if (!finite) return Status::not_finite;
    each_block<kOfSides>([&](int first, auto packets) {
      constexpr int kCount = static_cast<int>(packets.size()), kApart = kCount * kLanes;
      for (int p = 0; p < kCount; ++p) {
        S* const to = sides[(first + p) / kPackets].columns;
        const int column = Columns::column((first + p) % kPackets);
        store<kApart>(at(first) + p * kLanes, N, [&](int j) {
          return to + (Solver::kByRows ? Solver::kOrder.speeds[column + j] : column + j) * N;
        });
      }
    });
    each_block<kPackets>([&](int first, auto packets) {
      constexpr int kCount = static_cast<int>(packets.size()), kApart = kCount * kLanes;
      const S* const rows = at(kOfSides + first);
      for (int p = 0; p < kCount; ++p) {
        const int column = Columns::column(first + p);
        const S* const own = rows + p * kLanes;
        const auto speed = [](int row) { return Solver::kOrder.speeds[row]; };
        const auto transposed = [&](int end_of_rows) {
          store<kApart>(own, end_of_rows, [&](int j) { return inverse + speed(column + j) * N; });
        };
        // The inverse is symmetric: a packet of a row is one of a column too.
        if constexpr (Solver::kOrder.as_rows && N >= kLanes) {
          for (int i = 0; i < end_of(first, kCount); ++i)
            pstoreu(inverse + i * N + column, pload<Packet>(own + i * kApart));
          transposed(Columns::column(first));
        } else {
          transposed(N);
          for (int i = 0; i < Columns::column(first); ++i)
            for (int j = 0; j < kWidth; ++j) inverse[speed(i) * N + speed(column + j)] = own[i * kApart + j];
        }
      }
    });
    return Status::ok;
  }

 protected:
  /// Rows of some columns.
  template <int columns>
  using Rows = Scratch<S, N, N * columns>;

  /// A packet of a row of an n x n matrix that stands row by row, with zeros where the row is shorter.
  /// \param columns  where the packet's columns stand in the first row
  static Packet load(const S* columns, int row) {
    using namespace Eigen::internal;
    const S* const from = columns + row * N;
    if constexpr (N >= kLanes) {
      return ploadu<Packet>(from);
    } else if (row * N + kLanes <= N * N) {
      return pand(ploadu<Packet>(from), pcmp_lt(plset<Packet>(S(0)), pset1<Packet>(S(N))));
    } else {
      alignas(64) S all[kLanes] = {};
      std::copy(from, from + N, all);
      return pload<Packet>(all);
    }
  }
  /// A packet with a one at this place, or zeros.
  static Packet unit(int place) {
    struct Window {
      S entries[2 * kLanes] = {};
      constexpr Window() { entries[kLanes - 1] = S(1); }
    };
    static constexpr Window kWindow;
    return Eigen::internal::ploadu<Packet>(kWindow.entries +
                                           (place >= 0 && place < kLanes ? kLanes - 1 - place : kLanes));
  }

 private:
  const Solver& solver() const { return static_cast<const Solver&>(*this); }

  /// call(first packet, sequence of as many numbers as there are packets) for each block.
  template <int packets, class Call>
  static void each_block(Call&& call) {
    constexpr int kEach = Columns::block_packets(packets);
    constexpr int kLast = (Columns::blocks_of(packets) - 1) * kEach;
    for (int first = 0; first < kLast; first += kEach) call(first, std::make_index_sequence<kEach>());
    call(kLast, std::make_index_sequence<packets - kLast>());
  }
  /// Whether solutions of rows before `end` are finite: those rows have all, after all that carries them, that carry
  /// no other. What is not finite stays so when it is multiplied, with a zero of L too.
  template <int apart>
  static bool tips_finite(const S* rows, int end) {
    bool finite = true;
    for (int k = 0; k < end; ++k)
      if (k + 1 == end || Solver::is_tip(k))
        finite = finite && all_finite(static_cast<std::size_t>(apart), rows + k * apart);
    return finite;
  }
  /// A packet of each row before `end`, or more, to(j) being where column j of it goes.
  template <int apart, class To>
  static void store(const S* rows, int end, To&& to) {
    store_columns<S, N>(
        end, [&](int i) { return rows + Solver::kOrder.places[i] * apart; }, to);
  }
};

}  // namespace ALEMBERT_INSTRUCTIONS
}  // namespace detail
}  // namespace alembert
