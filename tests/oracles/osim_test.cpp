// `alembert import` of models of OpenSim against Simbody: the same file through both, M, c and g at random states,
// and lengths and moment arms of paths against differences of lengths.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "oracles/alembert_process.hpp"
#include "oracles/osim/imported.hpp"

namespace alembert::oracles {
namespace {

namespace fs = std::filesystem;

constexpr double kTolerance = 1e-9;
constexpr double kArmTolerance = 1e-7;  ///< of derivatives by differences
constexpr int kModelStates = 6;

/// The model with inertias that bodies can have, in a file of its own: Simbody refuses others.
class Possible {
 public:
  explicit Possible(const fs::path& file) {
    pugi::xml_document document;
    if (!document.load_file(file.c_str())) throw std::runtime_error("no XML: " + file.string());
    const pugi::xml_node bodies =
        document.document_element().child("Model").child("BodySet").child("objects");
    for (const pugi::xml_node body : bodies.children("Body")) {
      std::vector<double> I = numbers_in(body.child("inertia"));
      if (I.size() != 6 || (I[0] + I[1] >= I[2] && I[0] + I[2] >= I[1] && I[1] + I[2] >= I[0])) continue;
      const double largest = *std::max_element(I.begin(), I.begin() + 3);
      std::ostringstream text;
      text.precision(17);
      for (std::size_t i = 0; i < 6; ++i) text << (i < 3 ? std::max(I[i], largest / 2) : I[i]) << ' ';
      body.child("inertia").text().set(text.str().c_str());
    }
    document.save_file(path().c_str());
  }
  std::string path() const { return file_.path(); }

 private:
  TemporaryFile file_{".osim"};
};

std::vector<fs::path> models() {
  std::vector<fs::path> out;
  for (const fs::path& folder :
       {fs::path(ALEMBERT_SOURCE_DIR) / "tests/osim/models", fs::path(ALEMBERT_OSIM_MODELS)})
    if (fs::exists(folder))
      for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".osim") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

std::string name_of(const testing::TestParamInfo<fs::path>& test) {
  std::string name = test.param.stem().string();
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

std::vector<State> random_states(const Description& description) {
  std::mt19937_64 random(27);
  std::vector<State> out;
  for (int i = 0; i < kModelStates; ++i) out.push_back(random_state(description, random));
  return out;
}

auto ask(const std::string& file, const Description& description, const std::vector<State>& states,
         const std::vector<std::string>& functions) {
  const std::vector<Eigen::VectorXd> tau(states.size(), Eigen::VectorXd::Zero(description.nv));
  return ask_functions(ALEMBERT_EXECUTABLE, file, states, tau, functions);
}

class OsimModels : public testing::TestWithParam<fs::path> {};

TEST_P(OsimModels, HaveTheDynamicsOfSimbody) {
  const Possible model(GetParam());
  const Imported imported(model.path());
  const std::vector<State> states = random_states(imported.description());
  const auto found = ask(imported.path(), imported.description(), states,
                         {"mass_matrix", "bias", "gravity", "applied_forces"});
  OsimSkeleton skeleton(model.path());
  for (std::size_t i = 0; i < states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion(imported.description(), states[i]);
    motion.apply(skeleton);
    const SkeletonDynamics expected = skeleton.dynamics(motion.order);
    const auto near = [](const char* what, const Eigen::MatrixXd& ours, const Eigen::MatrixXd& theirs) {
      EXPECT_LE(relative_error(ours, theirs), kTolerance) << what << ":\n" << ours << "\n for\n" << theirs;
    };
    const Eigen::MatrixXd Q = found[i].at("applied_forces").at("Q");
    near("M", found[i].at("mass_matrix").at("M"), expected.M);
    near("c", found[i].at("bias").at("c") + Q, expected.c);
    near("g", found[i].at("gravity").at("g"), expected.g);
  }
}

/// Every tension 1, and the lengths as outputs.
std::vector<std::string> with_unit_tensions(const std::string& text, const std::string& file) {
  YAML::Node root = YAML::Load(text);
  std::vector<std::string> names;
  YAML::Node forces(YAML::NodeType::Sequence), outputs(YAML::NodeType::Sequence);
  for (YAML::Node force : root["forces"]) {
    if (!force["path"]) continue;
    const auto name = force["name"].as<std::string>();
    force["tension"] = "1";
    forces.push_back(force);
    YAML::Node output;
    output["name"] = "length_" + std::to_string(names.size());
    output["value"] = "length(" + name + ")";
    outputs.push_back(output);
    names.push_back(name);
  }
  // What depends on activations goes with the tensions.
  std::vector<std::string> gone;
  for (const YAML::Node& state : root["states"]) gone.push_back(state["name"].as<std::string>());
  for (const YAML::Node& other : root["forces"])
    if (!other["path"]) gone.push_back(other["name"].as<std::string>());
  YAML::Node definitions;
  for (const auto& definition : root["definitions"]) {
    const auto value = definition.second.as<std::string>(), name = definition.first.as<std::string>();
    const auto is_of = [&](const std::string& of) {
      return value.find(of) != std::string::npos || name.compare(0, of.size(), of) == 0;
    };
    if (std::none_of(gone.begin(), gone.end(), is_of)) definitions[name] = value;
  }
  root.remove("states");
  root.remove("definitions");
  if (definitions.size() > 0) root["definitions"] = definitions;
  root["forces"] = forces;
  root["outputs"] = outputs;
  std::ofstream(file) << YAML::Dump(root);
  return names;
}

TEST_P(OsimModels, HaveTheLengthsAndMomentArmsOfTheirPaths) {
  const Imported imported(GetParam().string());
  const TemporaryFile file(".yaml");
  if (imported.text().find("path:") == std::string::npos) return;
  const std::vector<std::string> names = with_unit_tensions(imported.text(), file.path());
  const Description description = read_description(file.path());
  const std::vector<State> states = random_states(description);
  const auto found = ask(file.path(), description, states, {"force_contributions", "outputs"});
  const Possible model(GetParam());
  OsimSkeleton skeleton(model.path());
  std::vector<pugi::xml_node> paths;
  for (const pugi::xml_node force : acting_forces(skeleton.model()))
    if (force.child("GeometryPath")) paths.push_back(force.child("GeometryPath"));
  if (paths.size() != names.size()) GTEST_SKIP() << "some forces along paths are not taken";
  for (std::size_t i = 0; i < states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion(description, states[i]);
    motion.apply(skeleton);
    const Eigen::MatrixXd contributions = found[i].at("force_contributions").at("Q");
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      EXPECT_NEAR(found[i].at("outputs").at("y")(row), path_length(skeleton, paths[k]), kTolerance)
          << names[k];
      const Eigen::VectorXd arms = -numeric_gradient(
          skeleton, motion, [&](const OsimSkeleton& of) { return path_length(of, paths[k]); });
      EXPECT_LE((contributions.row(row).transpose() - arms).cwiseAbs().maxCoeff(), kArmTolerance)
          << names[k] << ": " << contributions.row(row) << "\n for " << arms.transpose();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, OsimModels, testing::ValuesIn(models()), name_of);

}  // namespace
}  // namespace alembert::oracles
