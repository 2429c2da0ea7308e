// Errors of a model: item, cause and remedy.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// The Python exception of an error.
enum class ErrorKind : unsigned char { value, type, index, name, state, planned };

class ModelError : public std::runtime_error {
 public:
  ModelError(ErrorKind kind, const std::string& text) : std::runtime_error(text), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

// The parts of an error text; empty parts are left out.
struct Complaint {
  std::string item = {};      // "node 3 'foot' (NodePoint)"
  std::string parameter = {}; // "referenceCoordinates"
  std::string problem = {};   // when there is no single value to blame
  std::string received = {};  // "[1, 2] (list of length 2)"
  std::string expected = {};  // "3 finite numbers"
  std::string advice = {};  // remedy
  std::string text() const;
};

class Model;

// How errors name an item of a model; put into words when an error needs them.
struct ItemLabel {
  const Model& model;
  ItemKind kind;
  int number;
  operator std::string() const;  // "node 3 'foot' (NodePoint)"
};

[[noreturn]] void refuse(ErrorKind kind, const Complaint& complaint);

// The known word most similar to `word`; empty if none is close.
std::string nearest(std::string_view word, const std::vector<std::string_view>& known);
// " Did you mean 'x'?" or, when nothing is close, " Known are: a, b, c."
std::string suggestion(std::string_view word, const std::vector<std::string_view>& known);
std::string in_quotes(std::string_view word);
std::string with_article(std::string_view noun);  // "an object"

}  // namespace dalembert
