// Mates: two surfaces that touch. In: the factors of a transform. Out: the mate that they are.
#pragma once

#include <cstddef>
#include <optional>

#include "mechanism/model.hpp"

namespace alembert {

/// S1 Rz(spin) S2^-1: three factors.
struct Mate {
  SurfaceFrame first, second;
  Expr spin;
};
inline constexpr std::size_t kMateFactors = 3;

/// The mate that begins with factor i of a transform, if there is one.
inline std::optional<Mate> mate_at(const Transform& transform, std::size_t i) {
  const auto& factors = transform.factors;
  if (i + kMateFactors > factors.size()) return std::nullopt;
  const auto* first = std::get_if<SurfaceFrame>(&factors[i].value);
  const auto* turn = std::get_if<AxisRotation>(&factors[i + 1].value);
  const auto* second = std::get_if<SurfaceFrame>(&factors[i + 2].value);
  if (first == nullptr || turn == nullptr || second == nullptr) return std::nullopt;
  if (factors[i].inverse || factors[i + 1].inverse || !factors[i + 2].inverse || turn->axis != 2)
    return std::nullopt;
  return Mate{*first, *second, turn->angle};
}

}  // namespace alembert
