// Packs of states between memory and generated functions over many states. In: ALEMBERT_PACK_NAMESPACE, as for
// pack.hpp. Out, in that namespace: the windows in which the states of a range are done, their loads and
// stores.
//
// Results lie stride * 8 bytes apart, each on a page of its own. What a window has of them stands in a buffer
// first, each value once however often it is a result, and goes out row by row. Results that no cache of a
// core would hold go past the caches in full lines, since a line that is written into a cache is read before:
// then the time of a state does not grow with their number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "alembert/batch.hpp"
#include "alembert/pack.hpp"

#if defined(__GNUC__) && defined(__SSE2__)
#include <immintrin.h>
#if ALEMBERT_PACK_LANES == 8
#define ALEMBERT_PACK_STREAM(to, v) _mm512_stream_pd(to, v)
#elif ALEMBERT_PACK_LANES == 4
#define ALEMBERT_PACK_STREAM(to, v) _mm256_stream_pd(to, v)
#else
#define ALEMBERT_PACK_STREAM(to, v) _mm_stream_pd(to, v)
#endif
#define ALEMBERT_PACK_FENCE() _mm_sfence()
#endif

namespace alembert::ALEMBERT_PACK_NAMESPACE {

/// Doubles in a line of a cache, and how many of them stand before x.
constexpr int kLine = 8;
inline int before_in_line(const double* x) {
  return static_cast<int>(reinterpret_cast<::std::uintptr_t>(x) / sizeof(double) % kLine);
}

/// Results that take the rows of a buffer as they are; otherwise an array of indices says which.
struct SameRows {
  constexpr int operator[](int i) const { return i; }
};

/// The most packs that are done together.
constexpr int kMostPacks = 16;

/// Packs that are done together: states first ... first + packs * kLanes - 1, or a single pack of fewer
/// states, `count`. Of a single pack the states from `from` on up to `until` are in no other window.
struct Window {
  ::std::size_t first;
  int packs;
  int count = Pack::kLanes;
  int from = 0;
  int until = count;
  bool streamed = false;  ///< results go past the caches

  /// One entry of an array: that of pack k goes to out[k * step]. Lanes without a state get the last one.
  void load(const double* row, Pack* out, int step) const {
    const double* source = row + first;
    if (count == Pack::kLanes) {
      for (int k = 0; k < packs; ++k) out[k * step] = Pack::load(source + k * Pack::kLanes);
    } else {
      double lanes[Pack::kLanes];
      for (int i = 0; i < Pack::kLanes; ++i) lanes[i] = source[i < count ? i : count - 1];
      *out = Pack::load(lanes);
    }
  }

  /// n entries, one after the other and not one pack after the other: a stride may be such that all entries
  /// of a state fall on the same few places of a cache.
  void load(int n, const double* x, ::std::size_t stride, Pack* out) const {
    for (int i = 0; i < n; ++i) load(x + static_cast<::std::size_t>(i) * stride, out + i, n);
  }
  /// Entry i is entry rows[i] of the `size` that a pack has in the buffer.
  template <class Rows>
  void store(int n, const Rows& rows, int size, const Pack* in, double* x, ::std::size_t stride) const {
    double* to = x + first;
    if (streamed) {
      for (int i = 0; i < n; ++i, to += stride) stream(in + rows[i], size, to);
    } else if (count == Pack::kLanes) {
      for (int i = 0; i < n; ++i, to += stride)
        for (int k = 0; k < packs; ++k) in[rows[i] + k * size].store(to + k * Pack::kLanes);
    } else {
      for (int i = 0; i < n; ++i, to += stride) {
        double lanes[Pack::kLanes];
        in[rows[i]].store(lanes);
        for (int k = 0; k < count; ++k) to[k] = lanes[k];
      }
    }
  }

  /// New states of a pack whose lane of `sum` is not zero.
  ::std::size_t count_not_finite(const Pack& sum) const {
    return static_cast<::std::size_t>(sum.count_not_zero(from, until));
  }

 private:
  /// Full lines past the caches, what is left at both ends into them.
  void stream(const Pack* in, int step, double* to) const {
#ifdef ALEMBERT_PACK_STREAM
    const int before = before_in_line(to), end = before + packs * Pack::kLanes;
    if (before == 0 && end % kLine == 0) {
      for (int k = 0; k < packs; ++k) ALEMBERT_PACK_STREAM(to + k * Pack::kLanes, in[k * step].v);
      return;
    }
    alignas(64) double lines[kMostPacks * Pack::kLanes + kLine];
    for (int k = 0; k < packs; ++k) in[k * step].store(lines + before + k * Pack::kLanes);
    double* const line = to - before;
    int i = before;
    for (; i % kLine != 0 && i < end; ++i) line[i] = lines[i];
    for (; i + kLine <= end; i += kLine)
      for (int k = i; k < i + kLine; k += Pack::kLanes)
        ALEMBERT_PACK_STREAM(line + k, Pack::load(lines + k).v);
    for (; i < end; ++i) line[i] = lines[i];
#else
    for (int k = 0; k < packs; ++k) in[k * step].store(to + k * Pack::kLanes);
#endif
  }
};

/// An array that is too large for the stack.
using HeapArray = ::std::vector<Pack>;

/// Packs that are done together if a function has `size` values for each: no more than half fill a
/// second-level cache, and whole lines of results.
constexpr int packs_together(::std::size_t size) {
  constexpr ::std::size_t kBytes = ::std::size_t{1} << 18;
  constexpr int kPacksOfLine = kLine / Pack::kLanes;
  const ::std::size_t packs = kBytes / (size * sizeof(Pack));
  if (packs < kPacksOfLine) return packs < 1 ? 1 : static_cast<int>(packs);
  return packs < kMostPacks ? static_cast<int>(packs) / kPacksOfLine * kPacksOfLine : kMostPacks;
}

/// Whether the results of so many states, of `size` values each, are more than a core's caches hold.
constexpr bool is_streamed(::std::size_t states, ::std::size_t size) {
  constexpr ::std::size_t kBytes = ::std::size_t{1} << 21;
  return states >= kBytes / sizeof(double) / size;
}

/// Calls body(window) -> number of failures for the windows of a range, of up to kPacks packs, and adds up.
/// The last one overlaps the one before, whose states it computes again: no lane is left empty unless the
/// range is shorter than a pack. `streamed`: the array whose rows go past the caches, or null; windows then
/// begin with a line of its first row.
template <int kPacks, class Body>
::std::size_t for_each_window(::std::size_t first, ::std::size_t last, const double* streamed,
                              const Body& body) {
  constexpr ::std::size_t kLanes = Pack::kLanes;
  if (last - first < kLanes) return body(Window{first, 1, static_cast<int>(last - first)});
  ::std::size_t failed = 0, at = first;
  if (streamed != nullptr && last - first >= 2 * kLine + kLanes) {
    const ::std::size_t begin =
        first + static_cast<::std::size_t>((kLine - before_in_line(streamed + first)) % kLine);
    while (at < begin) {
      const ::std::size_t count = begin - at < kLanes ? begin - at : kLanes;
      failed += body(Window{at, 1, Pack::kLanes, 0, static_cast<int>(count)});
      at += count;
    }
  }
  while (at + kLanes <= last) {
    const ::std::size_t packs = (last - at) / kLanes;
    Window window{at, packs < kPacks ? static_cast<int>(packs) : kPacks};
    window.streamed = streamed != nullptr;
    failed += body(window);
    at += static_cast<::std::size_t>(window.packs) * kLanes;
  }
  if (at < last)
    failed += body(Window{last - kLanes, 1, Pack::kLanes, static_cast<int>(at - (last - kLanes))});
#ifdef ALEMBERT_PACK_FENCE
  if (streamed != nullptr) ALEMBERT_PACK_FENCE();
#endif
  return failed;
}

}  // namespace alembert::ALEMBERT_PACK_NAMESPACE

#undef ALEMBERT_PACK_STREAM
#undef ALEMBERT_PACK_FENCE
