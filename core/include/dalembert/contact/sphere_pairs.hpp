// Forces of neighbouring spheres, four or eight pairs at once. Spheres are divided into chunks. Forces on a sphere of
// a later chunk are stored separately until that chunk collects them. So chunks may be computed side by side, and
// sums have one order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dalembert/contact/contact_set.hpp"
#include "dalembert/contact/sphere_neighbours.hpp"
#include "dalembert/math/aligned_vector.hpp"
#include "dalembert/math/large_memory.hpp"

namespace dalembert {

class SpherePairs {
 public:
  struct alignas(32) Four {
    double x, y, z, w;
    Vec3<double> vector() const { return {x, y, z}; }
    void add(const Vec3<double>& v) {
      x += v[0];
      y += v[1];
      z += v[2];
    }
  };
  AlignedVector<SphereAt> at;
  AlignedVector<Four> velocity, spin;  // by sphere
  LargeVector<Four> force, moment;  // by address: all spheres, followed by the stored forces

  // Room for the spheres of a set, and their surfaces.
  void take(const ContactSet& set);
  // Pairing of a sphere with a carrier of triangles.
  ContactPairing pairing_with(const ContactSet& set, int sphere, int carrier) const {
    const auto i = static_cast<std::size_t>(sphere), c = static_cast<std::size_t>(carrier);
    if (with_carriers_.empty()) return set.pairing(set.spheres[i].surface, set.carriers[c].surface);
    return with_carriers_[static_cast<std::size_t>(kinds_[i]) * set.carriers.size() + c];
  }
  // Pairs to look at from now on; chunk c has spheres from begins[c] to begins[c + 1].
  void list(const SphereNeighbours& neighbours, std::span<const int> begins, Workers* workers);
  // Call before moments are computed, since the last list: without friction there are none.
  void make_room_for_moments() { moment.resize(force.size()); }
  // Friction: none, computed here, or added by other code.
  enum class Friction { none, of_slip, of_others };
  // Computes forces and moments of the spheres of a chunk, and returns the square of the smallest distance of
  // centers.
  double compute(int chunk, const ContactSet& set, Friction friction);
  // Pairs of a chunk, in the order of its neighbours: the first pair, and the address of the force on the second
  // sphere.
  std::size_t first_pair(int chunk) const { return first_pair_[static_cast<std::size_t>(chunk)]; }
  std::size_t place_of_second(std::size_t pair) const;
  // Adds the forces that other chunks have stored.
  void collect(int chunk, bool rubs);

 private:
  template <int L, bool rubs, bool alike>
  double compute_pairs(std::size_t begin, std::size_t end, const ContactSet& set);
  // arguments: offsets in numbers
  ContactPairing pairing_of(const ContactSet& set, std::uint32_t first, std::uint32_t second) const;
  void list_collected();

  std::size_t count_ = 0;
  std::vector<int> kinds_;  // kinds of surfaces, by sphere
  std::vector<ContactSurface> surfaces_; // by kind
  // pairings of kinds with kinds and with carriers; empty if there are too many
  std::vector<ContactPairing> pairings_, with_carriers_;
  std::vector<int> begins_;  // of chunks
  // by pair; targets: address of the force on the second sphere
  LargeVector<std::uint32_t> firsts_, seconds_, targets_;
  std::vector<std::size_t> first_pair_, first_waiting_, first_collected_;  // by chunk
  struct Waiting {
    int sphere, place;
  };
  LargeVector<int> waiting_;        // spheres, by place behind those of all spheres
  LargeVector<Waiting> collected_;  // by the chunk of the sphere
};

}  // namespace dalembert
