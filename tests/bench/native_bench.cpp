// The engine against gcc -O2: the same program in C, the same inputs, and in the end the same memory. One trace, and
// many side by side, of which each scan of a trace counts. Prints for each program the median of the ratios of pairs
// that were measured one behind the other, and their spread. Ends with 1 if the memories differ or a ratio misses its
// bar. --kept asks for what was reached instead of the bars; --markdown writes the table that the guide quotes.
#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"
#include "tests/bench/c_translation.hpp"
#include "tests/bench/native_many.hpp"
#include "tests/bench/native_programs.hpp"

namespace rungproof::bench {
namespace {

constexpr int pairs = 9;
constexpr double secondsOfOne = 0.05;  ///< of processor time, of each side of a pair
constexpr double manyBar = 8;          ///< of the speed of gcc -O2 that many traces shall reach
constexpr int scansCompared = 2'000;   ///< after which the memories shall be the same
constexpr int tracesCompared = 16;     ///< of the many, as many as C runs again

using ScanInC = void (*)(unsigned char* i, unsigned char* q, unsigned char* m, unsigned char* v, int* ac);

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The program in C, compiled.
ScanInC compiledC(const Program& program, const std::filesystem::path& folder) {
  static int number = 0;
  const std::string source = folder / "program.c", library = folder / fmt::format("program{}.so", number++);
  std::ofstream(source) << inC(program);
  const std::string command = "gcc -O2 -fno-strict-aliasing -fwrapv -shared -fPIC -o " + library + " " + source;
  if (std::system(command.c_str()) != 0) throw std::runtime_error("gcc failed");
  void* handle = ::dlopen(library.c_str(), RTLD_NOW);
  if (handle == nullptr) throw std::runtime_error(::dlerror());
  return reinterpret_cast<ScanInC>(::dlsym(handle, "scan"));
}

/// The same running on memory of its own.
class CSide {
 public:
  explicit CSide(ScanInC scan, std::uint64_t trace = 0) : scan_(scan), inputs_(trace) {}
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
std::string difference(const Concrete::Store& store, const CSide& c) {
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

/// Pairs of seconds for a scan of a trace: ours, and in C.
class Ratios {
 public:
  void add(double ours, double theirs) {
    ratios_.insert(std::ranges::upper_bound(ratios_, theirs / ours), theirs / ours);
    oursNs_ = std::min(oursNs_, ours * 1e9);
    theirsNs_ = std::min(theirsNs_, theirs * 1e9);
  }
  /// Whether the median reaches the bar and nothing differs.
  bool print(const char* what, double bar, const std::string& differs) {
    std::printf("  %-12s %8.1f ns  gcc -O2 %8.1f ns a scan  ratio %.2f (%.2f to %.2f, bar %.2f)%s\n", what, oursNs_,
                theirsNs_, median(), ratios_.front(), ratios_.back(), bar,
                differs.empty() ? "" : ("  MEMORY DIFFERS: " + differs).c_str());
    return differs.empty() && median() >= bar;
  }
  std::string cell(int digits) const {
    return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", median(), digits, ratios_.front(), digits, ratios_.back(),
                       digits);
  }

 private:
  double median() const { return ratios_[ratios_.size() / 2]; }

  std::vector<double> ratios_;  ///< ascending
  double oursNs_ = 1e12, theirsNs_ = 1e12;
};

/// What is asked for, and how it is told.
enum class Asked : std::uint8_t { Bars, Kept, Table };

/// Whether the program is as fast as it shall be, or as it was, and right.
bool measure(const NativeProgram& native, const std::filesystem::path& folder, Asked asked) {
  const Program program = readText("bench.awl", native.text);
  if (!program.findings.empty()) throw std::runtime_error(program.findings.front().message);
  EngineSide engine(program), paced(program);
  ManySide many(program), pacedMany(program);
  const ScanInC scanInC = compiledC(program, folder);
  CSide c(scanInC), pacedC(scanInC);
  const int engineScans = scansFor(paced), manyScans = scansFor(pacedMany), cScans = scansFor(pacedC);
  Ratios one, ofMany;
  for (int i = 0; i < pairs; ++i) {
    const double ours = secondsPerScan(paced, engineScans), theirs = secondsPerScan(pacedC, cScans);
    one.add(ours, theirs);
    ofMany.add(secondsPerScan(pacedMany, manyScans) / ManySide::count, secondsPerScan(pacedC, cScans));
  }
  engine.run(scansCompared);
  c.run(scansCompared);
  const std::string differs = difference(engine.simulator().store(), c);
  many.run(scansCompared);
  std::string manyDiffer;
  for (std::size_t k = 0; k < tracesCompared && manyDiffer.empty(); ++k) {
    const std::size_t trace = k * (ManySide::count + 1) / tracesCompared;
    CSide own(scanInC, trace);
    own.run(scansCompared);
    manyDiffer = difference(many.traces().store(trace), own);
  }
  if (asked == Asked::Table) {
    std::printf("| %s | %s | %s |\n", native.name.c_str(), one.cell(2).c_str(), ofMany.cell(1).c_str());
    return differs.empty() && manyDiffer.empty();
  }
  std::printf("%s\n", native.name.c_str());
  const bool asksKept = asked == Asked::Kept;
  const bool isOneGood = one.print("one trace", asksKept ? native.kept : native.bar, differs);
  const double keptMany = lanes::vectorsHere() == lanes::Vectors::Bits512 ? native.keptMany : 0;
  return ofMany.print("many traces", asksKept ? keptMany : manyBar, manyDiffer) && isOneGood;
}

}  // namespace
}  // namespace rungproof::bench

int main(int count, char** arguments) {
  using rungproof::bench::Asked;
  const std::string_view option = count == 2 ? arguments[1] : "";
  const Asked asked = option == "--kept" ? Asked::Kept : option == "--markdown" ? Asked::Table : Asked::Bars;
  if (count > 1 && asked == Asked::Bars) {
    std::fprintf(stderr, "usage: bench_native [--kept|--markdown]\n");
    return 2;
  }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("rungproof-native-{}", ::getpid());
  std::filesystem::create_directories(folder);
  if (asked == Asked::Table) std::printf("| Program | one run | 256 runs at once |\n|---|---|---|\n");
  bool isGood = true;
  for (const auto& program : rungproof::bench::nativePrograms(rungproof::bench::seed))
    isGood = rungproof::bench::measure(program, folder, asked) && isGood;
  std::filesystem::remove_all(folder);
  return isGood ? 0 : 1;
}
