// The stored messages for pages, read and written again without Python: docs of the format are in python/dalembert/_live/messages.py.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

int failures = 0;
void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("failed: %s\n", what);
  ++failures;
}

struct Array {
  std::string kind;
  std::vector<std::uint8_t> bytes;

  std::vector<double> numbers() const {
    std::vector<double> result;
    const std::size_t size = kind == "u1" ? 1 : 4;
    for (std::size_t i = 0; i < bytes.size(); i += size) {
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < size; ++k)
        word |= std::uint32_t{bytes[i + k]} << 8 * k;  // little-endian, on any machine
      float number = 0;
      std::memcpy(&number, &word, sizeof number);
      result.push_back(kind == "f4" ? static_cast<double>(number) : static_cast<double>(word));
    }
    return result;
  }
};

// Places in twelve numbers each, of six words.
std::vector<double> turned(const Array& array) {
  std::vector<double> result;
  const auto byte = [&](std::size_t i) { return std::uint32_t{array.bytes[i]}; };
  for (std::size_t at = 0; at < array.bytes.size(); at += 24) {
    const Array place{"f4",
                      {array.bytes.begin() + static_cast<std::ptrdiff_t>(at),
                       array.bytes.begin() + static_cast<std::ptrdiff_t>(at + 12)}};
    double rows[3][3];
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t k = at + 12 + 2 * i;
      rows[i / 3][i % 3] = static_cast<double>(static_cast<std::int16_t>(byte(k) | byte(k + 1) << 8)) / 32000;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      rows[2][i] = rows[0][j] * rows[1][k] - rows[0][k] * rows[1][j];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      result.insert(result.end(), rows[i], rows[i] + 3);
      result.push_back(place.numbers()[i]);
    }
  }
  return result;
}

struct Message {
  std::string words;  // entries of the head, up to the last one: the table of arrays
  std::vector<std::optional<Array>> arrays;
};

constexpr std::string_view table = "\"arrays\":[";

std::string bytes_of(const std::string& name) {
  std::ifstream file(std::filesystem::path(__FILE__).parent_path() / "../pictures/golden" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::uint32_t length_of_head(const std::string& bytes) {
  std::uint32_t length = 0;
  for (std::size_t k = 0; k < 4; ++k) length |= std::uint32_t{static_cast<std::uint8_t>(bytes[k])} << 8 * k;
  return length;
}

// Entries of the table are ["f4",12] or null.
Message read(const std::string& bytes) {
  const std::uint32_t length = length_of_head(bytes);
  const std::string head = bytes.substr(4, length);
  std::size_t at = head.rfind(table);
  Message message{head.substr(0, at), {}};
  std::size_t place = 4 + length;
  expect(place % 8 == 0, "arrays begin at a multiple of 8");
  for (at += table.size(); at < head.size() && head[at] != ']';) {
    if (head[at] == 'n') {
      message.arrays.emplace_back();
      at += 4;
    } else {
      Array array{head.substr(at + 2, 2), {}};
      const std::size_t count = std::stoul(head.substr(at + 6)), size = count * (array.kind == "u1" ? 1 : 4);
      array.bytes.assign(bytes.begin() + static_cast<std::ptrdiff_t>(place),
                         bytes.begin() + static_cast<std::ptrdiff_t>(place + size));
      place += (size + 3) / 4 * 4;
      message.arrays.push_back(array);
      at = head.find(']', at) + 1;
    }
    if (head[at] == ',') ++at;
  }
  expect(place == bytes.size(), "arrays fill the message");
  return message;
}

std::string written(const Message& message) {
  std::string head = message.words + std::string(table), data;
  for (const auto& array : message.arrays) {
    if (head.back() != '[') head += ',';
    if (!array) {
      head += "null";
      continue;
    }
    head += "[\"" + array->kind + "\"," + std::to_string(array->bytes.size() / (array->kind == "u1" ? 1 : 4)) + "]";
    data.append(array->bytes.begin(), array->bytes.end());
    data.resize((data.size() + 3) / 4 * 4);
  }
  head += "]}";
  head.resize((head.size() + 4 + 7) / 8 * 8 - 4, ' ');
  const auto length = static_cast<std::uint32_t>(head.size());
  std::string result;
  for (std::uint32_t k = 0; k < 4; ++k) result += static_cast<char>(length >> 8 * k & 255);
  return result + head + data;
}

}  // namespace

int main() {
  for (const char* name : {"scene.bin", "frame.bin", "turned.bin"}) {
    const std::string bytes = bytes_of(name);
    expect(bytes.size() > 100, "the stored message is there");
    if (bytes.size() <= 100) return failures;
    expect(written(read(bytes)) == bytes, name);
  }
  const Message scene = read(bytes_of("scene.bin")), frame = read(bytes_of("frame.bin"));
  expect(scene.words.find("\"kind\":\"scene\"") != std::string::npos, "kind of the scene");
  expect(frame.words.find("\"kind\":\"frame\",\"time\":2.0") != std::string::npos, "kind and time of the frame");
  expect(scene.arrays.size() == 14 && frame.arrays.size() == 6, "numbers of arrays");
  std::vector<double> rows(12);
  for (std::size_t i = 0; i < 12; ++i) rows[i] = static_cast<double>(i);
  expect(scene.arrays[0]->numbers() == rows, "where the crowd is");
  for (double& x : rows) x += 2;
  expect(frame.arrays[0]->numbers() == rows, "where it has gone");
  expect(frame.arrays[3]->numbers() == std::vector<double>{0, 0, 0, 1, 1, 2}, "a line that has moved");
  expect(scene.arrays[12]->kind == "u1" && scene.arrays[12]->numbers().size() == 3, "a color");
  for (const std::size_t k : {2u, 4u, 5u}) expect(!frame.arrays[k], "what rests is left out");
  const Message quick = read(bytes_of("turned.bin"));
  expect(quick.arrays[0] && quick.arrays[0]->kind == "r6", "places in six words");
  if (failures > 0) return failures;
  const std::vector<double> expected{0.6, -0.8, 0, 1, 0.8, 0.6, 0, 2, 0, 0, 1, -3}, found = turned(*quick.arrays[0]);
  expect(found.size() == expected.size(), "one place");
  for (std::size_t i = 0; i < expected.size(); ++i)
    expect(std::abs(found[i] - expected[i]) < 1e-6, "where a body is that has turned");
  return failures;
}
