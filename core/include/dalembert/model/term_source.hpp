// Part of a model that is not an item: Assemble makes a term from it (system/system_term.hpp), such as general
// contact.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

class Model;
class Ports;
class SystemTerm;

class SystemTermSource : public std::enable_shared_from_this<SystemTermSource> {
 public:
  virtual ~SystemTermSource() = default;
  // Throws if it cannot be assembled; `name` begins the error text.
  virtual void check(const Model& model, const std::string& name) const = 0;
  virtual std::unique_ptr<SystemTerm> make_term(const Ports& ports, const std::string& name) const = 0;
  // An item was deleted: numbers behind it move up; adds a sentence for each reference that is lost.
  virtual void shift_references(ItemKind kind, int removed, const std::string& name,
                                std::vector<std::string>& lost) = 0;
};

}  // namespace dalembert
