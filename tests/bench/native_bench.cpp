// The engine against gcc -O2: the same program in C, the same inputs, and in the end the same memory. Prints for each
// program the median of the ratios of pairs that were measured one behind the other, and their spread. Ends with 1 if
// the memories differ or a ratio misses its bar.
#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"
#include "tests/bench/c_translation.hpp"
#include "tests/bench/native_programs.hpp"

namespace rungproof::bench {
namespace {

constexpr std::uint64_t seed = 2026;
constexpr int pairs = 9;
constexpr double secondsOfOne = 0.05;  ///< of processor time, of each side of a pair
constexpr int scansPerInput = 8;       ///< the inputs change every so many scans

using ScanInC = void (*)(unsigned char* i, unsigned char* q, unsigned char* m, unsigned char* v, int* ac);

class Inputs {
 public:
  std::uint64_t next() { return state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL; }

 private:
  std::uint64_t state_ = seed;
};

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The program in C, compiled and running on memory of its own.
class CSide {
 public:
  CSide(const Program& program, const std::filesystem::path& folder) {
    const std::string source = folder / "program.c", library = folder / fmt::format("program{}.so", number_++);
    std::ofstream(source) << inC(program);
    const std::string command = "gcc -O2 -fno-strict-aliasing -fwrapv -shared -fPIC -o " + library + " " + source;
    if (std::system(command.c_str()) != 0) throw std::runtime_error("gcc failed");
    void* handle = ::dlopen(library.c_str(), RTLD_NOW);
    if (handle == nullptr) throw std::runtime_error(::dlerror());
    scan_ = reinterpret_cast<ScanInC>(::dlsym(handle, "scan"));
  }
  void run(int scans) {
    for (int k = 0; k < scans; ++k) {
      if (count_++ % scansPerInput == 0) {
        const std::uint64_t bits = inputs_.next();
        for (std::size_t i = 0; i < 64; ++i) inputBits[i] = bits >> i & 1;
      }
      scan_(inputBits.data(), outputs.data(), markers.data(), words.data(), accumulators.data());
    }
  }
  std::array<unsigned char, 128> inputBits{}, outputs{};
  std::array<unsigned char, 256> markers{};
  std::array<unsigned char, 10240> words{};
  std::array<int, 4> accumulators{};

 private:
  static inline int number_ = 0;
  ScanInC scan_;
  Inputs inputs_;
  int count_ = 0;
};

class EngineSide {
 public:
  explicit EngineSide(const Program& program) : simulator_(program, options()) {}
  void run(int scans) {
    for (int k = 0; k < scans; ++k) {
      if (count_++ % scansPerInput == 0) {
        const std::uint64_t bits = inputs_.next();
        for (std::uint32_t byte = 0; byte < 8; ++byte)
          simulator_.write(direct(Area::I, Width::Byte, byte, 0), bits >> 8 * byte & 0xFF);
      }
      simulator_.scan();
    }
  }
  const Simulator& simulator() const { return simulator_; }

 private:
  static SimulatorOptions options() {
    SimulatorOptions options;
    options.engine = EngineKind::Compiled;
    return options;
  }
  Simulator simulator_;
  Inputs inputs_;
  int count_ = 0;
};

/// Where the memories differ; empty: nowhere.
std::string difference(const EngineSide& engine, const CSide& c) {
  const Concrete::Store& store = engine.simulator().store();
  for (std::uint32_t bit = 0; bit < 256; ++bit) {
    if (store.load(Area::M, bit, 1) != c.markers[bit]) return fmt::format("M{}.{}", bit / 8, bit % 8);
    if (bit < 128 && store.load(Area::Q, bit, 1) != c.outputs[bit]) return fmt::format("Q{}.{}", bit / 8, bit % 8);
  }
  for (std::uint32_t byte = 0; byte + 1 < store.area(Area::V).size(); byte += 2) {
    if (store.load(Area::V, 8 * byte, 16) != (c.words[byte] | static_cast<unsigned>(c.words[byte + 1]) << 8))
      return fmt::format("VW{}", byte);
  }
  for (std::uint32_t k = 0; k < 4; ++k) {
    if (store.get(Reg::Accumulator, k) != static_cast<std::uint32_t>(c.accumulators[k])) return fmt::format("AC{}", k);
  }
  return {};
}

template <class Side>
double secondsPerScan(Side& side, int scans) {
  const double before = processorSeconds();
  side.run(scans);
  return (processorSeconds() - before) / scans;
}

/// Scans that take about as long as one measurement shall.
template <class Side>
int scansFor(Side& side) {
  int scans = 64;
  while (true) {
    const double seconds = secondsPerScan(side, scans) * scans;
    if (seconds > secondsOfOne / 4) return std::max(64, static_cast<int>(scans * secondsOfOne / seconds));
    scans *= 4;
  }
}

/// Whether the program is as fast as it shall be, and right.
bool measure(const NativeProgram& native, const std::filesystem::path& folder) {
  const Program program = readText("bench.awl", native.text);
  if (!program.findings.empty()) throw std::runtime_error(program.findings.front().message);
  EngineSide engine(program), paced(program);
  CSide c(program, folder), pacedC(program, folder);
  const int engineScans = scansFor(paced), cScans = scansFor(pacedC);
  const int together = std::max(engineScans, cScans);
  std::vector<double> ratios;
  double engineNs = 0, cNs = 0;
  for (int i = 0; i < pairs; ++i) {
    const double ours = secondsPerScan(paced, engineScans), theirs = secondsPerScan(pacedC, cScans);
    ratios.push_back(theirs / ours);
    engineNs = i == 0 ? ours * 1e9 : std::min(engineNs, ours * 1e9);
    cNs = i == 0 ? theirs * 1e9 : std::min(cNs, theirs * 1e9);
  }
  engine.run(together);
  c.run(together);
  std::sort(ratios.begin(), ratios.end());
  const double median = ratios[ratios.size() / 2];
  const std::string differs = difference(engine, c);
  std::printf("%-36s engine %8.0f ns  gcc -O2 %8.0f ns a scan  ratio %.2f (%.2f to %.2f, bar %.1f)%s\n",
              native.name.c_str(), engineNs, cNs, median, ratios.front(), ratios.back(), native.bar,
              differs.empty() ? "" : ("  MEMORY DIFFERS: " + differs).c_str());
  return differs.empty() && median >= native.bar;
}

}  // namespace
}  // namespace rungproof::bench

int main() {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("rungproof-native-{}", ::getpid());
  std::filesystem::create_directories(folder);
  bool isGood = true;
  for (const auto& program : rungproof::bench::nativePrograms(rungproof::bench::seed))
    isGood = rungproof::bench::measure(program, folder) && isGood;
  std::filesystem::remove_all(folder);
  return isGood ? 0 : 1;
}
