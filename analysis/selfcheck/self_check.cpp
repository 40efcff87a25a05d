// One thread for each job takes the next fault; verdicts are compared by name.
#include "analysis/selfcheck/self_check.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "analysis/equivalence/equivalence.hpp"
#include "analysis/equivalence/output_name.hpp"
#include "analysis/selfcheck/side_by_side.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/iec/variables.hpp"

namespace rungproof {

namespace {

constexpr double secondsPerFault = 0.4;  ///< for each look at a fault that most faults need no more than

bool isGood(Outcome outcome) { return outcome == Outcome::Proved || outcome == Outcome::Reachable; }
bool isBad(Outcome outcome) {
  return outcome == Outcome::Violated || outcome == Outcome::Unreachable || outcome == Outcome::Vacuous;
}

class Checker {
 public:
  Checker(const Program& program, const PropertySet& set, const std::vector<ProofResult>& before,
          const SelfCheckOptions& options)
      : program_(program), set_(set), options_(options), asked_(set), runs_(program, set, options.prover) {
    for (const ProofResult& result : before) {
      if (!result.builtin) before_[result.property.name] = result.outcome;
    }
    if (dialectOf(program.target).memory.isOfVariables) outputs_ = outputVariables(program);
    // A property without a good verdict cannot get a worse one; it would only take time.
    std::erase_if(asked_.properties, [&](const Property& property) {
      const auto known = before_.find(property.name);
      return property.isGoal() && (known == before_.end() || !isGood(known->second));
    });
    for (const Property& property : asked_.properties) {
      if (property.isGoal() && before_.at(property.name) == Outcome::Proved) proved_.push_back(&property);
    }
  }

  SelfCheck run() {
    SelfCheck check;
    for (Fault& fault : faultsOf(program_)) {
      const bool isWanted = options_.kinds.empty() ||
                            std::find(options_.kinds.begin(), options_.kinds.end(), fault.kind) != options_.kinds.end();
      if (isWanted) check.results.push_back({std::move(fault), FaultFate::Undecided, {}, {}});
    }
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::mutex mutex;
    std::vector<char> isTried(check.results.size(), 0);  // not bool: threads write neighbours
    const auto work = [&] {
      for (std::size_t i = next++; i < check.results.size() && !isInterrupted(); i = next++) {
        FaultResult& result = check.results[i];
        try {
          judge(result, options_.seconds);
          if (result.fate == FaultFate::Undecided && options_.patience > options_.seconds && !isInterrupted())
            judge(result, options_.patience);
        } catch (const std::exception&) {  // an error of ours leaves this fault open; a broken CHECK has said so
          result.fate = FaultFate::Undecided;
        }
        isTried[i] = result.fate != FaultFate::Undecided || !isInterrupted() ? 1 : 0;
        const std::lock_guard lock(mutex);
        ++done;
        if (options_.progress) options_.progress(done, check.results.size());
      }
    };
    std::vector<std::thread> threads;
    for (int i = 1; i < options_.prover.jobs; ++i) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    std::vector<FaultResult> tried;
    for (std::size_t i = 0; i < isTried.size(); ++i) {
      if (isTried[i] != 0) tried.push_back(std::move(check.results[i]));
    }
    check.untried = check.results.size() - tried.size();
    check.results = std::move(tried);
    return check;
  }

 private:
  bool isInterrupted() const { return options_.prover.cancel != nullptr && options_.prover.cancel->load(); }

  void judge(FaultResult& result, double most) const {
    ProverOptions options = options_.prover;
    options.timeout = most;
    options.jobs = 1;
    options.checks = {};
    options.evidence = false;
    options.certificates = false;
    Program numbered = planted(program_, result.fault);
    numbered.number();
    EquivalenceOptions both;
    both.prover = options;
    both.interruptsInside = true;
    both.observed = outputs_;
    // The cheap looks first: most faults show at once, or can be seen to do nothing in any single scan.
    const SideBySide::Seen seen = runs_.look(numbered, proved_);
    if (!seen.noticedBy.empty()) {
      result.fate = FaultFate::Noticed;
      result.noticedBy = seen.noticedBy;
      return;
    }
    const double quick = std::min(secondsPerFault, options.timeout);
    both.prover.timeout = quick;
    both.oneScan = true;
    const Side before{&program_, set_}, after{&numbered, set_};
    if (seen.where.empty() && compareBehaviour(before, after, both).equality == Equality::Equal) {
      result.fate = FaultFate::NoEffect;
      return;
    }
    PropertySet open = asked_;
    for (const double seconds : {quick, most}) {
      options.timeout = seconds;
      std::set<std::string> settled;
      prove(numbered, open, options, [&](const ProofResult& now, std::size_t, std::size_t) {
        const auto known = before_.find(now.property.name);
        if (known == before_.end() || !isGood(known->second)) return true;
        if (isGood(now.outcome)) settled.insert(now.property.name);
        if (!isBad(now.outcome)) return true;
        result.noticedBy = now.property.name;
        return false;
      });
      if (!result.noticedBy.empty()) {
        result.fate = FaultFate::Noticed;
        return;
      }
      std::erase_if(open.properties, [&](const Property& p) { return p.isGoal() && settled.contains(p.name); });
      if (std::ranges::none_of(open.properties, &Property::isGoal)) break;
    }
    if (isInterrupted()) return;
    if (!seen.where.empty()) {
      result.fate = FaultFate::Unnoticed;
      result.where = seen.where;
      return;
    }
    both.prover.timeout = most;
    both.oneScan = false;
    const Equivalence found = compareBehaviour(before, after, both);
    switch (found.equality) {
      case Equality::Equal: result.fate = FaultFate::NoEffect; break;
      case Equality::Different: result.fate = FaultFate::Unnoticed; break;
      case Equality::Unknown: result.fate = FaultFate::Undecided; break;
    }
    if (found.run)
      result.where = outputName(program_, found.run->addressBefore, found.run->signal) + " in scan " +
                     std::to_string(found.run->scan);
  }

  const Program& program_;
  const PropertySet& set_;
  const SelfCheckOptions& options_;
  PropertySet asked_;
  std::vector<const Property*> proved_;  ///< of these
  const SideBySide runs_;
  std::map<std::string, Outcome> before_;
  Operands outputs_;  ///< of IEC 61131-3
};

}  // namespace

std::size_t SelfCheck::count(FaultFate fate) const {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [&](const FaultResult& r) { return r.fate == fate; }));
}

double SelfCheck::share() const {
  const std::size_t noticed = count(FaultFate::Noticed), all = noticed + count(FaultFate::Unnoticed);
  return all == 0 ? 100 : 100 * static_cast<double>(noticed) / static_cast<double>(all);
}

SelfCheck selfCheck(const Program& program, const PropertySet& set, const std::vector<ProofResult>& before,
                    const SelfCheckOptions& options) {
  return Checker(program, set, before, options).run();
}

}  // namespace rungproof
