// Several systems in one scene (Fig. 5f of Guenter and Lee, "Symbolic Lagrangian multibody dynamics"): each
// is a generated library of its own, all move in lockstep by one frame of 1/60 s. In: optionally, the number
// of seconds. Out: a line for each system.
#include <alembert/integrate.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <knee/knee.hpp>
#include <memory>
#include <rolling_wheels_bowl/rolling_wheels_bowl.hpp>
#include <string>
#include <tong/tong.hpp>
#include <torus_chain_14/torus_chain_14.hpp>
#include <train/train.hpp>
#include <vector>

namespace {

namespace mechanisms = alembert::mechanisms;

/// One system of the scene, whatever its mechanism.
class System {
 public:
  explicit System(std::string system) : name(std::move(system)) {}
  virtual ~System() = default;
  virtual alembert::Status step(double h) = 0;
  virtual double kinetic_energy() const = 0;
  virtual double energy() const = 0;
  virtual std::size_t bodies() const = 0;
  virtual int coordinates() const = 0;
  /// Far from where a body was before, or not finite, it has left the scene.
  virtual double farthest_body() const = 0;

  const std::string name;
};

template <class M>
class SystemOf final : public System {
 public:
  using System::System;

  alembert::Status step(double h) override {
    const auto free = [](double, const auto&, const auto&) ->
        typename M::SpeedVector { return M::SpeedVector::Zero(); };
    return alembert::rk4_step<M>(q_, u_, in_, h, free);
  }
  double kinetic_energy() const override { return M::energy(q_, u_, in_)[0]; }
  double energy() const override { return M::energy(q_, u_, in_).sum(); }
  std::size_t bodies() const override { return M::body_poses(q_, in_).size(); }
  int coordinates() const override { return M::kNq; }
  double farthest_body() const override {
    double farthest = 0;
    for (const auto& pose : M::body_poses(q_, in_)) farthest = std::fmax(farthest, pose.col(3).norm());
    return farthest;
  }

 private:
  typename M::CoordinateVector q_ = M::initial_coordinates();
  typename M::SpeedVector u_ = M::SpeedVector::Zero();
  typename M::Inputs in_{};
};

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 20;
  constexpr double kFrame = 1.0 / 60, kLargestDrift = 0.1, kScene = 20;
  std::vector<std::unique_ptr<System>> systems;
  systems.push_back(std::make_unique<SystemOf<mechanisms::train::Mechanism<double>>>("train"));
  systems.push_back(std::make_unique<SystemOf<mechanisms::torus_chain_14::Mechanism<double>>>("torus chain"));
  systems.push_back(std::make_unique<SystemOf<mechanisms::rolling_wheels_bowl::Mechanism<double>>>("wheels"));
  systems.push_back(std::make_unique<SystemOf<mechanisms::tong::Mechanism<double>>>("tong"));
  systems.push_back(std::make_unique<SystemOf<mechanisms::knee::Mechanism<double>>>("knee"));

  struct Record {
    double start = 0, kinetic = 0, drift = 0, farthest = 0, microseconds = 0;
  };
  std::vector<Record> records(systems.size());
  for (std::size_t i = 0; i < systems.size(); ++i) records[i].start = systems[i]->energy();
  const long frames = std::lround(seconds / kFrame);
  for (long frame = 1; frame <= frames; ++frame) {
    for (std::size_t i = 0; i < systems.size(); ++i) {
      const auto before = std::chrono::steady_clock::now();
      const alembert::Status status = systems[i]->step(kFrame);
      const auto after = std::chrono::steady_clock::now();
      if (status != alembert::Status::ok) {
        std::printf("FAILURE: %s stops at t = %.3f s: %s\n", systems[i]->name.c_str(),
                    static_cast<double>(frame - 1) * kFrame, alembert::to_string(status));
        return 1;
      }
      Record& record = records[i];
      record.microseconds += std::chrono::duration<double, std::micro>(after - before).count();
      record.kinetic = std::fmax(record.kinetic, systems[i]->kinetic_energy());
      record.drift = std::fmax(record.drift, std::abs(systems[i]->energy() - record.start));
      record.farthest = std::fmax(record.farthest, systems[i]->farthest_body());
    }
  }
  std::printf("%-12s %11s %6s %17s %13s %12s\n", "system", "coordinates", "bodies", "energy drift",
              "farthest", "time a step");
  bool good = frames > 0;
  for (std::size_t i = 0; i < systems.size(); ++i) {
    const Record& record = records[i];
    std::printf("%-12s %11d %6zu %8.1e of %.3g J %11.2f m %9.1f us\n", systems[i]->name.c_str(),
                systems[i]->coordinates(), systems[i]->bodies(), record.drift / record.kinetic,
                record.kinetic, record.farthest, record.microseconds / static_cast<double>(frames));
    good = good && record.kinetic > 0 && record.drift <= kLargestDrift * record.kinetic &&
           record.farthest < kScene;
  }
  std::printf("%s: %zu systems, %ld frames of 1/60 s\n", good ? "success" : "FAILURE", systems.size(),
              frames);
  return good ? 0 : 1;
}
