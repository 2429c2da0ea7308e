// User functions of items that came from Python: the object that the user passed, and whose function it is.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "dalembert/model/item.hpp"
#include "dalembert/reflection/callback.hpp"
#include "occupation.hpp"

namespace dalembert {

namespace py = pybind11;

class MainSystem;

class ItemCallback : public Callback {
 public:
  ItemCallback(py::object function, const Row& row) : function_(std::move(function)), row_(row) {}
  ~ItemCallback() override;
  ItemCallback(const ItemCallback&) = delete;
  ItemCallback& operator=(const ItemCallback&) = delete;

  const py::object& function() const { return function_; }
  void drop() const { function_ = py::none(); }  // called by the garbage collector
  // A copy that refers to the owner of the function.
  std::shared_ptr<const Callback> bound_to(const ItemType& type, MainSystem& main) const;

 protected:
  const Row& row() const { return row_; }
  const Signature& signature() const;
  std::shared_ptr<MainSystem> main() const { return main_.lock(); }
  // The result must live while the function runs.
  RunningFunction running(int item) const;
  // "user function 'springForceUserFunction' of object 3 'spring' (ObjectConnectorSpringDamper)"
  std::string describe(int item) const;
  // "springForceUserFunction(mbs, t, itemNumber, ...)"; empty if it is not known whose function it is.
  std::string expected_call() const;

 private:
  virtual std::shared_ptr<ItemCallback> copy() const = 0;
  bool has_this(const MainSystem& main, int number) const;
  int find_this(const MainSystem& main) const;

  mutable py::object function_;
  const Row& row_;
  const ItemType* type_ = nullptr;
  std::weak_ptr<MainSystem> main_;
};

}  // namespace dalembert
