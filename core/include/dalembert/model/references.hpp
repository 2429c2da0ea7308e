// Names in place of item numbers. An item is described before its system exists: until it is added, a name is stored
// in its record as a number below -1, which Model replaces by the number of the named item. Names of links and joints
// of kinematic trees are treated in the same way.
#pragma once

#include <string>

#include "dalembert/model/item.hpp"

namespace dalembert {

class Model;

constexpr bool is_named_reference(int number) { return number < -1; }
int named_reference(const std::string& name);      // the same name gives the same number
const std::string& referred_name(int number);

// False if no name has been used: then there is nothing to resolve.
bool names_are_used();

// Refused: a name that no item of the kind has, with the nearest one.
int number_of(const Model& model, ItemKind kind, const std::string& name, const std::string& where,
              const std::string& parameter);
// The number of a link of a kinematic tree, by its name or that of its joint. If one link and another joint have the
// same name, `counted` selects between them.
int number_of_link(const Item& tree, Named counted, const std::string& name, const std::string& where,
                   const std::string& parameter);
// Replaces names by numbers in a record, or in one row of it. `where` is the item, for errors.
void resolve_names(const Model& model, const ItemType& type, const Row& row, void* record, const std::string& where);
Item with_numbers(const Model& model, Item item, const std::string& where);

}  // namespace dalembert
