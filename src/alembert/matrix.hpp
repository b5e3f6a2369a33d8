// Matrices with the sizes of a mechanism. In: scalar type, rows, columns. Out: Eigen's matrix of that fixed
// size where Eigen lets it stand on the stack, otherwise one that keeps its numbers on the heap and has its
// size from the start.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <type_traits>

// Where classes are laid out by the instructions that a file is compiled for, their names have this in them, so that
// files compiled for different ones may be linked.
#if defined(__AVX512F__)
#define ALEMBERT_INSTRUCTIONS for_avx512
#elif defined(__FMA__)
#define ALEMBERT_INSTRUCTIONS for_fma
#elif defined(__AVX__)
#define ALEMBERT_INSTRUCTIONS for_avx
#else
#define ALEMBERT_INSTRUCTIONS for_any
#endif

namespace alembert {

/// A matrix of R x C numbers on the heap. To Eigen it is a dynamic one; copying and making one allocates, and
/// throws std::bad_alloc if there is no memory.
template <class S, int R, int C>
class HeapMatrix : public Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> {
 public:
  using Base = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
  HeapMatrix() : Base(R, C) {}
  template <class Other>
  HeapMatrix(const Eigen::MatrixBase<Other>& other) : Base(other) {}
  using Base::operator=;
  static auto Zero() { return Base::Zero(R, C); }
  static auto Identity() { return Base::Identity(R, C); }
};

namespace detail {

/// Whether Eigen allows R x C numbers of type S on the stack: up to EIGEN_STACK_ALLOCATION_LIMIT bytes, 128
/// KiB unless defined otherwise, without a limit if that is 0.
template <class S, int R, int C>
inline constexpr bool fits_stack_v =
    R == Eigen::Dynamic || C == Eigen::Dynamic || EIGEN_STACK_ALLOCATION_LIMIT == 0 ||
    sizeof(S) * static_cast<std::size_t>(R) * static_cast<std::size_t>(C) <= EIGEN_STACK_ALLOCATION_LIMIT;

}  // namespace detail

/// R x C numbers: Eigen::Matrix<S, R, C>, or HeapMatrix if that is too large for the stack (in double from
/// 129 x 129 on). Only calls that use a HeapMatrix take memory from the heap.
template <class S, int R, int C>
using SizedMatrix =
    std::conditional_t<detail::fits_stack_v<S, R, C>, Eigen::Matrix<S, R, C>, HeapMatrix<S, R, C>>;

namespace detail {

template <class S, std::size_t count>
struct NumbersOnStack {
  S* data() { return entries; }
  const S* data() const { return entries; }
  alignas(64) S entries[count];
};
/// So many numbers, on the stack where an N x N matrix is.
template <class S, int N, int count>
using Scratch = std::conditional_t<fits_stack_v<S, N, N>, NumbersOnStack<S, static_cast<std::size_t>(count)>,
                                   HeapMatrix<S, count, 1>>;

}  // namespace detail

/// Fills a matrix, or an array of matrices one after another, with entries given row by row.
template <class S, class Derived>
void from_rows(const S* entries, Eigen::MatrixBase<Derived>& matrix) {
  for (Eigen::Index r = 0; r < matrix.rows(); ++r)
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) matrix(r, c) = *entries++;
}
template <class S, class Matrix, std::size_t N>
void from_rows(const S* entries, std::array<Matrix, N>& matrices) {
  for (Matrix& matrix : matrices) {
    from_rows(entries, matrix);
    entries += matrix.size();
  }
}

}  // namespace alembert
