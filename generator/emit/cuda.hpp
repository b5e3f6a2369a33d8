// CUDA: functions of host and device, and kernels over batches. In: functions as statements of C++ over a scalar type S.
// Out: text of one header, which compilers without CUDA read too.
#pragma once

#include <span>
#include <string>

#include "emit/c99.hpp"
#include "emit/text_template.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// NAME.cuh.
std::string cuda_header(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                        const Slots& common);

}  // namespace alembert
