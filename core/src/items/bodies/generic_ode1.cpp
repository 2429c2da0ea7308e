// ObjectGenericODE1, specs/bodies/generic_ode1.toml: as many coordinates as its nodes have.
#include <array>

#include "dalembert/batches/user_vector.hpp"
#include "dalembert/bodies/generic_ode1_parameters.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

using Parameters = ObjectGenericODE1Parameters;

const Parameters& parameters(const void* record) {
  return static_cast<const ObjectGenericODE1Record*>(record)->parameters;
}

class GenericODE1Batch final : public Term {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry e{parameters(record), placement.ode1, placement.ode1, placement.item};
    for (int& row : e.rows) row += placement.ode1_offset;
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override { entries_[entry].parameters = parameters(record); }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_) visitor.block(e.rows, e.rows);
  }

  // The right-hand side A y + f + f_user(t, y)
  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    for (const Entry& e : entries_) {
      const std::size_t n = e.rows.size();
      const std::vector<double> y = e.coordinates(evaluation);
      std::vector<double> rate(n, 0.0);
      if (e.parameters.rhsUserFunction) e.user(evaluation.time, y, rate);
      const DynamicMatrix<double>& a = e.parameters.systemMatrix;
      for (std::size_t i = 0; i < n; ++i) {
        double sum = rate[i];
        if (!e.parameters.rhsVector.empty()) sum += e.parameters.rhsVector[i];
        for (int j = 0; j < a.columns; ++j) sum += a(static_cast<int>(i), j) * y[j];
        r[e.rows[i]] += sum;
      }
    }
  }
  void tangent(const Evaluation& evaluation, const Weights& w, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    for (const Entry& e : entries_) {
      const std::size_t n = e.rows.size();
      std::vector<double> block(n * n, 0.0);
      const std::vector<double>& a = e.parameters.systemMatrix.values;
      for (std::size_t i = 0; i < a.size(); ++i) block[i] += w.y * a[i];
      if (e.parameters.rhsUserFunction) {
        std::vector<double> y = e.coordinates(evaluation);
        add_differences(y, w.y, block, [&](std::span<double> rate) { e.user(evaluation.time, y, rate); });
      }
      for (const double entry : block) slot.add(entry);
    }
  }

 private:
  struct Entry {
    Parameters parameters;
    std::vector<int> places, rows;  // in the vector of ODE1 coordinates, in the system vector
    int item = -1;

    std::vector<double> coordinates(const Evaluation& evaluation) const {
      std::vector<double> y;
      for (const int i : places) y.push_back(evaluation.y[i]);
      return y;
    }
    void user(double time, const std::vector<double>& y, std::span<double> rate) const {
      const std::array arguments{as_argument(y)};
      parameters.rhsUserFunction.callback->call(time, item, arguments, rate);
    }
  };
  std::vector<Entry> entries_;
};

struct GenericODE1Physics final : ObjectPhysics {
  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override {
    return std::make_unique<GenericODE1Batch>();
  }
  void check(const void* record, const Placement& placement, const Ports&, const ItemLabel& item) const override {
    const Parameters& p = parameters(record);
    const int n = static_cast<int>(placement.ode1.size()), rows = p.systemMatrix.rows, columns = p.systemMatrix.columns;
    const std::string nodes = ", for the " + std::to_string(n) + " coordinates of the object's nodes, or none";
    if (rows * columns != 0 && (rows != n || columns != n))
      refuse(ErrorKind::value,
             {item, "systemMatrix", "", "a matrix of " + std::to_string(rows) + " x " + std::to_string(columns),
              "a matrix of " + std::to_string(n) + " x " + std::to_string(n) + nodes, ""});
    if (!p.rhsVector.empty() && p.rhsVector.size() != placement.ode1.size())
      refuse(ErrorKind::value, {item, "rhsVector", "", "a vector of length " + std::to_string(p.rhsVector.size()),
                                "a vector of length " + std::to_string(n) + nodes, ""});
  }
};

}  // namespace

const Physics& object_generic_ode1_physics() {
  static const GenericODE1Physics physics;
  return physics;
}

}  // namespace dalembert
