// Commands of the provers, and answers read from what they print.
#include "tests/bench/peers/contender.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace rungproof::peers {

namespace {

constexpr std::array peers = {
    Peer{"pdr", "pdr"},
    Peer{"scorr; pdr", "scorr; pdr"},
    Peer{"dprove", "dprove"},
    Peer{"bmc3", "bmc3", true},
};

std::vector<std::string> withOptions(std::vector<std::string> command, const Obligation& obligation) {
  command.insert(command.end(), obligation.options.begin(), obligation.options.end());
  return command;
}

}  // namespace

std::span<const Peer> peerTable() { return peers; }

Exported exportObligation(const Obligation& obligation, const std::string& rungproof, const std::string& file) {
  const ProcessRun run =
      runProcess(withOptions({rungproof, "export", obligation.program.string(), "--only", obligation.property,
                              "--isolated", "--quiet", "--format", "aiger", "-o", file},
                             obligation),
                 600);
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  Exported exported;
  exported.seconds = run.seconds;
  std::array<std::size_t, 6> header{};
  if (std::sscanf(text.str().c_str(), "aig %zu %zu %zu %zu %zu %zu", &header[0], &header[1], &header[2], &header[3],
                  &header[4], &header[5]) != 6)
    return exported;
  exported.file = file;
  exported.isExact = header[5] == 1 && text.str().find("\napproximated: ") == std::string::npos;
  return exported;
}

Answer answerOfVerdict(const std::string& verdict) {
  if (verdict == "PROVED" || verdict == "UNREACHABLE" || verdict == "VACUOUS") return Answer::Safe;
  return verdict == "VIOLATED" || verdict == "REACHABLE" ? Answer::Unsafe : Answer::Open;
}

Answer answerOfAbc(const std::string& output) {
  if (output.find("Status = 1") != std::string::npos) return Answer::Safe;
  return output.find("Status = 0") != std::string::npos ? Answer::Unsafe : Answer::Open;
}

Measured proveObligation(const Obligation& obligation, const std::string& rungproof, double limit,
                         std::string& verdict) {
  // The prover's own limit counts the clock, the limit here the processor.
  const ProcessRun run = runProcess(
      withOptions({rungproof, "prove", obligation.program.string(), "--only", obligation.property, "--isolated",
                   "--quiet", "--format", "json", "--timeout", std::to_string(std::lround(2 * limit)) + "s"},
                  obligation),
      limit);
  const nlohmann::json report =
      nlohmann::json::parse(run.output.substr(std::min(run.output.find('{'), run.output.size())), nullptr, false);
  verdict = "UNKNOWN";
  if (!run.isCut && report.is_object() && report["properties"].size() == 1)
    verdict = report["properties"][0]["verdict"].get<std::string>();
  const Answer answer = answerOfVerdict(verdict);
  return {answer, answer == Answer::Open ? std::max(limit, run.seconds) : run.seconds};
}

Measured askPeer(const Peer& peer, const Exported& exported, double limit) {
  const std::string script = "read_aiger " + exported.file + "; " + std::string(peer.script) + "; print_status";
  const ProcessRun run = runProcess({"berkeley-abc", "-q", script}, limit);
  Answer answer = run.isCut ? Answer::Open : answerOfAbc(run.output);
  if (answer == Answer::Unsafe && !exported.isExact) answer = Answer::Open;
  return {answer, answer == Answer::Open ? std::max(limit, run.seconds) : run.seconds};
}

}  // namespace rungproof::peers
