// CompiledProgram: the program's part of a scan as machine code, made from the instructions' meanings over the
// recording domain. It does a scan as the reference engine does, or says that it cannot and leaves the state as it was:
// errors that are new, fatal or for OB121, devices, pointers of which nothing says into which area they lead, and what
// else has no code. Covered by tests/compiled.
#pragma once

#include <memory>
#include <vector>

#include "engine/compiled/emitter.hpp"
#include "engine/compiled/recording.hpp"
#include "engine/run_time_error.hpp"

namespace rungproof::compiled {

class CompiledProgram {
 public:
  /// nullptr: there is no machine code for this program or this processor.
  static std::unique_ptr<CompiledProgram> of(const Plan& plan, const Concrete::Store& model,
                                             const InstructionTimes& times, bool countsTime);

  /// What one pass takes at most, 10 ns; nothing where there are loops.
  std::optional<std::uint64_t> mostTime() const {
    return code_.hasLoops ? std::nullopt : std::optional(code_.mostTime);
  }
  bool countsTime() const { return code_.countsTime; }
  /// Whether it reads inputs at once, which somebody else may give.
  bool asksOutside() const { return code_.asksOutside; }
  /// Whether it reads what an S7-300/400 leaves open.
  bool takesFree() const { return code_.takesFree; }

  /// Runs the program on `store`, as in a scan after the first one. `ticks100`: of that scan. `mostTime`: a program
  /// that takes longer is left. Errors that happened before are counted, and told later. Gives the time that the
  /// program took, 10 ns (0 where it is not counted); nothing: it was left, and the store is as before.
  std::optional<std::uint64_t> run(Concrete::Store& store, std::uint64_t ticks100, std::uint64_t mostTime,
                                   const RunTimeErrors& errors);
  /// Tells how often errors of `errors` have happened in the scans since the last time.
  void tellErrors(RunTimeErrors& errors);

 private:
  /// Bytes of an area without slots, or registers, that the code writes.
  struct Written {
    Area area;
    std::uint32_t first, count;
  };
  CompiledProgram(Code code, const std::vector<bool>& isNeeded, std::unique_ptr<MachineCode> machineCode,
                  std::size_t registers);
  void findWritten(const std::vector<bool>& isNeeded, std::size_t registers);
  void keep(const Concrete::Store& store);
  void takeBack(Concrete::Store& store);
  void clearLocal(Concrete::Store& store) const;
  Workspace& workspace() { return *reinterpret_cast<Workspace*>(memory_.data()); }
  std::uint32_t* numbers(std::size_t at) { return reinterpret_cast<std::uint32_t*>(memory_.data()) + at / 4; }
  std::uint8_t* news() { return reinterpret_cast<std::uint8_t*>(memory_.data()) + machineCode_->layout.news; }
  void learnErrors(const RunTimeErrors& errors);
  void addErrors(bool areOfScan);

  Code code_;
  std::unique_ptr<MachineCode> machineCode_;
  std::vector<std::uint64_t> memory_;  ///< the workspace
  bool canLeave_ = false;
  std::vector<std::size_t> listedAt_;            ///< by error site that is no news: where it stands among the errors
  std::vector<std::uint64_t> errorCounts_;       ///< by error site: how often it has happened and is not yet told
  std::uint64_t clearings_ = ~std::uint64_t{0};  ///< of the list to which the counts belong
  std::size_t listed_ = 0;                       ///< errors of that list that are no news
  std::vector<Area> usedAreas_;
  std::vector<Written> writtenBytes_, writtenLocals_;
  std::vector<Written> writtenRegisters_;
  std::vector<std::uint8_t> keptBytes_;
  std::vector<std::uint32_t> keptRegisters_;
};

}  // namespace rungproof::compiled
