// Spheres on faces of fixed triangles, four at once; the rest are those at edges and corners, and on moving carriers.
#include <algorithm>
#include <cstddef>

#include "dalembert/contact/general_contact.hpp"
#include "dalembert/math/pack.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "meetings.hpp"

namespace dalembert {
namespace {

using P = Pack<4>;
constexpr std::size_t lanes = 4;
// Offsets of the numbers of a facet, which are read four at a time.
constexpr std::size_t normal_of_facet = offsetof(Facet, normal) / sizeof(double),
                      inward_of_facet = offsetof(Facet, inward) / sizeof(double),
                      at_edge_of_facet = offsetof(Facet, at_edge) / sizeof(double);
static_assert(offsetof(Facet, corner) == 0 && normal_of_facet == 3 && inward_of_facet == 6 && at_edge_of_facet == 15 &&
              sizeof(Facet) == 18 * sizeof(double));

DALEMBERT_INLINE inline std::array<P, 4> gather(const std::array<const double*, lanes>& from, std::size_t first = 0) {
  return gather_fours<4>({from[0] + first, from[1] + first, from[2] + first, from[3] + first});
}
DALEMBERT_INLINE inline P smaller(const P& a, const P& b) { return b.x < a.x ? b.x : a.x; }
DALEMBERT_INLINE inline Vec3<P> first_three(const std::array<P, 4>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

// Four spheres over four triangles, and how high they are.
struct GeneralContact::Heights {
  std::array<const double*, lanes> facet;
  Mat3<P> rotation;  // rotation of the carrier
  Vec3<P> centre;    // there
  Vec3<P> normal;
  P height, radius;
  std::array<P, 4> behind_normal;  // its last two components, and the numbers that follow

  DALEMBERT_INLINE Heights(const GeneralContact& contact, const std::array<Chunk::Near, lanes>& pair) {
    std::array<const double*, lanes> at, frame;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto t = static_cast<std::size_t>(pair[lane].triangle);
      facet[lane] = contact.facets_[t].corner.x.data();
      at[lane] = &contact.pairs_.at[static_cast<std::size_t>(pair[lane].sphere)].x;
      frame[lane] =
          contact.carriers_now_[static_cast<std::size_t>(contact.carriers_of_triangles_[t])].position.x.data();
    }
    const std::array<P, 4> s = gather(at), corner = gather(facet);
    behind_normal = gather(facet, normal_of_facet + 1);
    const auto take_frame = [&](const auto& number) DALEMBERT_INLINE {
      for (std::size_t i = 0; i < 9; ++i) rotation.x[i] = number(6 + i);
      centre = transposed_times(rotation, Vec3<P>{s[0] - number(0), s[1] - number(1), s[2] - number(2)});
    };
    const auto of_each = [&](std::size_t i) DALEMBERT_INLINE {
      return P(P::Register{frame[0][i], frame[1][i], frame[2][i], frame[3][i]});
    };
    const auto of_first = [&](std::size_t i) DALEMBERT_INLINE { return P(frame[0][i]); };
    const bool is_one = frame[0] == frame[1] && frame[0] == frame[2] && frame[0] == frame[3];
    is_one ? take_frame(of_first) : take_frame(of_each);
    normal = {corner[3], behind_normal[0], behind_normal[1]};
    height = dot(normal, centre - first_three(corner));
    radius = s[3];
  }
  DALEMBERT_INLINE P within_edges() const {
    const std::array<P, 4> f8 = gather(facet, inward_of_facet + 2), f12 = gather(facet, inward_of_facet + 6),
                           f14 = gather(facet, at_edge_of_facet - 1);
    const P first = dot(Vec3<P>{behind_normal[2], behind_normal[3], f8[0]}, centre) - f14[1],
            second = dot(Vec3<P>{f8[1], f8[2], f8[3]}, centre) - f14[2], third = dot(first_three(f12), centre) - f14[3];
    return smaller(first, smaller(second, third));
  }
};

// Triangles that find_triangles would not leave out by heights over planes and distances from edges, to the last bit.
DALEMBERT_INLINE inline std::size_t GeneralContact::sift(std::size_t begin, std::size_t end, Chunk::Near* left) const {
  std::size_t count = 0;
  for (std::size_t k = begin; k < end; k += lanes) {
    std::array<Chunk::Near, lanes> pair;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t p = std::min(k + lane, end - 1);
      pair[lane] = {near_spheres_[p], near_triangles_[p], false};
    }
    const Heights at(*this, pair);
    const P::Register height = at.height.x, radius = at.radius.x;
    const auto near = (height > 0.0) & (height <= radius);
    if (is_zero(P(near ? 1.0 - P::Register{} : P::Register{}))) continue;
    const P::Register within = at.within_edges().x;
    const auto beside = (within < 0.0) & (within * within + height * height > radius * radius);
    const auto kept = near & ~beside,
               over = (within > 0.0) & (height < radius) & (height >= set_->nearest_relative_distance * radius);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      left[count] = {pair[lane].sphere, pair[lane].triangle, over[lane] != 0};
      count += kept[lane] != 0 && k + lane < end ? 1 : 0;
    }
  }
  return count;
}

// Whether find_triangles would keep, of these triangles of one sphere, those with faces under it, and no other; and they rest.
bool GeneralContact::meets_faces_alone(std::span<const Chunk::Near> all) const {
  const SphereAt& s = pairs_.at[static_cast<std::size_t>(all[0].sphere)];
  const double same = same_point * s.radius;
  for (const Chunk::Near& one : all) {
    const auto t = static_cast<std::size_t>(one.triangle);
    const int carrier = carriers_of_triangles_[t];
    if (carriers_rest_[static_cast<std::size_t>(carrier)] == 0) return false;
    if (all.size() == 1) return one.over_face;
    const Vec3<double> centre = into(carriers_now_[static_cast<std::size_t>(carrier)], {s.x, s.y, s.z});
    const auto under = [&](const Facet& facet) { return centre - facet.height(centre) * facet.normal; };
    const auto any_other = [&](const auto& meets) {
      return std::ranges::any_of(all, [&](const Chunk::Near& other) {
        const auto number = static_cast<std::size_t>(other.triangle);
        return other.over_face && number != t && carriers_of_triangles_[number] == carrier &&
               meets(facets_[number], local_[number]);
      });
    };
    if (one.over_face) {
      const Vec3<double> point = under(facets_[t]);
      if (any_other([&](const Facet& facet, const Triangle&) { return norm(under(facet) - point) <= same; }))
        return false;
      continue;
    }
    const TriangleFeature feature = nearest_feature(local_[t], centre);
    if (feature.is_face()) return false;
    const Vec3<double> point = nearest_point(local_[t], feature, centre);
    if (!any_other([&](const Facet&, const Triangle& corners) {
          return norm(nearest_point(corners, nearest_feature(corners, point), point) - point) <= same;
        }))
      return false;
  }
  return true;
}

// Separates spheres over faces of fixed carriers from all other ones.
void GeneralContact::sift_triangles(Chunk& chunk) const {
  const std::size_t begin = first_triangle_[static_cast<std::size_t>(chunk.begin)],
                    end = first_triangle_[static_cast<std::size_t>(chunk.end)];
  if (chunk.near.size() < end - begin + lanes) {
    chunk.near.resize(end - begin + lanes);
    chunk.on_faces.resize(end - begin + lanes);
  }
  std::size_t count = 0, on_faces = 0, others = 0;
  if (begin < end) in_registers_of_four([&, this] { count = sift(begin, end, chunk.near.data()); });
  const bool grips = set_->bristles.grow();
  for (std::size_t k = 0; k < count;) {
    std::size_t next = k + 1;
    while (next < count && chunk.near[next].sphere == chunk.near[k].sphere) ++next;
    const bool simple = !grips && meets_faces_alone({chunk.near.data() + k, next - k});
    for (; k < next; ++k) {
      const Chunk::Near pair = chunk.near[k];
      chunk.on_faces[on_faces] = pair;
      on_faces += simple && pair.over_face ? 1 : 0;
      chunk.near[others] = pair;
      others += simple ? 0 : 1;
    }
  }
  chunk.others = others;
  chunk.faces = on_faces;
}

// Same as in add_on_triangles.
template <bool rubs>
DALEMBERT_INLINE inline void GeneralContact::push_from_faces(std::span<const Chunk::Near> all) const {
  for (std::size_t k = 0; k < all.size(); k += lanes) {
    std::array<Chunk::Near, lanes> pair;
    std::array<const double*, lanes> velocities, spins;
    std::array<ContactPairing, lanes> pairings;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      pair[lane] = all[std::min(k + lane, all.size() - 1)];
      const auto i = static_cast<std::size_t>(pair[lane].sphere);
      velocities[lane] = &pairs_.velocity[i].x;
      if constexpr (rubs) spins[lane] = &pairs_.spin[i].x;
      pairings[lane] = pairs_.pairing_with(*set_, pair[lane].sphere,
                                           carriers_of_triangles_[static_cast<std::size_t>(pair[lane].triangle)]);
    }
    const ContactPairingOf<P> pairing = side_by_side(pairings);
    const int count = static_cast<int>(std::min(lanes, all.size() - k));
    const Heights at(*this, pair);
    const Vec3<P> normal = -(at.rotation * at.normal);
    Vec3<P> velocity = -first_three(gather(velocities));
    if constexpr (rubs) velocity -= cross(first_three(gather(spins)), at.height * normal);
    const P away = dot(normal, velocity);
    P normal_force = pairing.normal_force(at.height - at.radius, away);
    normal_force = P(normal_force.x > 0.0 ? normal_force.x : P::Register{});
    Vec3<P> force = (-normal_force) * normal;
    if constexpr (rubs) {
      const Vec3<P> friction = pairing.friction_force(normal_force, velocity - away * normal, set_->proportional_zone),
                    moment = at.height * cross(normal, friction);
      force = force + friction;
      each_row<4>({moment[0], moment[1], moment[2], P()}, count, [&](int lane, const P& row) DALEMBERT_INLINE {
        row.add_to(&pairs_.moment[static_cast<std::size_t>(pair[static_cast<std::size_t>(lane)].sphere)].x);
      });
    }
    each_row<4>({force[0], force[1], force[2], P()}, count, [&](int lane, const P& row) DALEMBERT_INLINE {
      row.add_to(&pairs_.force[static_cast<std::size_t>(pair[static_cast<std::size_t>(lane)].sphere)].x);
    });
  }
}

void GeneralContact::add_on_triangles(const Ports& ports, bool rubs, Chunk& chunk) const {
  chunk.on_carriers.clear();
  sift_triangles(chunk);
  const std::span<const Chunk::Near> faces(chunk.on_faces.data(), chunk.faces);
  if (!faces.empty())
    in_registers_of_four([faces, rubs, this] { rubs ? push_from_faces<true>(faces) : push_from_faces<false>(faces); });
  for (std::size_t k = 0; k < chunk.others;) {
    const int sphere = chunk.near[k].sphere;
    chunk.of_sphere.clear();
    for (; k < chunk.others && chunk.near[k].sphere == sphere; ++k) chunk.of_sphere.push_back(chunk.near[k].triangle);
    add_on_triangles(sphere, ports, rubs, chunk);
  }
}

}  // namespace dalembert
