// The law of one body of run-time size (contracts/sized_body.hpp), ready for evaluations: matrices, constant forces and user
// functions, on the coordinates of the body.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "dalembert/contracts/sized_body.hpp"

namespace dalembert {

class LawOfBody {
 public:
  // Numbers of the body's coordinates in vectors of the system, and of its equations. The law uses those from `begin`
  // on.
  void place(int order, const Placement& placement, int begin);
  // `with_residual`: the tangent is full anyway.
  void read(const SizedLaw& law, bool with_residual);
  bool take_force(const SizedLaw& law);  // the constant vector only; false: it has another length

  int item() const { return item_; }
  const std::vector<int>& dofs() const { return dofs_; }
  bool full() const { return full_; }  // all n x n places of the tangent are written
  bool same_places(const LawOfBody& other) const;
  bool has_mass_function() const { return static_cast<bool>(mass_); }
  bool calls_forces() const { return static_cast<bool>(force_); }

  // Room for the arguments and results of user functions.
  struct Work {
    std::vector<double> q, v, force, matrix;
    void make_room(const LawOfBody& law);
  };
  // A full block, then the places of the sparse matrices.
  void visit(BlockVisitor& visitor) const;
  void add_forces(const Evaluation& evaluation, Work& work, double* r) const;
  void add_inertia(const Evaluation& evaluation, Work& work, double* r) const;
  void add_tangent(const Evaluation& evaluation, const Weights& w, Work& work, std::span<double> block) const;
  void add_sparse(const Weights& w, SlotCursor& slot) const;

 private:
  struct Term {
    StateVector times{};
    SquareMatrix matrix;
  };
  std::span<const int> own_dofs() const { return std::span(dofs_).subspan(begin_); }
  std::span<const int> own_rows() const { return std::span(rows_).subspan(begin_); }
  void call(const UserFunction& f, const Evaluation& evaluation, Work& work, std::span<double> result) const;
  void take_arguments(const UserFunction& f, const Evaluation& evaluation, Work& work) const;
  // `known`: the result of the last call serves if its arguments were the same.
  void repeat(const UserFunction& f, double time, const Work& work, std::span<double> result, bool known = false) const;

  int item_ = -1, order_ = 2;
  std::size_t begin_ = 0;
  std::vector<int> dofs_, rows_;
  std::array<Term, 3> terms_;
  std::vector<double> force_vector_;
  UserFunction force_, mass_, jacobian_;
  bool full_ = false;
  bool forceless_ = true;  // neither forces nor matrices but that of masses
};

// Rejects matrices and vectors whose size is neither zero nor the number of coordinates.
void check_sizes(const SizedLaw& law, int coordinates, std::string_view called, const ItemLabel& item);
// Refuses a matrix of another size.
void check_size(const char* parameter, const DynamicMatrix<double>& m, int rows, int columns, const ItemLabel& item,
                const char* advice);

}  // namespace dalembert
