// Attribute for functions and lambdas that are always inlined. [[gnu::flatten]] inlines all calls within a function.
#pragma once

#define DALEMBERT_INLINE __attribute__((always_inline))
