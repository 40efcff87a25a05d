// The networks of a program lit for every scan of a run, for the page of a trace. A network that looks as in the scan
// before is drawn once. Tested by tests/show/trace_page_test.cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/instruction_recorder.hpp"
#include "frontend/trace_page.hpp"
#include "ir/program.hpp"

namespace rungproof {

class ScanDrawings {
 public:
  explicit ScanDrawings(const Program& program) : program_(program), recorder_(program.instructionCount()) {}

  /// Watches the run; beginScan() is called by add().
  InstructionRecorder& recorder() { return recorder_; }
  /// Draws the scan that has just been made. When the page is full, further scans are passed over.
  void add();
  TraceDrawings take();

 private:
  /// What a network looked like last, and its drawing.
  struct Last {
    std::string look;
    std::size_t page = 0;
  };
  std::size_t draw(const Pou& pou, const Network& network);

  const Program& program_;
  InstructionRecorder recorder_;
  TraceDrawings drawings_;
  std::map<const Network*, Last> last_;
  std::size_t bytes_ = 0;
};

}  // namespace rungproof
