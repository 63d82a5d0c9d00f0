// Runs a fuzz target on files and on damaged copies of them, without libFuzzer.
//
//     NAME_replay COUNT SEED FILE...
//
// Each of COUNT copies is of a file drawn at random, with one to four changes.
// The input at hand stands in NAME_replay.input of the working folder: a crash
// or an endless loop leaves it there.
#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"

namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t count, Random& random) {
  return count == 0 ? 0 : random() % count;
}

/// What scenes, meshes and tables are made of, at its limits.
const std::vector<std::string> kWords = {
    "0",      "-1",          "1e999",
    "1e-320", "nan",         "inf",
    "-0",     "2147483648",  "9223372036854775808",
    "\"",     "[",           "]",
    "{",      "}",           "=",
    ",",      "\n",          "\r\n",
    "\xff",   "\0",          "$End",
    "mm",     "[mm]",        "null",
    "true",   "\xef\xbb\xbf"};

/// The number or word around a place.
std::pair<std::size_t, std::size_t> token_at(const std::string& text,
                                             std::size_t at) {
  const auto is_part = [&](std::size_t i) {
    const auto c = static_cast<unsigned char>(text[i]);
    return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_';
  };
  std::size_t begin = at, end = at;
  while (begin > 0 && is_part(begin - 1)) --begin;
  while (end < text.size() && is_part(end)) ++end;
  return {begin, end - begin};
}

void damage(std::string& text, const std::string& other, Random& random) {
  const std::size_t at = below(text.size() + 1, random);
  const std::size_t length = below(std::size_t{1} << below(12, random), random);
  switch (below(8, random)) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(random());
      break;
    case 1:
      text.resize(at);
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(at, text.substr(below(text.size() + 1, random), length));
      break;
    case 4:
      text.insert(at, other.substr(below(other.size() + 1, random), length));
      break;
    case 5:
      text.insert(at, kWords[below(kWords.size(), random)]);
      break;
    default: {
      const auto [begin, size] = token_at(text, at);
      text.replace(begin, size, kWords[below(kWords.size(), random)]);
    }
  }
}

/// @return whether nothing but an Error was thrown.
bool holds(const std::string& input, const std::string& kept_as) {
  std::ofstream(kept_as, std::ios::binary | std::ios::trunc) << input;
  try {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()),
                           input.size());
    return true;
  } catch (const std::exception& thrown) {
    std::cerr << "not an Error: " << thrown.what() << "\n  by " << kept_as
              << "\n";
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kFirstFile = 3;
  if (argc <= kFirstFile) {
    std::cerr << argv[0] << " COUNT SEED FILE...\n";
    return 2;
  }
  const long count = std::stol(argv[1]);
  Random random(std::stoull(argv[2]));
  const std::string kept_as =
      std::filesystem::path(argv[0]).filename().string() + ".input";
  std::vector<std::string> corpus;
  for (int i = kFirstFile; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file),
                        std::istreambuf_iterator<char>());
    if (!holds(corpus.back(), kept_as)) return 1;
  }
  for (long i = 0; i < count; ++i) {
    std::string input = corpus[below(corpus.size(), random)];
    for (std::size_t k = below(4, random) + 1; k > 0; --k) {
      damage(input, corpus[below(corpus.size(), random)], random);
    }
    if (!holds(input, kept_as)) return 1;
  }
  std::filesystem::remove(kept_as);
  std::cout << corpus.size() << " files and " << count
            << " damaged copies read or refused\n";
  return 0;
}
