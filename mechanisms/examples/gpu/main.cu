// Ten seconds of 4,096 pendulums with payloads of their own: on a GPU if the program is compiled for one and finds it, else on
// the processor, by the same functions. Which payload swings least in the end?
#include <cmath>
#include <cstdio>
#include <cuda/pendulum.cuh>
#include <vector>

namespace pendulum = alembert::mechanisms::pendulum::cuda;
constexpr std::size_t kCount = 4096;

int main() {
  std::vector<float> q(pendulum::kNq * kCount), qd(pendulum::kNv * kCount, 0.0f), payload(kCount);
  for (std::size_t s = 0; s < kCount; ++s) {
    q[s] = 1.5f;            // the shoulder of pendulum s
    q[kCount + s] = -0.5f;  // its elbow
    payload[s] = 2.0f * static_cast<float>(s) / kCount;
  }
  pendulum::BatchInputs<float> in;
  in.parameters_vary = true;
  pendulum::Rollout<float> way;
  way.steps = 10000;
  way.h = 1e-3f;
  bool on_gpu = false;
#ifdef __CUDACC__
  int devices = 0;
  if (cudaGetDeviceCount(&devices) == cudaSuccess && devices > 0) {
    float *to_q, *to_qd, *to_payload;
    const std::size_t bytes = kCount * sizeof(float);
    if (cudaMalloc(&to_q, 2 * bytes) || cudaMalloc(&to_qd, 2 * bytes) || cudaMalloc(&to_payload, bytes))
      return 1;
    cudaMemcpy(to_q, q.data(), 2 * bytes, cudaMemcpyHostToDevice);
    cudaMemcpy(to_qd, qd.data(), 2 * bytes, cudaMemcpyHostToDevice);
    cudaMemcpy(to_payload, payload.data(), bytes, cudaMemcpyHostToDevice);
    in.parameters = to_payload;
    if (pendulum::rollout_batch(kCount, kCount, to_q, to_qd, in, way) || cudaDeviceSynchronize()) return 1;
    cudaMemcpy(q.data(), to_q, 2 * bytes, cudaMemcpyDeviceToHost);
    cudaMemcpy(qd.data(), to_qd, 2 * bytes, cudaMemcpyDeviceToHost);
    on_gpu = true;
  }
#endif
  if (!on_gpu) {
    in.parameters = payload.data();
    for (std::size_t s = 0; s < kCount; ++s) pendulum::rollout(s, kCount, q.data(), qd.data(), in, way);
  }
  std::size_t calmest = 0;
  const auto speed = [&](std::size_t s) { return std::hypot(qd[s], qd[kCount + s]); };
  for (std::size_t s = 0; s < kCount; ++s)
    if (speed(s) < speed(calmest)) calmest = s;
  std::printf("%s: a payload of %.3f kg ends at %.4f rad/s\n", on_gpu ? "GPU" : "processor",
              static_cast<double>(payload[calmest]), static_cast<double>(speed(calmest)));
  return speed(calmest) < 0.5f && std::isfinite(speed(0)) ? 0 : 1;
}
