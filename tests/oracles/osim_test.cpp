// `alembert import` of models of OpenSim against Simbody: the same file through both, M, c and g at random states.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "oracles/alembert_process.hpp"
#include "oracles/engines/silence.hpp"
#include "oracles/osim/skeleton.hpp"
#include "oracles/state.hpp"

namespace alembert::oracles {
namespace {

namespace fs = std::filesystem;

constexpr double kTolerance = 1e-9;
constexpr int kStates = 6;

/// The model with inertias that bodies can have, in a file of its own: Simbody refuses others.
class Possible {
 public:
  explicit Possible(const fs::path& file)
      : path_(fs::temp_directory_path() / ("alembert_" + std::to_string(getpid()) + ".osim")) {
    pugi::xml_document document;
    if (!document.load_file(file.c_str())) throw std::runtime_error("no XML: " + file.string());
    const pugi::xml_node bodies = document.document_element().child("Model").child("BodySet").child("objects");
    for (const pugi::xml_node body : bodies.children("Body")) {
      std::vector<double> I = numbers_in(body.child("inertia"));
      if (I.size() != 6 || (I[0] + I[1] >= I[2] && I[0] + I[2] >= I[1] && I[1] + I[2] >= I[0])) continue;
      const double largest = *std::max_element(I.begin(), I.begin() + 3);
      std::ostringstream text;
      text.precision(17);
      for (std::size_t i = 0; i < 6; ++i) text << (i < 3 ? std::max(I[i], largest / 2) : I[i]) << ' ';
      body.child("inertia").text().set(text.str().c_str());
    }
    document.save_file(path_.c_str());
  }
  ~Possible() { fs::remove(path_); }
  Possible(const Possible&) = delete;
  Possible& operator=(const Possible&) = delete;
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

/// The description that a model becomes, in a file of its own.
class Imported {
 public:
  explicit Imported(const std::string& file)
      : path_(fs::temp_directory_path() / ("alembert_osim_" + std::to_string(getpid()) + ".yaml")) {
    const Run run = run_alembert(ALEMBERT_EXECUTABLE, {"import", file, "--out", path_.string()}, "");
    if (run.status != 0) throw std::runtime_error(run.err);
    said_ = run.err;
    description_ = read_description(path_.string());
  }
  ~Imported() { fs::remove(path_); }
  Imported(const Imported&) = delete;
  Imported& operator=(const Imported&) = delete;
  std::string path() const { return path_.string(); }
  const Description& description() const { return description_; }
  const std::string& said() const { return said_; }

 private:
  fs::path path_;
  std::string said_;
  Description description_;
};

std::vector<fs::path> models() {
  std::vector<fs::path> out;
  for (const fs::path& folder :
       {fs::path(ALEMBERT_SOURCE_DIR) / "tests/oracles/osim", fs::path(ALEMBERT_OSIM_MODELS)})
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

struct Motion {
  std::map<std::string, double> q, u;
  std::vector<std::string> order;
};

Motion motion_of(const Description& description, const State& state) {
  Motion out;
  for (const Coordinate& c : description.coordinates) {
    out.q[c.name] = state.q[static_cast<std::size_t>(c.first_q)];
    out.u[c.name] = state.speeds[static_cast<std::size_t>(c.first_speed)];
    out.order.push_back(c.name);
  }
  return out;
}

class OsimModels : public testing::TestWithParam<fs::path> {};

TEST_P(OsimModels, HaveTheDynamicsOfSimbody) {
  const Possible model(GetParam());
  const Imported imported(model.path());
  std::mt19937_64 random(27);
  std::vector<State> states;
  std::vector<Eigen::VectorXd> tau;
  for (int i = 0; i < kStates; ++i) {
    states.push_back(random_state(imported.description(), random));
    tau.emplace_back(Eigen::VectorXd::Zero(imported.description().nv));
  }
  const auto found = ask_functions(ALEMBERT_EXECUTABLE, imported.path(), states, tau,
                                   {"mass_matrix", "bias", "gravity", "applied_forces"});
  OsimSkeleton skeleton(model.path());
  for (std::size_t i = 0; i < states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const Motion motion = motion_of(imported.description(), states[i]);
    skeleton.set(motion.q, motion.u, states[i].time);
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

INSTANTIATE_TEST_SUITE_P(All, OsimModels, testing::ValuesIn(models()), name_of);

}  // namespace
}  // namespace alembert::oracles
