// Instruction sets for hot loops.
#pragma once

namespace dalembert {

enum class Instructions { portable, avx2, avx512 };

// The most that this processor has, or less if the environment variable DALEMBERT_INSTRUCTIONS says so when they are
// needed first. Throws std::invalid_argument if it names anything else.
Instructions instructions();

}  // namespace dalembert
