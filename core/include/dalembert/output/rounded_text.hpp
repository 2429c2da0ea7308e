// Numbers of results as text, as printf("%.*g") gives them, in half the time of std::to_chars: the scaled number is found exactly, by integers.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace dalembert {

namespace rounded_text {

using Wide = unsigned __int128;

constexpr int most_digits =
    17;  // beyond these, and for numbers that are too large, too small or not finite, std::to_chars is used
constexpr int most_fives = 55;  // powers of five that have 128 bits at most
constexpr int room = 64;  // characters
constexpr int copied = 24;  // characters of digits that are copied at once; those behind a number are overwritten

struct Tables {
  std::array<std::uint64_t, 20> ten{};
  std::array<Wide, most_fives + 1> five{};
  std::array<double, 61> rounded_ten{};  // from 10^-40 on
  std::array<char, 200> pair{};  // 00 to 99

  constexpr Tables() {
    std::uint64_t power = 1;
    for (auto& x : ten) x = power, power *= 10;
    Wide wide = 1;
    for (auto& x : five) x = wide, wide *= 5;
    double up = 1;
    for (std::size_t i = 40; i < rounded_ten.size(); ++i) rounded_ten[i] = up, up *= 10;
    up = 1;
    for (std::size_t i = 1; i <= 40; ++i) up *= 10, rounded_ten[40 - i] = 1 / up;
    for (int i = 0; i < 100; ++i)
      pair[2 * i] = static_cast<char>('0' + i / 10), pair[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
};
inline constexpr Tables tables;

// m 5^k / 2^s for s > 0: its whole part, and whether the rest is below, at or above a half.
struct Split {
  std::uint64_t whole;
  int rest;
};
inline Split split(std::uint64_t m, int k, int s) {
  const Wide five = tables.five[static_cast<std::size_t>(k)];
  const Wide low = Wide(m) * static_cast<std::uint64_t>(five),
             high = Wide(m) * static_cast<std::uint64_t>(five >> 64) + (low >> 64);
  const auto bottom = static_cast<std::uint64_t>(low);  // the product is high, and these 64 bits
  if (s <= 64) {
    const std::uint64_t half = std::uint64_t(1) << (s - 1), rest = s == 64 ? bottom : bottom & (2 * half - 1);
    const auto whole = static_cast<std::uint64_t>(s == 64 ? high : (high << (64 - s)) | (bottom >> s));
    return {whole, rest > half ? 1 : rest < half ? -1 : 0};
  }
  if (s - 64 > 127) return {0, -1};
  const Wide half = Wide(1) << (s - 65), rest = high & (2 * half - 1);
  return {static_cast<std::uint64_t>(high >> (s - 64)), rest > half ? 1 : rest < half ? -1 : bottom != 0 ? 1 : 0};
}

inline void write_digits(char* digits, std::uint64_t whole, int count) {
  const auto pair = [&](int at, std::uint64_t two) { std::memcpy(digits + at, &tables.pair[2 * two], 2); };
  for (; count >= 8; count -= 8) {
    const auto eight = static_cast<std::uint32_t>(whole % 100000000), high = eight / 10000, low = eight % 10000;
    whole /= 100000000;
    pair(count - 8, high / 100), pair(count - 6, high % 100), pair(count - 4, low / 100), pair(count - 2, low % 100);
  }
  for (; count >= 2; count -= 2, whole /= 100) pair(count - 2, whole % 100);
  if (count == 1) digits[0] = static_cast<char>('0' + whole);
}

// Without trailing zeros; `exponent` is that of the first digit. Copies of a fixed size need no call of a function.
inline char* place_digits(char* to, const char* digits, int precision, int exponent) {
  int count = precision;
  while (count > 1 && digits[count - 1] == '0') --count;
  const auto copy = [&](const char* from, int n) {
    std::memcpy(to, from, copied);
    to += n;
  };
  if (exponent < -4 || exponent >= precision) {
    *to++ = digits[0];
    if (count > 1) *to++ = '.', copy(digits + 1, count - 1);
    *to++ = 'e';
    *to++ = exponent < 0 ? '-' : '+';
    std::memcpy(to, &tables.pair[2 * static_cast<std::size_t>(std::abs(exponent))], 2);
    to += 2;
  } else if (exponent < 0) {
    std::memcpy(to, "0.000", 6);
    to += 1 - exponent;
    copy(digits, count);
  } else if (count > exponent + 1) {
    copy(digits, exponent + 1);
    *to++ = '.';
    copy(digits + exponent + 1, count - exponent - 1);
  } else {
    copy(digits, count);
    for (; count <= exponent; ++count) *to++ = '0';
  }
  return to;
}

// Returns the end.
inline char* write(char* to, double value, int precision) {
  std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
  const auto by_library = [&, begin = to] {
    return std::to_chars(begin, begin + room, value, std::chars_format::general, precision).ptr;
  };
  if (precision > most_digits) return by_library();
  if ((bits >> 63) != 0) *to++ = '-';
  bits = bits << 1 >> 1;
  const int biased = static_cast<int>(bits >> 52);
  if (bits == 0) {
    *to++ = '0';
    return to;
  }
  if (biased == 0) return by_library();
  constexpr std::uint64_t hidden = std::uint64_t(1) << 52;
  const std::uint64_t m = (bits & (hidden - 1)) | hidden;
  const int e = biased - 1075;  // the number is m 2^e
  int exponent = ((e + 52) * 78913) >> 18;  // e + 52 times log10(2), rounded down: the right one, or one less
  if (exponent < -40 || exponent >= most_digits + 2) return by_library();
  if (std::abs(value) >= tables.rounded_ten[static_cast<std::size_t>(exponent + 41)]) ++exponent;
  const auto is_exact = [&] {
    return precision > exponent && precision - 1 - exponent <= most_fives && -(e + precision - 1 - exponent) > 0;
  };
  const auto scaled = [&] { return split(m, precision - 1 - exponent, -(e + precision - 1 - exponent)); };
  if (!is_exact()) return by_library();
  Split n = scaled();
  const std::uint64_t end = tables.ten[static_cast<std::size_t>(precision)],
                      begin = tables.ten[static_cast<std::size_t>(precision - 1)];
  if (n.whole >= end || n.whole < begin) {
    exponent += n.whole >= end ? 1 : -1;
    if (!is_exact()) return by_library();
    n = scaled();
  }
  n.whole += n.rest > 0 || (n.rest == 0 && n.whole % 2 == 1) ? 1 : 0;
  if (n.whole == end) n.whole = begin, ++exponent;
  char digits[most_digits + copied] = {};
  write_digits(digits, n.whole, precision);
  return place_digits(to, digits, precision, exponent);
}

inline int printable(int precision) { return precision < 1 ? 1 : precision > 25 ? 25 : precision; }

}  // namespace rounded_text

// A number behind what the text has.
inline void append_rounded(std::string& text, double value, int precision) {
  char buffer[rounded_text::room];
  text.append(buffer, rounded_text::write(buffer, value, rounded_text::printable(precision)));
}

// Numbers behind what the text has, each after a comma. The text grows once for many of them.
inline void append_rounded(std::string& text, std::span<const double> values, int precision) {
  constexpr std::size_t group = 32;
  char buffer[group * (rounded_text::room + 1)];
  for (; !values.empty(); values = values.subspan(std::min(group, values.size()))) {
    char* to = buffer;
    for (const double value : values.first(std::min(group, values.size()))) {
      *to++ = ',';
      to = rounded_text::write(to, value, rounded_text::printable(precision));
    }
    text.append(buffer, to);
  }
}

}  // namespace dalembert
