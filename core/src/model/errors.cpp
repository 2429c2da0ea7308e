#include "dalembert/model/errors.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace dalembert {
namespace {

// Case is a frequent slip, so it counts nothing.
bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool contains(std::string_view text, std::string_view part) {
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same_letter) != text.end();
}

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = diagonal + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string in_quotes(std::string_view word) { return "'" + std::string(word) + "'"; }

std::string with_article(std::string_view noun) {
  const bool vowel = !noun.empty() && std::string_view("aeiouAEIOU").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + std::string(noun);
}

std::string Complaint::text() const {
  std::string text = item;
  const auto join = [&](std::string_view separator, const std::string& part) {
    if (part.empty()) return;
    if (!text.empty()) text += separator;
    text += part;
  };
  if (!parameter.empty()) join(", ", "parameter " + in_quotes(parameter));
  join(": ", problem);
  if (!received.empty()) join(problem.empty() ? ": " : "; ", "received " + received);
  if (!expected.empty()) join(received.empty() ? ": " : ", but ", "expected " + expected);
  if (!text.empty() && text.back() != '.' && text.back() != '?') text += '.';
  join(" ", advice);
  if (!advice.empty() && text.back() != '.' && text.back() != '?') text += '.';
  return text;
}

void refuse(ErrorKind kind, const Complaint& complaint) { throw ModelError(kind, complaint.text()); }

std::string nearest(std::string_view word, const std::vector<std::string_view>& known) {
  std::string_view best;
  int least = static_cast<int>(std::max<std::size_t>(word.size(), 3)) / 2 + 1;
  for (const std::string_view candidate : known) {
    int distance = edit_distance(word, candidate);
    // A word that is part of the other is close, however long the rest is.
    if (word.size() >= 4 && contains(candidate, word)) distance = std::min(distance, 2);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return std::string(best);
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& known) {
  if (const std::string best = nearest(word, known); !best.empty()) return "Did you mean " + in_quotes(best) + "?";
  if (known.empty()) return {};
  std::string text = "Known are: ";
  for (std::size_t i = 0; i < known.size(); ++i) text += (i == 0 ? "" : ", ") + std::string(known[i]);
  return text + ".";
}

}  // namespace dalembert
