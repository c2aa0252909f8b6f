// Runs a fuzz target over its corpus and over broken copies of it, without clang: an ordinary program of any compiler.
// Arguments: the corpus folder, and how many broken copies of each file (fixed seed).
// Ends with 1 where there is no file.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size);

namespace {

void run(const std::string& text) {
  const std::vector<uint8_t> bytes(text.begin(), text.end());  // of exactly its size, for the sanitizers
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

// A cut, some bytes changed, a part repeated.
std::string broken(std::string text, std::mt19937& random) {
  const auto place = [&] { return text.empty() ? 0 : random() % text.size(); };
  if (random() % 4 == 0) text.resize(place());
  if (random() % 4 == 0) text.insert(place(), text.substr(place(), random() % 40));
  for (uint32_t k = random() % 6; k > 0 && !text.empty(); --k)
    text[place()] = random() % 2 ? "0123456789.,-+eE \r\n"[random() % 19] : char(random());
  return text;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "usage: %s CORPUS COPIES\n", arguments[0]), 2;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::mt19937 random(1);
  size_t executions = 0;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    run(text);
    for (int i = std::atoi(arguments[2]); i > 0; --i) run(broken(text, random)), ++executions;
  }
  std::printf("%zu files, %zu broken copies\n", files.size(), executions);
  return files.empty() ? 1 : 0;
}
