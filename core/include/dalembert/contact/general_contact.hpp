// Contact of everything in a ContactSet with everything else there: spheres, convex shapes, triangles, planes, and cables with spheres.
//
//   list    pairs that are near each other: good until something has moved farther than the skin
//   touch   pairs that overlap now and push: found from the list
//   hold    what touched at the last search: the contacts of an implicit step, whose entries have slots
//   grow    bristles of what touches, at the end of a step: the next one reads them
//
// Explicit integration asks for the forces of what touches; implicit solvers hold what touches during Newton's method, and iterate if
// something has begun or ended to touch.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "dalembert/contact/box_tree.hpp"
#include "dalembert/contact/bristle.hpp"
#include "dalembert/contact/contact_set.hpp"
#include "dalembert/contact/convex_scene.hpp"
#include "dalembert/contact/facet.hpp"
#include "dalembert/contact/planar_cable.hpp"
#include "dalembert/contact/sphere_neighbours.hpp"
#include "dalembert/contact/sphere_pairs.hpp"
#include "dalembert/system/system_term.hpp"
#include "dalembert/system/workers.hpp"

namespace dalembert {

struct HeldContact {
  int sphere = -1, other = -1;  // global number of a sphere with a larger number, of a cable, or of a triangle
  bool sticks = true;  // the slip was in the proportional zone
  Stretch1D along = {};  // position of a cable interval in the circle
  int bristle = -1;  // the number that its bristle has been known by
};

// The first hit of a line.
struct LineHit {
  double distance = 0, velocity = 0;  // distance from the start, and velocity of the surface along the line
  int sphere = -1, cable = -1, triangle = -1, convex = -1, plane = -1;  // -1: not hit
};
struct Line {
  Vec3<double> start, direction;  // unit vector
  double nearest = 0, farthest = 0;
  double radius = 0;  // radius of a cylinder around the line, for spheres
  bool spheres = true, cables = true, triangles = true, convex = true, planes = true;
};

class GeneralContact final : public SystemTerm {
 public:
  GeneralContact(std::shared_ptr<const ContactSet> set, const Ports& ports, std::string name);

  std::span<const int> markers() const override { return markers_; }
  bool direct() const override { return true; }
  void use_workers(Workers* workers) override { workers_ = workers; }
  void enter(const System& system, const Model& model) override;
  void find_nodes(const System& system) override;
  bool reads_nodes() const override;
  bool needs_port(std::size_t marker) const override { return marker >= at_nodes_.size() || at_nodes_[marker].dof < 0; }
  bool search(const Evaluation& evaluation, const Ports& ports) override;
  void visit(BlockVisitor& visitor, const Ports& ports) const override;
  void residual(const Evaluation& evaluation, Ports& ports, double* r) const override;
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override;
  PostNewton post_newton(const Evaluation& evaluation, const Ports& ports, const double* start, double* data,
                         double* lambda) override;
  bool has_history() const override { return true; }
  // Two for each sphere and each convex shape: how many push, and how many of these stick, must not change.
  bool has_switches() const override { return true; }
  void find_switches(const Evaluation& evaluation, const Ports& ports, Switches& switches) const override;
  std::string name_of_part(int part) const override;
  void switch_over(const Evaluation& evaluation, const Ports& ports, const double* before, double* data,
                   double* lambda) override;
  void forget_switches() override { verges_before_.clear(); }
  bool forget() override;
  bool has_history_of_steps() const override { return set_->bristles.grow(); }
  void keep() override;
  void restore() override { grown_ = false; }
  void begin_history(const Ports& ports) override;
  void write_history(std::vector<double>& numbers) const override;
  bool take_history(std::span<const double>& numbers) override;

  // ---- queries, by frames in the ports ------------------------------------------------------------------------------
  // Contacts at the last search, Newton iteration or `update`.
  const std::vector<HeldContact>& touching() const { return touching_; }
  void update(const Ports& ports);
  // `number` identifies the contents of the ports: search data is reused while it is unchanged; 0: for this line
  // alone.
  LineHit first_hit(const Line& line, const Ports& ports, std::uint64_t number) const;
  struct Items {
    std::vector<int> spheres, cables, triangles, convex;
  };
  Items items_in(const Box& box, const Ports& ports) const;
  RigidFrame<double> frame_of(int marker, const Ports& ports) const;
  // Active contacts for pictures: a sphere, the other entity, a point, and the force on the sphere. The lists of this
  // term are updated to the given configuration: call it for a term that no solver uses.
  struct Push {
    int sphere, other;
    Vec3<double> point, force;
  };
  std::vector<Push> pushes(const Ports& ports, ConfigurationType configuration);
  // Active contact points of convex shapes and planes.
  struct ConvexPlace {
    int first, second;  // global numbers; triangles use the number of the first triangle of their body
    Vec3<double> point, normal, force;  // normal from the first to the second; force on the first
    double gap, share;
  };
  std::vector<ConvexPlace> convex_places(const Ports& ports);
  // Pairs that touched at the last search.
  struct ConvexPair {
    int first, second;
    bool sticks;
  };
  std::vector<ConvexPair> convex_pairs() const;
  // Copies the bristles of another term of the same contacts.
  void take_bristles_of(const GeneralContact& other) {
    bristles_ = other.bristles_;
    convex_bristles_ = other.convex_bristles_;
  }

 private:
  // Contact geometry of a sphere and another entity.
  template <class S>
  using Meeting = ContactMeeting<S>;
  // Blocks of the tangent: a sphere with another, or with the carrier of triangles.
  struct Block {
    enum class With { sphere, cable, carrier };
    int sphere = -1, marker1 = -1;  // no marker: a cable
    With with = With::sphere;
    int number = -1;  // number of the other sphere, of the cable or of the carrier
    std::size_t first_slot = 0;
    auto key() const { return std::tuple(sphere, with, number); }
  };

  // Margins of a sphere with respect to neighbours with larger numbers: the number of active and sticking contacts,
  // and the distance to the next change.
  struct Verge {
    int touching = 0, sticking = 0;
    double open = std::numeric_limits<double>::infinity(), closed = open, slip = open;  // N, N, m/s or, of bristles, N
    void add(double margin);  // negative: it pushes
    void add_slip(double excess);
    double contact(const Verge& before) const;  // negative: other numbers than before
    double friction(const Verge& before) const;
  };
  void add_verge(const HeldContact& contact, const Ports& ports, Verge& verge) const;
  void add_open_triangles(int sphere, Verge& verge) const;
  void add_cables(const Ports& ports, std::vector<Verge>& verges) const;
  void find_verges(const Evaluation& evaluation, const Ports& ports, std::vector<Verge>& verges) const;

  int spheres() const { return static_cast<int>(set_->spheres.size()); }
  const ContactSphere& sphere(int i) const { return set_->spheres[static_cast<std::size_t>(i)]; }
  const ContactTriangle& triangle(int i) const { return set_->triangles[static_cast<std::size_t>(i)]; }
  const ContactCarrier& carrier(int i) const { return set_->carriers[static_cast<std::size_t>(i)]; }
  bool turns(int sphere) const { return turns_[static_cast<std::size_t>(sphere)] != 0; }

  struct Found {
    int triangle = -1, rank = 0;  // 0: face, 1: edge, 2: corner
    // in the frame of the carrier; the normal points from the center of the sphere to the point
    Vec3<double> point, normal;
    double distance = 0;
    int bristle = -1;  // the number that its bristle has been known by
  };
  // Consecutive spheres: threads share chunks, which depend only on the number of spheres, as does the order of sums.
  struct Chunk {
    int begin = 0, end = 0;
    double moved = 0;  // upper bound of the displacement of its spheres since the lists were made
    std::vector<int> at_triangles;  // spheres that are near some
    std::vector<int> near_triangles;  // candidate triangles of its spheres, one after the other,
    std::vector<std::size_t> ends;  // up to here
    std::size_t first_near = 0;  // start of these among those of all chunks
    struct OnCarrier {
      int marker;
      Vec3<double> force, moment;
    };
    std::vector<OnCarrier> on_carriers;
    struct Near {
      int sphere, triangle;
      bool over_face;
    };
    std::vector<Near> near, on_faces;  // candidates for penetration; on_faces: those over faces of fixed carriers,
    std::size_t others = 0, faces = 0;  // numbers of both
    std::vector<int> of_sphere;
    std::vector<Found> found, kept;
    std::vector<BristleList::Entry> grown;
  };
  template <class F>
  void each_chunk(const F& f) const;

  // With `nodes`, the positions of spheres at nodes are read from the nodes.
  void take_places(const Ports& ports, const Evaluation* nodes = nullptr) const;
  void follow(const Ports& ports, const Evaluation* nodes = nullptr) const;
  void renew_lists() const;
  void list_triangles(Chunk& chunk) const;
  void join_triangle_lists() const;
  void find_near_triangles(int first_sphere, int count, std::vector<int>* of_each) const;
  void renew_shapes() const;
  double moved() const;
  double moved_by_spheres() const;
  bool overlap(int sphere, int other) const;
  [[noreturn]] void refuse_same_centre(int sphere, int other) const;
  std::span<const int> triangles_near(int sphere) const {
    const std::size_t first = first_triangle_[static_cast<std::size_t>(sphere)];
    return {near_triangles_.data() + first, first_triangle_[static_cast<std::size_t>(sphere) + 1] - first};
  }
  // The triangles of a chunk that find_triangles cannot do without, and those that can do without it.
  struct Heights;
  void sift_triangles(Chunk& chunk) const;
  bool meets_faces_alone(std::span<const Chunk::Near> all) const;
  std::size_t sift(std::size_t begin, std::size_t end, Chunk::Near* left) const;
  template <bool rubs>
  void push_from_faces(std::span<const Chunk::Near> all) const;
  void find_triangles(int sphere, std::span<const int> near, Chunk& chunk) const;
  void touching_triangles(int sphere, std::span<const int> near, Chunk& chunk) const;
  template <class F>
  void each_touch(Chunk& chunk, F&& f) const;

  template <class S>
  Meeting<S> meet_sphere(int sphere, int other, const Vec3<S>& p0, const Vec3<S>& p1) const;
  template <class S>
  Meeting<S> meet_triangle(int sphere, int triangle, const Vec3<S>& p0, const RigidFrame<S>& frame) const;
  template <class S>
  Vec3<S> force(const ContactPairing& pairing, const Meeting<S>& at, const Vec3<S>& velocity,
                std::optional<bool> sticks) const;

  // Current state of a bristle: the vector between its attachment points, and the ratio of static to kinetic
  // friction.
  template <class S>
  struct Grip {
    Vec3<S> span{};
    double holding = 1;
  };
  template <class S>
  Grip<S> grip_of(const Bristle* bristle, const Meeting<S>& at, const RigidFrame<S>& frame0,
                  const RigidFrame<S>& frame1) const;
  template <class S>
  Vec3<S> gripping_force(const ContactPairing& pairing, const Meeting<S>& at, const Vec3<S>& velocity,
                         const Grip<S>& grip) const;
  template <class S>
  Vec3<S> force_of(const HeldContact& contact, const Meeting<S>& at, const Vec3<S>& velocity,
                   const RigidFrame<S>& frame0, const RigidFrame<S>& frame1) const;
  const Bristle* bristle_of(const HeldContact& contact) const;
  void pass_bristles_on(int sphere, std::vector<Found>& found) const;
  double excess_of(const Bristle* bristle, const ContactPairing& pairing, const Meeting<double>& at,
                   double normal_force, const RigidFrame<double>& frame0, const RigidFrame<double>& frame1) const;
  void add_gripping_pairs(int chunk, const Ports& ports) const;
  Bristle bristle_after(const Bristle* before, const ContactPairing& pairing, const Meeting<double>& at,
                        const Vec3<double>& velocity, double normal_force, const RigidFrame<double>& frame0,
                        const RigidFrame<double>& frame1) const;
  void grow_bristles(const Ports& ports);
  ContactPairing pairing_of(const HeldContact& contact) const;
  Vec3<double> velocity_at(int marker, bool turns, const Vec3<double>& arm, const Ports& ports) const;
  struct Partner {
    int marker;
    bool turns;
  };
  Partner partner_of(const HeldContact& contact) const;
  Meeting<double> meet(const HeldContact& contact, const Ports& ports) const;
  void add_held(const HeldContact& contact, Ports& ports) const;
  void add_on_triangles(const Ports& ports, bool rubs, Chunk& chunk) const;
  void add_on_triangles(int sphere, const Ports& ports, bool rubs, Chunk& chunk) const;
  void add_direct(Ports& ports, double* at_nodes) const;
  bool touches(const HeldContact& contact, const Ports& ports, bool& sticks) const;
  void find(const Ports& ports, std::vector<HeldContact>& found) const;

  // Cables, whose coordinates are read and written without markers.
  struct CableNow {
    std::array<double, 8> q{}, v{};
    Box box;
  };
  template <class S>
  struct CableForces {
    Wrench<S> on_circle{};
    std::array<S, 8> on_cable{};
    double normal_force = 0, slip = 0;  // the mean per length (N/m), not cut at zero; the largest slip
  };
  bool is_cable(const HeldContact& c) const {
    return c.other >= set_->first_cable() && c.other < set_->first_triangle();
  }
  void take_cables(const double* q, const double* v) const;
  void take_cables_of_system(ConfigurationType configuration = ConfigurationType::Current) const;
  template <class F>
  void each_cable_near(double distance, F&& f) const;
  void find_cable_touches(std::vector<HeldContact>& found) const;
  ContactPairing cable_pairing(const HeldContact& contact) const;
  template <class S>
  CableForces<S> cable_forces(const HeldContact& contact, const RigidFrame<S>& circle, const std::array<S, 8>& q,
                              const std::array<S, 8>& v, std::optional<bool> sticks) const;
  void add_cable(const HeldContact& contact, Ports& ports, std::optional<bool> sticks, double* r) const;
  void add_cable_tangent(const HeldContact& contact, const Block& block, const Weights& weights, const Ports& ports,
                         double* values) const;
  const Block& block_of(const HeldContact& contact) const;
  void list_blocks(const Ports& ports);

  // Convex shapes and planes, with each other and with spheres and triangles.
  struct ConvexBlock {
    int first, second;
    std::size_t first_slot;
  };
  struct ConvexBristle {
    int first, second;
    std::int64_t key;
    Bristle bristle;
    auto order() const { return std::tuple(first, second, key); }
  };
  bool has_convex() const { return set_->active && !scene_.empty(); }
  void follow_convex(const Ports& ports) const;
  // Active contact points; contacts to be fixed also include inactive points of pairs with an active one, because
  // they may become active before the next search.
  enum class Places { pushing, of_pushing_pairs };
  void find_convex(const Ports& ports, std::vector<ConvexTouch>& found, Places which) const;
  template <class S>
  Vec3<S> convex_force(const ConvexTouch& touch, const Meeting<S>& at, const Vec3<S>& velocity,
                       const RigidFrame<S>& frame0, const RigidFrame<S>& frame1, std::optional<bool> sticks) const;
  ContactPairing convex_pairing(const ConvexTouch& touch) const;
  const ConvexBristle* convex_bristle(const ConvexTouch& touch, std::int64_t key) const;
  const Bristle* bristle_of(const ConvexTouch& touch) const;
  void pass_bristles_on(std::span<ConvexTouch> of_pair) const;
  template <class F>
  void each_convex_batch(const F& f) const;
  void find_overlaps(ConvexScene::Batch& batch) const;
  void find_state(ConvexTouch& touch) const;
  void add_convex(std::span<const ConvexTouch> touches, Ports& ports, bool direct) const;
  void add_convex_verges(const Ports& ports, std::vector<Verge>& verges) const;
  int global_number(int participant) const;
  std::size_t list_convex_blocks(const Ports& ports, std::size_t slot);
  void add_convex_tangent(const Ports& ports, double* values) const;
  struct Changes {
    double count = 0,
           force = 0;  // contacts that have begun or ended; the largest elastic force that was missing, or pulled
  };
  Changes convex_changes() const;
  double elastic_force(const HeldContact& c, const Ports& ports) const;
  void grow_convex(const Ports& ports);
  void write_convex_history(std::vector<double>& numbers) const;
  bool take_convex_history(std::span<const double>& numbers);
  const BoxTree* spheres_for_lines(const Ports& ports, std::uint64_t number) const;
  void hit_spheres(const Line& line, const Ports& ports, std::uint64_t number, LineHit& hit) const;
  void hit_convex(const Line& line, const Ports& ports, LineHit& hit) const;

  std::shared_ptr<const ContactSet> set_;
  std::string name_;
  std::vector<int> markers_;
  std::vector<char> turns_;  // whether the marker of a sphere has a rotation
  std::vector<PortOffsets> offsets_;  // ports of the markers of spheres
  std::vector<NodeFrame> at_nodes_;  // by sphere
  bool shares_nodes_ = false;
  bool shares_markers_ = false;  // several spheres add forces at one marker: threads must not do so at the same time
  std::vector<HeldContact> held_;
  std::vector<Block> blocks_;
  std::vector<std::pair<int, int>> cables_in_blocks_;  // spheres and cables that have been near
  std::vector<CableShape> cables_;
  const System* system_ = nullptr;
  mutable std::vector<CableNow> cables_now_;
  mutable std::vector<HeldContact> cable_touches_;
  std::uint64_t blocks_of_list_ = 0;

  // Caches between evaluations: they affect the search, never the results.
  mutable std::uint64_t shapes_ = ~std::uint64_t{0}, lists_ = 0;
  mutable std::vector<BoxTree> trees_;
  mutable std::vector<Triangle> local_;  // corners of all triangles
  mutable std::vector<Facet> facets_;
  mutable SpherePairs pairs_;
  mutable LargeVector<SphereAt> at_list_;
  mutable std::vector<RigidFrame<double>> carriers_now_, carriers_at_list_;
  mutable SphereNeighbours neighbours_;
  mutable LargeVector<std::size_t> first_triangle_;
  mutable LargeVector<int> near_triangles_, near_spheres_;  // pair by pair
  mutable std::vector<int> carriers_of_triangles_;
  mutable std::vector<char> carriers_rest_;
  mutable double skin_ = 0;
  mutable int since_list_ = 0;
  mutable std::vector<Chunk> chunks_;
  Workers* workers_ = nullptr;
  // Lines that were asked for of the same ports, and their spheres in a tree as soon as it pays.
  struct Lines {
    std::uint64_t ports = 0;
    int count = 0;
    BoxTree spheres;
  };
  mutable Lines lines_;
  std::vector<HeldContact> touching_;
  BristleList bristles_;  // bristles at the start of the step
  std::vector<BristleList::Entry> grown_bristles_;
  mutable ConvexScene scene_;
  std::vector<ConvexTouch> convex_held_, convex_touching_;
  mutable std::vector<ConvexTouch> convex_found_;
  struct ConvexPush {
    Vec3<double> force, moment0, moment1;  // force and moment on the first, moment on the second
  };
  mutable std::vector<ConvexPush> convex_pushes_;
  std::vector<ConvexBlock> convex_blocks_;
  std::vector<ConvexBristle> convex_bristles_, grown_convex_;
  mutable std::uint64_t convex_lists_ = 0;
  bool grown_ = false;  // whether those at the end of the step are known
  // by sphere and convex shape: now, and after the last step; empty: unknown
  mutable std::vector<Verge> verges_, verges_before_;
};

}  // namespace dalembert
