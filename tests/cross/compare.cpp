// SPDX-License-Identifier: Apache-2.0
// Compares two outputs of tests/abi/dump.c, of two processors or systems, number by number.
//   cross_compare HOST.txt TARGET.txt BOUND     exit status 1 when a line differs by more than BOUND of its largest
//   number
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Line {
  std::string words;
  std::vector<double> numbers;
};

/// Splits a line into words and numbers. Systems write hexadecimal numbers with different exponents.
Line parse(const std::string& text) {
  Line line;
  std::istringstream in(text);
  for (std::string token; in >> token;) {
    char* end = nullptr;
    const double number = std::strtod(token.c_str(), &end);
    if (end != token.c_str() && (*end == '\0' || *end == ','))
      line.numbers.push_back(number);
    else
      line.words += token + ' ';
  }
  return line;
}

/// The largest difference of two lines over the largest number of the first. Infinity when their words differ.
double difference(const Line& a, const Line& b) {
  if (a.words != b.words || a.numbers.size() != b.numbers.size()) return std::numeric_limits<double>::infinity();
  double scale = 0.0;
  double most = 0.0;
  for (std::size_t i = 0; i < a.numbers.size(); ++i) {
    if (std::isnan(a.numbers[i]) != std::isnan(b.numbers[i])) return std::numeric_limits<double>::infinity();
    if (std::isnan(a.numbers[i]) || a.numbers[i] == b.numbers[i]) continue;
    most = std::max(most, std::abs(a.numbers[i] - b.numbers[i]));
  }
  for (const double number : a.numbers) scale = std::max(scale, std::abs(number));
  return most == 0.0 ? 0.0 : scale == 0.0 ? std::numeric_limits<double>::infinity() : most / scale;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::ifstream host(argv[1]);
  std::ifstream target(argv[2]);
  const double bound = std::strtod(argv[3], nullptr);
  std::string a;
  std::string b;
  std::size_t lines = 0;
  std::size_t different = 0;
  double most = 0.0;
  for (; std::getline(host, a); ++lines) {
    if (!std::getline(target, b)) b.clear();
    const double d = difference(parse(a), parse(b));
    if (d > 0.0) {
      ++different;
      std::printf("differs by %.3g: %s\n", d, a.substr(0, 60).c_str());
      if (d > bound) std::printf("  host   %s\n  target %s\n", a.c_str(), b.c_str());
    }
    most = std::max(most, d);
  }
  const bool longer = static_cast<bool>(std::getline(target, b));
  std::printf("%zu lines, %zu differ, by %.3g of a line's largest number at most, allowed %.3g\n", lines, different,
              most, bound);
  return lines < 50 || longer || !(most <= bound) ? 1 : 0;
}
