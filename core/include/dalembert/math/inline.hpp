// For functions and lambdas that are inlined wherever they are called.
#pragma once

#define DALEMBERT_INLINE __attribute__((always_inline))
