// Instruction sets for hot loops.
#pragma once

namespace dalembert {

enum class Instructions { portable, avx2, avx512 };

// The best instruction set of this processor, or less if the environment variable DALEMBERT_INSTRUCTIONS is set at
// the first use. Throws std::invalid_argument for unknown names.
Instructions instructions();

}  // namespace dalembert
