// Forces of spheres that are near each other, four pairs at once, or eight. Spheres come in chunks; what acts on a sphere of a later chunk waits
// in a place of its own until that chunk takes it, so that chunks may be computed side by side, and sums have one order.
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
  LargeVector<Four> force, moment;     // by place: those of all spheres, and behind them those of what waits

  // Room for the spheres of a set, and their surfaces.
  void take(const ContactSet& set);
  // Of a sphere with what carries triangles.
  ContactPairing pairing_with(const ContactSet& set, int sphere, int carrier) const {
    const auto i = static_cast<std::size_t>(sphere), c = static_cast<std::size_t>(carrier);
    if (with_carriers_.empty()) return set.pairing(set.spheres[i].surface, set.carriers[c].surface);
    return with_carriers_[static_cast<std::size_t>(kinds_[i]) * set.carriers.size() + c];
  }
  // Pairs to look at from now on; chunk c has spheres from begins[c] to begins[c + 1].
  void list(const SphereNeighbours& neighbours, std::span<const int> begins, Workers* workers);
  // Before moments are computed, since the last list: without friction there are none.
  void make_room_for_moments() { moment.resize(force.size()); }
  // What friction does: nothing, what is computed here, or what others add.
  enum class Friction { none, of_slip, of_others };
  // Sets forces and moments of the spheres of a chunk to those of its pairs, and tells the square of the smallest distance of centres.
  double compute(int chunk, const ContactSet& set, Friction friction);
  // Of the pairs of a chunk, in the order of its neighbours: which the first one is, and where what acts on the second sphere goes.
  std::size_t first_pair(int chunk) const { return first_pair_[static_cast<std::size_t>(chunk)]; }
  std::size_t place_of_second(std::size_t pair) const;
  // Adds what other chunks have left.
  void collect(int chunk, bool rubs);

 private:
  template <int L, bool rubs, bool alike>
  double compute_pairs(std::size_t begin, std::size_t end, const ContactSet& set);
  ContactPairing pairing_of(const ContactSet& set, std::uint32_t first, std::uint32_t second) const;  // by where they begin in numbers
  void list_collected();

  std::size_t count_ = 0;
  std::vector<int> kinds_;               // of surfaces, by sphere
  std::vector<ContactSurface> surfaces_; // by kind
  std::vector<ContactPairing> pairings_, with_carriers_; // of kinds with kinds and with carriers; empty where there are too many
  std::vector<int> begins_;  // of chunks
  LargeVector<std::uint32_t> firsts_, seconds_, targets_;  // by pair; targets: where the force on the second one goes
  std::vector<std::size_t> first_pair_, first_waiting_, first_collected_;  // by chunk
  struct Waiting {
    int sphere, place;
  };
  LargeVector<int> waiting_;        // spheres, by place behind those of all spheres
  LargeVector<Waiting> collected_;  // by the chunk of the sphere
};

}  // namespace dalembert
