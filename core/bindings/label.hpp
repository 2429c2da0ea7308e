// Names of items and methods for error texts; the text is only built when an error occurs.
#pragma once

#include <concepts>
#include <string>

namespace dalembert {

// Must not outlive the objects that it refers to.
class Label {
 public:
  template <std::invocable Words>
  Label(const Words& words)
      : words_(&words), speak_([](const void* w) { return std::string((*static_cast<const Words*>(w))()); }) {}
  Label(const std::string& text)
      : words_(&text), speak_([](const void* t) { return *static_cast<const std::string*>(t); }) {}
  Label(const char* text)
      : words_(text), speak_([](const void* t) { return std::string(static_cast<const char*>(t)); }) {}
  std::string text() const { return speak_(words_); }

 private:
  const void* words_;
  std::string (*speak_)(const void*);
};

}  // namespace dalembert
