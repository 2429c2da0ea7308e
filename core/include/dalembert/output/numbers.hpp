// Numbers as text, as printf("%.*g") gives them, without streams.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>

namespace dalembert {

inline void append_number(std::string& text, double value, int precision) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general,
                                 precision < 1 ? 1 : (precision > 25 ? 25 : precision));
  text.append(buffer, end.ptr);
}

inline void append_integer(std::string& text, std::int64_t value) {
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

inline std::string format_number(double value, int precision = 6) {
  std::string text;
  append_number(text, value, precision);
  return text;
}

// The shortest text from which the same number is read back.
inline void append_exact(std::string& text, double value) {
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

}  // namespace dalembert
