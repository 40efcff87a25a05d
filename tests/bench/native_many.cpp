// Gives the traces their inputs, bit by bit for all of them.
#include "tests/bench/native_many.hpp"

namespace rungproof::bench {

namespace {

/// Long enough for every program, and no longer than the watchdog allows.
constexpr std::uint32_t scanUs = 200'000;

SimulatorOptions manyOptions() {
  SimulatorOptions options;
  options.scanUs = scanUs;
  return options;
}

/// Rows become columns.
void transpose(std::array<std::uint64_t, 64>& rows) {
  std::uint64_t mask = 0x00000000FFFFFFFF;
  for (std::size_t width = 32; width != 0; width >>= 1, mask ^= mask << width) {
    for (std::size_t k = 0; k < 64; k = (k + width + 1) & ~width) {
      const std::uint64_t swapped = (rows[k] >> width ^ rows[k + width]) & mask;
      rows[k] ^= swapped << width;
      rows[k + width] ^= swapped;
    }
  }
}

}  // namespace

ManySide::ManySide(const Program& program) : traces_(program, manyOptions(), count) {
  sets_.fill(ManyTraces::TraceSet(count / 64));
  for (std::size_t trace = 0; trace < count; ++trace) inputs_.emplace_back(trace);
}

void ManySide::run(int scans) {
  for (int k = 0; k < scans; ++k) {
    if (count_++ % scansPerInput == 0) {
      for (std::size_t word = 0; word < count / 64; ++word) {
        std::array<std::uint64_t, 64> bits;
        for (std::size_t i = 0; i < 64; ++i) bits[i] = inputs_[64 * word + i].next();
        transpose(bits);
        for (std::size_t bit = 0; bit < 64; ++bit) sets_[bit][word] = bits[bit];
      }
      for (std::uint32_t bit = 0; bit < 64; ++bit) traces_.setInput(bit / 8, bit % 8, sets_[bit]);
    }
    traces_.scan();
  }
}

}  // namespace rungproof::bench
