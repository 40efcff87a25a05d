// Running both sides and comparing.
#include "comparison.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace rungproof::referee {
namespace {

std::string stringAfter(const std::string& json, const std::string& key, std::size_t from, std::size_t* end = nullptr) {
  const std::string label = "\"" + key + "\": ";
  const std::size_t at = json.find(label, from);
  if (at == std::string::npos) return {};
  std::size_t first = at + label.size();
  if (json[first] == '"') ++first;
  const std::size_t last = json.find_first_of("\",\n", first);
  if (end != nullptr) *end = last;
  return json.substr(first, last - first);
}

/// The first run that hits the property, among `runs` from `seed` on.
std::optional<Contradiction> firstHit(const Program& program, Property& property, std::uint64_t seed, int bound,
                                      const Settings& settings) {
  for (int run = 0; run < settings.runs; ++run) {
    const std::uint64_t runSeed = seed + static_cast<std::uint64_t>(run);
    Machine machine(program, runSeed, settings.open);
    property.reset();
    for (int scan = 0; scan < bound && machine.scan(); ++scan) {
      if (!property.hits(machine)) continue;
      Contradiction hit;
      hit.property = property.text();
      hit.run = runSeed;
      hit.scan = machine.scanNumber();
      return hit;
    }
  }
  return std::nullopt;
}

void narrate(const Program& program, Contradiction& hit, const Settings& settings) {
  Machine machine(program, hit.run, settings.open);
  machine.tellAll();
  while (machine.scanNumber() < hit.scan && machine.scan()) {
  }
  hit.told = machine.told();
}

int boundOf(const Verdict& verdict, const Settings& settings) {
  return verdict.word == "HOLDS TO BOUND" ? std::min(verdict.depth, settings.scans) : settings.scans;
}

bool claims(const std::string& word) {
  return word == "PROVED" || word == "UNREACHABLE" || word == "VACUOUS" || word == "HOLDS TO BOUND";
}

/// Events of timed interrupts by time: no more of them than intervals have passed (001:5470).
struct TimedCount {
  std::string event, interval;  ///< "10", "SMB34"
  int period = 0;
  int seen = 0;
};

std::vector<TimedCount> timedCounts(const std::string& text) {
  std::vector<TimedCount> counts = {{"10", ", SMB34\n"}, {"11", ", SMB35\n"}};
  for (TimedCount& count : counts) {
    const std::size_t at = text.find(count.interval);
    const std::size_t line = at == std::string::npos ? at : text.rfind("MOVB ", at);
    if (line == std::string::npos || text.find(count.interval, at + 1) != std::string::npos) continue;
    count.period = std::stoi(text.substr(line + 5));
  }
  return counts;
}

/// Why an event cannot have happened by the text of the program alone; empty if nothing speaks against it.
std::string causeMissing(const std::string& text, const std::string& number) {
  static const std::vector<std::pair<std::string, std::string>> causes = {
      {"9", "XMT "},  {"23", "RCV "}, {"21", " T32"}, {"22", " T96"},
      {"12", "HSC "}, {"27", "HSC "}, {"28", "HSC "}, {"19", "PLS "}};
  if (text.find(", " + number + "\n") == std::string::npos) return "event " + number + " is not attached";
  if (text.find("ENI\n") == std::string::npos) return "event " + number + " without ENI";
  for (const auto& [of, needed] : causes) {
    if (of == number && text.find(needed) == std::string::npos) return "event " + number + " has no cause";
  }
  return {};
}

/// Looks through the events of a witness (its columns: scan, time_ms, scan_ms, event, ...).
std::string impossibleEvent(const std::string& text, const std::string& trace) {
  std::vector<TimedCount> timed = timedCounts(text);
  std::ifstream file(trace);
  std::string line;
  std::getline(file, line);
  if (line.compare(0, 27, "scan,time_ms,scan_ms,event,") != 0) return {};
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string scan, time, length, cell;
    std::getline(cells, scan, ',');
    std::getline(cells, time, ',');
    std::getline(cells, length, ',');
    std::getline(cells, cell, ',');
    std::istringstream events(cell);
    for (std::string event; events >> event;) {
      // "q10@17" is served from the queue, "&10@17" together with the next.
      if (event.front() == 'q' || event.front() == '&') event.erase(0, 1);
      // "17x1@5" is event 1, 17 times.
      const std::size_t times = event.find('x');
      const std::size_t begin = times == std::string::npos ? 0 : times + 1;
      const std::string number = event.substr(begin, event.find('@') - begin);
      const std::string missing = causeMissing(text, number);
      if (!missing.empty()) return missing;
      for (TimedCount& count : timed) {
        if (count.event != number || count.period == 0) continue;
        count.seen += times == std::string::npos ? 1 : std::stoi(event);
        if (count.seen * count.period > std::stoi(time)) return "event " + number + " too often by scan " + scan;
      }
    }
  }
  return {};
}

}  // namespace

std::map<std::string, Verdict> verdictsOf(const std::string& text, const Settings& settings, std::string& complaint) {
  const std::string file = settings.folder + "/case.awl";
  const std::string traces = settings.folder + "/traces";
  std::ofstream(file) << text;
  std::filesystem::remove_all(traces);
  const std::string command = settings.prover + " prove --isolated --jobs 1 --timeout " +
                              std::to_string(static_cast<int>(settings.timeout * 1000)) + "ms --format json --traces " +
                              traces + " " + file + " 2>&1";
  std::string json;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) json.append(buffer.data(), n);
  const int status = pclose(pipe);
  std::map<std::string, Verdict> verdicts;
  std::size_t at = json.find("\"properties\": [");
  if (status < 0 || (status & 0x7F) != 0 || (status >> 8) == 2 || (status >> 8) > 3 || at == std::string::npos) {
    complaint = json;
    return {};
  }
  const std::size_t end = json.find("\"comparison\"", at);
  while (true) {
    std::size_t next = std::string::npos;
    const std::string name = stringAfter(json, "name", at, &next);
    if (next == std::string::npos || next > end) break;
    Verdict verdict;
    verdict.word = stringAfter(json, "verdict", next);
    const std::string depth = stringAfter(json, "depth", next);
    verdict.depth = depth.empty() || depth == "null" ? 0 : std::stoi(depth);
    if (verdict.word.compare(0, 14, "HOLDS TO BOUND") == 0) verdict.word = "HOLDS TO BOUND";
    verdicts[name] = verdict;
    at = next;
  }
  return verdicts;
}

std::string Contradiction::report() const {
  std::string report = "CONTRADICTION " + verdict + " " + property + "\nrun " + std::to_string(run) + ", scan " +
                       std::to_string(scan) + "\n" + text;
  for (std::size_t n = 0, same = 1; n < told.size(); ++n, ++same) {
    if (n + 1 < told.size() && told[n + 1] == told[n]) continue;
    report += "  " + told[n] + (same > 1 ? ", " + std::to_string(same) + " times" : "") + "\n";
    same = 0;
  }
  return report;
}

void Outcomes::add(const Outcomes& other) {
  pairs += other.pairs;
  undecided += other.undecided;
  proved += other.proved;
  shown += other.shown;
  reproduced += other.reproduced;
  for (const auto& [word, count] : other.words) words[word] += count;
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  append(contradictions, other.contradictions);
  append(impossible, other.impossible);
  append(unreproduced, other.unreproduced);
  append(complaints, other.complaints);
}

Outcomes compare(const Case& drawn, std::uint64_t seed, const Settings& settings) {
  Outcomes outcomes;
  const std::string text = drawn.text();
  const Program program = programOf(text);
  std::string complaint;
  const std::map<std::string, Verdict> verdicts = verdictsOf(text, settings, complaint);
  if (!complaint.empty()) {
    outcomes.complaints.push_back(complaint + "\n" + text);
    return outcomes;
  }
  for (const std::string& line : drawn.properties) {
    Property property(line);
    const auto found = verdicts.find(property.name());
    if (found == verdicts.end()) {
      outcomes.complaints.push_back("no verdict for " + line + "\n" + text);
      continue;
    }
    const Verdict& verdict = found->second;
    ++outcomes.pairs;
    ++outcomes.words[verdict.word];
    const std::optional<Contradiction> hit =
        firstHit(program, property, seed * 1000003U, boundOf(verdict, settings), settings);
    if (claims(verdict.word)) {
      ++outcomes.proved;
      if (!hit) continue;
      outcomes.contradictions.push_back(*hit);
      Contradiction& last = outcomes.contradictions.back();
      last.verdict = verdict.word;
      last.text = text;
      narrate(program, last, settings);
    } else if (verdict.word == "VIOLATED" || verdict.word == "REACHABLE") {
      ++outcomes.shown;
      if (hit) ++outcomes.reproduced;
      const std::string why = impossibleEvent(text, settings.folder + "/traces/" + property.name() + ".csv");
      if (!why.empty()) outcomes.impossible.push_back(why + ": " + line + "\n" + text);
      if (!hit) outcomes.unreproduced.push_back(verdict.word + " " + line + "\n" + text);
    } else {
      ++outcomes.undecided;
    }
  }
  return outcomes;
}

Contradiction shrink(Case drawn, const Contradiction& found, const Settings& settings) {
  drawn.properties = {found.property};
  Contradiction smallest = found;
  // Takes the smaller program if it still shows the contradiction.
  const auto accept = [&](const Case& smaller) {
    std::string complaint;
    const std::string text = smaller.text();
    const Program program = programOf(text);
    Property property(found.property);
    std::optional<Contradiction> hit = firstHit(program, property, found.run, settings.scans, settings);
    if (!hit) return false;
    const auto verdicts = verdictsOf(text, settings, complaint);
    const auto verdict = verdicts.find(property.name());
    if (verdict == verdicts.end() || !claims(verdict->second.word)) return false;
    if (hit->scan > boundOf(verdict->second, settings)) return false;
    hit->verdict = verdict->second.word;
    hit->text = text;
    narrate(program, *hit, settings);
    smallest = *hit;
    return true;
  };
  if (!accept(drawn)) return smallest;
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t b = 0; b < drawn.blocks.size(); ++b) {
      for (std::size_t n = drawn.blocks[b].networks.size(); n-- > 0;) {
        Case less = drawn;
        auto& networks = less.blocks[b].networks;
        if (networks.size() < 2) continue;
        networks.erase(networks.begin() + static_cast<long>(n));
        if (!accept(less)) continue;
        drawn = less;
        smaller = true;
      }
      for (std::size_t n = 0; n < drawn.blocks[b].networks.size(); ++n) {
        for (std::size_t k = drawn.blocks[b].networks[n].size(); k-- > 1;) {
          Case less = drawn;
          Network& lines = less.blocks[b].networks[n];
          if (lines.size() < 3) continue;
          lines.erase(lines.begin() + static_cast<long>(k));
          if (!accept(less)) continue;
          drawn = less;
          smaller = true;
        }
      }
    }
  }
  // Of the runs that show it, the one with the least to tell.
  const Program program = programOf(smallest.text);
  Property property(found.property);
  for (std::uint64_t n = 0; n < 40; ++n) {
    Settings more = settings;
    more.runs = settings.runs / 4 + 1;
    std::optional<Contradiction> hit = firstHit(program, property, found.run + 5000 + n * 1000, smallest.scan, more);
    if (!hit) continue;
    narrate(program, *hit, settings);
    if (hit->told.size() >= smallest.told.size()) continue;
    hit->verdict = smallest.verdict;
    hit->text = smallest.text;
    smallest = *hit;
  }
  return smallest;
}

Case drawCase(std::uint64_t seed, const std::vector<Topic>& topics, const Settings& settings) {
  CaseDraw draw(seed, topics);
  Case drawn = draw.program();
  const Program program = programOf(drawn.text());
  Random random(seed + 77);
  // Statements that are true at some scan ends and false at others.
  std::vector<std::string> changing;
  for (int n = 0; n < 40; ++n) {
    const std::string atom = draw.atom();
    Property statement("reach a: " + atom);
    std::array<bool, 2> seen{};
    for (std::uint64_t run = 0; run < 8 && !(seen[0] && seen[1]); ++run) {
      Machine machine(program, seed + run, settings.open);
      statement.reset();
      for (int scan = 0; scan < 6 && machine.scan(); ++scan) seen.at(statement.hits(machine) ? 1 : 0) = true;
    }
    if (seen[0] && seen[1]) changing.push_back(atom);
  }
  draw.setAtoms(changing);
  Settings few = settings;
  few.runs = 4;
  for (int tries = 0; drawn.properties.size() < 5 && tries < 60; ++tries) {
    const std::string line = draw.property(static_cast<int>(drawn.properties.size()));
    Property property(line);
    if (firstHit(program, property, seed, 5, few) && !random.chance(20)) continue;
    drawn.properties.push_back(line);
  }
  return drawn;
}

}  // namespace rungproof::referee
