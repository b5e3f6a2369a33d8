// Sizes of arrays (see the header).
#include "functions/array_shape.hpp"

#include <algorithm>

#include "mechanism/constraint_rows.hpp"
#include "mechanism/force_names.hpp"
#include "mechanism/parameter_places.hpp"
#include "support/error.hpp"

namespace alembert {

namespace {

std::size_t number_of(Extent::Of what, const Mechanism& mechanism) {
  switch (what) {
    case Extent::Of::number:
      return 1;
    case Extent::Of::coordinates:
      return static_cast<std::size_t>(mechanism.nq);
    case Extent::Of::speeds:
      return static_cast<std::size_t>(mechanism.nv);
    case Extent::Of::constraint_rows:
      return constraint_rows(mechanism).size();
    case Extent::Of::outputs:
      return mechanism.outputs.size();
    case Extent::Of::parameters:
      return placed_parameters(mechanism, ParameterRole::parameter).size();
    case Extent::Of::inputs:
      return placed_parameters(mechanism, ParameterRole::input).size();
    case Extent::Of::base_parameters:
      return mechanism.base_columns.size();
    case Extent::Of::forces:
      return force_names(mechanism).size();
    case Extent::Of::states:
      return placed_parameters(mechanism, ParameterRole::state).size();
    case Extent::Of::bodies:
      return mechanism.bodies.size();
  }
  throw InternalError("there is no such extent");
}
std::size_t number_of(const Extent& extent, const Mechanism& mechanism) {
  return static_cast<std::size_t>(extent.number) * number_of(extent.of, mechanism);
}

std::size_t number_of(Per per, const Mechanism& mechanism) {
  switch (per) {
    case Per::mechanism:
      return 1;
    case Per::body:
      return mechanism.bodies.size();
    case Per::frame:
      return mechanism.frames.size();
  }
  throw InternalError("there are no such blocks");
}

}  // namespace

ArrayShape array_shape(const ResultArray& result, const Mechanism& mechanism) {
  return {number_of(result.per, mechanism), number_of(result.rows, mechanism),
          number_of(result.columns, mechanism)};
}

std::vector<std::size_t> natural_shape(const ResultArray& result, const Mechanism& mechanism) {
  const ArrayShape shape = array_shape(result, mechanism);
  std::vector<std::size_t> sizes;
  const bool several = result.per != Per::mechanism;
  if (several) sizes.push_back(shape.blocks);
  if (!several || result.rows != Extent(1)) sizes.push_back(shape.rows);
  if (result.columns != Extent(1)) sizes.push_back(shape.columns);
  return sizes;
}

TableShape table_shape(const ResultArray& result, const Mechanism& mechanism) {
  const ArrayShape shape = array_shape(result, mechanism);
  if (result.per == Per::mechanism || has_speed_columns(result))
    return {shape.blocks * shape.rows, shape.columns};
  return {shape.blocks, shape.rows * shape.columns};
}

std::size_t argument_size(ArgumentKind kind, const Mechanism& mechanism) {
  switch (kind) {
    case ArgumentKind::q:
      return static_cast<std::size_t>(mechanism.nq);
    case ArgumentKind::qd:
    case ArgumentKind::qdd:
    case ArgumentKind::tau:
    case ArgumentKind::mu:
      return static_cast<std::size_t>(mechanism.nv);
    case ArgumentKind::time:
      return 1;
    case ArgumentKind::parameter:
      return static_cast<std::size_t>(std::ranges::count_if(mechanism.parameters, &Parameter::runtime));
    case ArgumentKind::wrench:
      return 6 * static_cast<std::size_t>(std::ranges::count_if(mechanism.bodies, &Body::external_wrench));
  }
  throw InternalError("there is no such argument");
}

bool has_results(const OutputFunction& function, const Mechanism& mechanism) {
  if (function.needs == Needs::forces && mechanism.forces.empty()) return false;
  const auto has_no_mass = [](const Body& body) { return body.mass_properties.mass.is_zero(); };
  const auto has_no_inertia = [](const Body& body) { return body.mass_properties.is_zero(); };
  if (function.needs == Needs::mass && std::ranges::all_of(mechanism.bodies, has_no_mass)) return false;
  if (function.needs == Needs::inertia && std::ranges::all_of(mechanism.bodies, has_no_inertia)) return false;
  if (function.needs == Needs::outputs_of_position &&
      std::ranges::any_of(mechanism.outputs, &Output::of_speeds))
    return false;
  return std::ranges::all_of(
      function.results, [&](const ResultArray& result) { return array_shape(result, mechanism).size() > 0; });
}

}  // namespace alembert
