// For functions and lambdas that are inlined wherever they are called. What inlines all that it calls is [[gnu::flatten]].
#pragma once

#define DALEMBERT_INLINE __attribute__((always_inline))
