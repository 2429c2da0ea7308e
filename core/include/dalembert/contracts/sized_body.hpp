// Bodies whose number of coordinates is known at run time only: systems of equations with the user's matrices, meshes, modes.
// A kernel states three things, each of them or none; the batches (batches/sized_body.hpp, batches/sized_marker.hpp) do the rest.
//
//      law        constant matrices, forces and user functions: r = sum of matrices times state vectors - forces
//      residual   what else there is, a template over its scalar with constants that `prepare` has made once; differentiated
//                 in sweeps of a few directions, which the coordinates carry (contracts/sized_coordinates.hpp)
//      Frame the first node, which is the frame of the body; it deforms in the axes of that node.
//                 Mesh nodes move in the frame, linearly in the coordinates: a place on the body is a few constant rows
//                 (contracts/frame_place.hpp)
//
// A kernel also declares missing parts (`NoFrame`, `NothingPrepared`, `Mesh::none`, false): a member that is misspelt or of a
// wrong type does not compile.
#pragma once

#include <array>

#include "dalembert/contracts/frame_place.hpp"
#include "dalembert/contracts/square_matrix.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

// ---- the law ------------------------------------------------------------------------------------------------------------
enum class StateVector { displacement, velocity, acceleration, first_order };

// A matrix parameter, and the state vector that it multiplies.
class ConstantMatrix {
 public:
  ConstantMatrix() = default;
  ConstantMatrix(const char* parameter, StateVector times, const MatrixContainer& m)
      : parameter(parameter), times(times), rows(m.rows), columns(m.columns), container_(&m) {}
  ConstantMatrix(const char* parameter, StateVector times, const DynamicMatrix<double>& m)
      : parameter(parameter), times(times), rows(m.rows), columns(m.columns), values_(m.values) {}
  bool empty() const { return rows == 0 || columns == 0; }
  // Matrices whose entries are those that `matrix` was made from are left as they are.
  void make(SquareMatrix& matrix) const {
    const MatrixContainer given =
        container_ != nullptr ? *container_ : MatrixContainer{rows, columns, true, values_, {}};
    if (!matrix.is_made_from(given)) matrix = SquareMatrix(given);
  }

  const char* parameter = "";
  StateVector times{};
  int rows = 0, columns = 0;

 private:
  const MatrixContainer* container_ = nullptr;
  SharedList<double> values_;
};

// The linear law, for the coordinates that follow those of the frame. Pointers refer to the parameters; null: none.
// User functions of a second-order body take displacements and velocities, those of a first-order body coordinates,
// in both cases of the whole body.
struct SizedLaw {
  std::array<ConstantMatrix, 3> matrices = {};
  const std::vector<double>* force_vector = nullptr;
  const char* force_parameter = "";
  UserFunction force = {}, mass = {}, jacobian = {};

  bool has_user_function() const { return force || mass || jacobian; }
};

// ---- the kernel -----------------------------------------------------------------------------------------------------
// Mesh nodes: none, the nodes of the body, all of these but the first, whose coordinates are in its frame, or nodes
// that are defined only by its parameters.
enum class Mesh { none, nodes, nodes_in_frame, own };

template <class B>
constexpr bool is_framed = !std::is_same_v<typename B::Frame, NoFrame>;
// Its mesh nodes are not at the positions of system nodes: the kernel computes the positions.
template <class B>
constexpr bool places_mesh = B::mesh == Mesh::nodes_in_frame || B::mesh == Mesh::own;
template <class B>
constexpr bool has_residual = !std::is_same_v<typename B::Constants, NothingPrepared>;
// Coordinates of the frame come first.
template <class B>
constexpr int frame_size = [] {
  if constexpr (is_framed<B>) return B::Frame::size;
  return 0;
}();

template <class B>
concept StatesLaw = requires(const typename B::Parameters& p, const Placement& on, const ItemLabel& item) {
  { B::item } -> std::convertible_to<std::string_view>;  // 'ObjectGenericODE2'
  { B::order } -> std::convertible_to<int>;  // order of its differential equations
  { B::coordinates } -> std::convertible_to<std::string_view>;  // name of its coordinates in error texts
  { B::law(p) } -> std::same_as<SizedLaw>;
  { B::takes(B::item, 0) } -> std::same_as<bool>;  // a node of this type at this position
  { B::check(p, on, item) } -> std::same_as<void>;  // beyond the sizes of the law
  { B::computes_parameters } -> std::convertible_to<bool>;
};
// r of M a + f = 0 in addition to the law, row by row of the coordinates.
template <class B>
concept StatesResidual = !has_residual<B> || requires(const typename B::Parameters& p, const typename B::Constants& k,
                                                      const SizedCoordinates<double>& x, std::span<double> r) {
  { B::prepare(p) } -> std::same_as<typename B::Constants>;
  { B::template residual<double>(k, x, r) } -> std::same_as<void>;
};
// The mass of a framed body as a place in it, for loads proportional to mass.
template <class B>
concept StatesFrame = !is_framed<B> || (NodeKernel<typename B::Frame> && requires(const typename B::Parameters& p) {
  { B::whole_mass(p) } -> std::same_as<FramePlace>;
});
// Mesh nodes that the kernel defines: their reference positions in the frame, shape(i, by) for each coordinate `i`
// behind those of the frame that moves them, and outputs of many of them, one after the other.
template <class B>
concept StatesMesh = !places_mesh<B> || requires(const typename B::Parameters& p, const SizedCoordinates<double>& x,
                                                 std::vector<double>& values) {
  { B::mesh_nodes(p) } -> std::same_as<int>;
  { B::rest(p, 0) } -> std::same_as<Vec3<double>>;
  {
    B::each_shape(p, 0, [](int, const Vec3<double>&) {})
  } -> std::same_as<void>;
  { B::mesh_outputs(p, x, 0, 1, OutputVariableType::Position, values) } -> std::same_as<bool>;
};
// Parameters that Assemble finds.
template <class B>
concept CompletesParameters = !B::computes_parameters || requires(typename B::Parameters& p, const Placement& on) {
  { B::complete(p, on) } -> std::same_as<void>;
};

template <class B>
concept SizedBody = StatesLaw<B> && StatesResidual<B> && StatesFrame<B> && StatesMesh<B> && CompletesParameters<B>;

}  // namespace dalembert
