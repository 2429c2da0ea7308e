#include "dalembert/math/processor.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace dalembert {

namespace {

Instructions of_processor() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return Instructions::portable;
  const bool wider =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
  return wider ? Instructions::avx512 : Instructions::avx2;
#else
  return Instructions::portable;
#endif
}

Instructions allowed() {
  const char* given = std::getenv("DALEMBERT_INSTRUCTIONS");
  const std::string name = given == nullptr ? "" : given;
  if (name.empty() || name == "avx512") return Instructions::avx512;
  if (name == "avx2") return Instructions::avx2;
  if (name == "portable") return Instructions::portable;
  throw std::invalid_argument("environment variable DALEMBERT_INSTRUCTIONS: received '" + name +
                              "'; expected portable, avx2 or avx512");
}

}  // namespace

Instructions instructions() {
  static const Instructions chosen = std::min(of_processor(), allowed());
  return chosen;
}

}  // namespace dalembert
