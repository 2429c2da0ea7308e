// One row of a parameter table: data to read, write, check and name a member.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// The last four are for vectors and matrices, see core/include/dalembert/model/value_checks.hpp.
enum class Check : std::uint8_t { none, non_negative, positive, rotation, orthogonal, unit_vector, color };

// Integers that count named parts, whose names may replace the numbers (model/references.hpp).
enum class Named : std::uint8_t { no, links, joints };

enum class Role : std::uint8_t { name, parameter, visualization };

struct Argument;  // core/include/dalembert/reflection/callback.hpp

// Calls a C function of one signature, see core/include/dalembert/reflection/compiled_call.hpp.
using CompiledCall = void (*)(const void* function, double time, int item, std::span<const Argument> arguments,
                              std::span<double> results);

// Arguments and result of the row's user function, from the spec.
struct Signature {
  // The open ones have a length that is known at run time only.
  enum class Kind : std::uint8_t {
    scalar,
    integer,
    boolean,
    vector,
    matrix,
    open_vector,
    open_matrix,
    index_list,
    configuration
  };
  std::span<const Kind> arguments;  // following mbs, t and (if takes_item) the item number
  bool takes_time = true;
  bool takes_item = true;
  Kind result = Kind::scalar;
  CompiledCall compiled = nullptr;  // null: it can be a Python function only

  static constexpr bool is_vector(Kind kind) { return kind == Kind::vector || kind == Kind::open_vector; }
  static constexpr bool is_matrix(Kind kind) { return kind == Kind::matrix || kind == Kind::open_matrix; }
  static constexpr bool is_open(Kind kind) { return kind == Kind::open_vector || kind == Kind::open_matrix; }
};

struct Row {
  std::string_view name;
  Storage storage;
  std::uint32_t offset;  // offset of the member in the record
  Role role;
  Check check = Check::none;
  Named named = Named::no;
  std::uint8_t size = 0;                      // required length of a dynamic array; 0: any
  bool takes_number = false;                  // a number is a vector or matrix with this one entry
  bool internal = false;                      // never a constructor argument; read-only from outside
  bool optional = false;                      // indices: may stay invalid
  bool needs_assemble = false;                // a change takes effect at the next Assemble only
  std::string_view unit = {};
  std::span<const std::string_view> aliases = {};
  const Signature* signature = nullptr;  // signature of a user function
  std::uint16_t enumeration = 0;              // Storage::enumeration: number of the table in enums.hpp
};

}  // namespace dalembert
