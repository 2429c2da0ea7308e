// N numbers of a column, in as many registers of `Width` numbers as that takes.
#pragma once

#include "dalembert/math/pack.hpp"

namespace dalembert {

template <int N, int Width>
struct Packs {
  using Part = typename Pack<Width>::Register;  // bare: arrays of packs would not stay in registers
  using Mask = typename Pack<Width>::Mask;
  static constexpr int count = N / Width;
  Part part[count];

  DALEMBERT_INLINE double operator[](int i) const { return part[i / Width][i % Width]; }
  DALEMBERT_INLINE static Packs load(const double* from) {
    Packs x;
    for (int k = 0; k < count; ++k) x.part[k] = Pack<Width>::load(from + k * Width).x;
    return x;
  }
  DALEMBERT_INLINE void store(double* to) const {
    for (int k = 0; k < count; ++k) Pack<Width>(part[k]).store(to + k * Width);
  }
  DALEMBERT_INLINE Packs operator+(const Packs& y) const {
    Packs z;
    for (int k = 0; k < count; ++k) z.part[k] = part[k] + y.part[k];
    return z;
  }
  DALEMBERT_INLINE void multiply(double y) {
    for (int k = 0; k < count; ++k) part[k] *= y;
  }
  DALEMBERT_INLINE void multiply(const Packs& y) {
    for (int k = 0; k < count; ++k) part[k] *= y.part[k];
  }
  template <class Factor>  // a register or a number
  DALEMBERT_INLINE void add_product(const Packs& x, const Factor& y) {
    for (int k = 0; k < count; ++k) part[k] += x.part[k] * y;
  }
  // Entries of the product from `begin` to before `end` may differ from zero.
  template <class Factor>
  DALEMBERT_INLINE void subtract_product(const Packs& x, const Factor& y, int begin = 0, int end = N) {
    for (int k = 0; k < count; ++k)
      if (k * Width < end && (k + 1) * Width > begin) part[k] -= x.part[k] * y;
  }
  // Entry i in all places.
  DALEMBERT_INLINE Part spread(int i) const {
    Mask from{};
    for (int k = 0; k < Width; ++k) from[k] = i % Width;
#ifdef __clang__  // it has shuffles by constants only, and finds this one by itself
    Part all;
    for (int k = 0; k < Width; ++k) all[k] = part[i / Width][from[k]];
    return all;
#else
    return __builtin_shuffle(part[i / Width], from);
#endif
  }
  // Entries from `begin` to before `end`, those of `others` elsewhere.
  DALEMBERT_INLINE Packs only(int begin, int end, const Packs& others = {}) const {
    Packs z;
    for (int k = 0; k < count; ++k) {
      Mask place{};
      for (int i = 0; i < Width; ++i) place[i] = k * Width + i;
      z.part[k] = ((place >= begin) & (place < end)) ? part[k] : others.part[k];
    }
    return z;
  }
  DALEMBERT_INLINE static Packs unit(int i) {
    Packs z = {};
    z.part[i / Width][i % Width] = 1;
    return z;
  }
  DALEMBERT_INLINE friend Packs magnitude(const Packs& x) {
    Packs z;
    for (int k = 0; k < count; ++k) z.part[k] = x.part[k] < 0 ? -x.part[k] : x.part[k];
    return z;
  }
  DALEMBERT_INLINE friend Packs larger(const Packs& x, const Packs& y) {
    Packs z;
    for (int k = 0; k < count; ++k) z.part[k] = x.part[k] > y.part[k] ? x.part[k] : y.part[k];
    return z;
  }
};

}  // namespace dalembert
