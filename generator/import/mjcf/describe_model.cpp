// The sections of a description in order (see the header).
#include "import/mjcf/describe_model.hpp"

#include <fmt/format.h>

#include "import/common/fit_names.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/mjcf/relation_nodes.hpp"

namespace alembert {

DescribedRobot describe_model(const MjcfModel& model, std::shared_ptr<const SourceText> source,
                              const DescribeOptions& options) {
  Warnings warnings;
  const SourceLocation& top = model.where;
  DescriptionNodes nodes(model.places);
  MjcfNaming naming(model, warnings);
  const MjcfBodyNodes body_nodes(nodes, model, naming, options, warnings);
  YamlNode &coordinates = nodes.sequence(top), &definitions = nodes.mapping(top),
           &bodies = nodes.sequence(top), &frames = nodes.sequence(top), &inputs = nodes.sequence(top),
           &states = nodes.sequence(top), &forces = nodes.sequence(top), &outputs = nodes.sequence(top),
           &constraints = nodes.sequence(top);
  body_nodes.add_coordinates(coordinates);
  if (coordinates.items.empty())
    throw InputError(top, "no joint of the model moves", "a <freejoint/> lets a body move");
  for (const std::size_t joint : naming.followers())
    nodes.put(definitions, naming.coordinates(joint)[0],
              nodes.text(naming.definition(joint), model.joints[joint].where));
  for (std::size_t b = 1; b < model.bodies.size(); ++b) body_nodes.add_body(bodies, b);
  body_nodes.add_scenery(bodies);
  MjcfForceNodes force_nodes(nodes, model, naming, options, body_nodes, frames);
  for (std::size_t t = 0; t < model.tendons.size(); ++t)
    if (model.tendons[t].armature != 0) body_nodes.add_tendon_armature(bodies, t, force_nodes.length(t));
  for (std::size_t s = 0; s < model.sites.size(); ++s) {
    const MjcfPlace& site = model.sites[s];
    body_nodes.add_frame(frames, naming.frame(s), site.body, site.pose, site.where);
  }
  force_nodes.add_inputs(inputs);
  force_nodes.add_states(states);
  force_nodes.add_forces(forces);
  MjcfRelationNodes relations(nodes, model, naming, body_nodes, force_nodes, frames, warnings);
  relations.add_constraints(constraints);
  relations.add_outputs(outputs);

  YamlNode& root =
      nodes.root(options.name_or(model.name), fmt::format("MuJoCo model '{}'", printable(model.name)), top);
  if (model.gravity != Eigen::Vector3d(0, 0, -9.81))
    nodes.put(root, "gravity", nodes.numbers({model.gravity.x(), model.gravity.y(), model.gravity.z()}, top));
  nodes.put(root, "coordinates", coordinates);
  for (const auto& [key, section] : {std::pair("definitions", &definitions),
                                     {"bodies", &bodies},
                                     {"frames", &frames},
                                     {"inputs", &inputs},
                                     {"states", &states},
                                     {"forces", &forces},
                                     {"outputs", &outputs},
                                     {"constraints", &constraints}})
    if (!section->items.empty()) nodes.put(root, key, *section);
  return {Document(std::move(source), nodes.take(), root), std::move(warnings),
          "left out: contacts, meshes of viewers, cameras, lights and the solver's settings", model.files};
}

}  // namespace alembert
