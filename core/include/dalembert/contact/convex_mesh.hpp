// Convex shapes on triangles of one body. Corners of the shape contact the triangle below them, independently of
// edges; edges and corners of the mesh contact only if they protrude. So a flat mesh acts like its plane, for any
// fineness.
#pragma once

#include <vector>

#include "dalembert/contact/convex_narrow.hpp"
#include "dalembert/contact/facet.hpp"
#include "dalembert/math/triangle.hpp"

namespace dalembert {

class ConvexMesh {
 public:
  // Edges and corners of triangles that stick out; each belongs to the first triangle that has it. Points are the same where their places are.
  void build(const std::vector<int>& members, const std::vector<Triangle>& all, const std::vector<Facet>& facets);
  struct Candidate {
    std::int64_t key = 0;
    double depth = 0;
    ConvexTouch touch;
  };
  // Temporary data of a search.
  struct Scratch {
    std::vector<Foot> feet;
    std::vector<Candidate> candidates;
  };
  // `shape` is placed in the frame of the triangles; numbers of those near it ascend. Participants are filled in by the caller.
  void find(const ConvexNow& shape, std::span<const int> near, const std::vector<Triangle>& all,
            const std::vector<Facet>& facets, Scratch& scratch, std::vector<ConvexTouch>& found) const;
  // How far corners of a shape are from triangles that they will stand on, at least.
  static double clearance(const ConvexNow& shape, std::span<const int> near, const std::vector<Facet>& facets,
                          Scratch& scratch);

 private:
  struct Edge {
    Vec3<double> begin, along;  // unit vectors
    double length = 0;
    // directions of the triangles on both sides, equal if there is only one
    std::array<Vec3<double>, 2> inward, normal;
  };
  struct Corner {
    Vec3<double> place, normal;  // the mean one around
    std::vector<Vec3<double>> edges;  // that lead away
  };
  static void on_facet(const ConvexNow& shape, const Facet& facet, Scratch& scratch);
  void on_edge(const ConvexNow& shape, const Edge& edge, int number, std::vector<ConvexTouch>& found) const;
  static void rims_on_edge(const ConvexNow& shape, const Edge& edge, int number, double deepest,
                           std::vector<ConvexTouch>& found);
  void round_on_edge(const ConvexNow& shape, const Edge& edge, int number, std::vector<ConvexTouch>& found) const;
  void on_corner(const ConvexNow& shape, const Corner& corner, int number, std::vector<ConvexTouch>& found) const;

  std::vector<Edge> edges_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> first_edge_, first_corner_;  // by number of a triangle among all
  std::vector<int> edge_list_, corner_list_;
};

}  // namespace dalembert
