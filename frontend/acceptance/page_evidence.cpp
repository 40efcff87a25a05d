// Properties: the table of verdicts, and each property with what its verdict rests on. A run is shown as timing
// diagram, as table, and as the networks that matter, lit for every scan; a network that looks as before is drawn once
// and referred to on paper.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "analysis/proof/proof_networks.hpp"
#include "frontend/acceptance/page_writer.hpp"
#include "frontend/explain/idea_page.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

bool isGoalResult(const PropertyResult& property) { return property.kind == ResultKind::Reach; }

/// The words of a line with columns.
std::vector<std::string> wordsIn(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// Notes without the lines of the table, which stands on its own.
std::vector<std::string> notesBesideRun(const PropertyResult& property) {
  std::vector<std::string> notes;
  for (const std::string& note : property.notes) {
    if (std::ranges::find(property.run, note) == property.run.end()) notes.push_back(note);
  }
  return notes;
}

/// A drawing with a place that others can refer to.
std::string placedSvg(const std::string& svg, const std::string& place) {
  return svg.starts_with("<svg") ? fmt::format("<svg id=\"{}\"{}", place, svg.substr(4)) : svg;
}

/// The same drawing once more.
std::string repeatedSvg(const std::string& svg, const std::string& place) {
  const std::size_t end = svg.find('>');
  return fmt::format("{}><use href=\"#{}\"/></svg>", svg.substr(0, end), place);
}

std::string verdictWord(const PropertyResult& property) {
  return fmt::format("<span class=\"word {}\">{}</span>", verdictClass(property.verdict),
                     verdictText(property.verdict, property.depth));
}

}  // namespace

std::string PageWriter::networkPlace(const ProgramRecord& record, const std::string& pou, int number) const {
  const std::string prefix = report_.programs.size() > 1 ? record.name + " " : "";
  return placeName(fmt::format("network {}{} {}", prefix, pou, number));
}

std::string PageWriter::networkLinks(const PropertyResult& property) const {
  const ProgramRecord* record = recordOf(property);
  if (record == nullptr || property.evidence.networks.empty()) return xmlText(property.networks);
  std::string text, block;
  const auto& networks = property.evidence.networks;
  for (std::size_t i = 0; i < networks.size(); ++i) {
    const auto& [pou, number] = networks[i];
    if (i > 0 && networks[i] == networks[i - 1]) continue;  // parts of one drawing
    if (pou != block) text += fmt::format("{}{} ", text.empty() ? "" : "; ", xmlText(pou));
    if (pou == block) text += ", ";
    block = pou;
    text += fmt::format("<a href=\"#{}\">{}</a>", xmlText(networkPlace(*record, pou, number)), number);
  }
  return text;
}

void PageWriter::verdicts() {
  if (report_.properties.empty()) return;
  section("Verdicts");
  out_ << "<table class=\"wide cards\"><thead><tr><th>No.</th><th>Property</th><th>Requirement</th><th>Goal</th>"
          "<th>By</th><th>Rests on networks</th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < report_.properties.size(); ++i) verdictRow(i);
  out_ << "</tbody></table>\n";
}

void PageWriter::verdictRow(std::size_t index) {
  const PropertyResult& property = report_.properties[index];
  std::string text = fmt::format("<a href=\"#{}\"><b>{}</b></a>", propertyPlaces_[index], xmlText(property.title()));
  if (!property.evidence.requirement.empty()) text += fmt::format("<br/>{}", xmlText(property.evidence.requirement));
  if (!property.statement.empty())
    text += fmt::format("<br/><code>{}</code>", namesOf(property).markedStatement(property.statement));
  const std::string verdict = verdictWord(property);
  const bool isGoal = isGoalResult(property);
  out_ << fmt::format(
      "<tr><td class=\"number\" data-label=\"No.\">{}</td><td>{}</td><td data-label=\"Requirement\">{}</td><td "
      "data-label=\"Goal\">{}</td><td data-label=\"By\">{}</td><td data-label=\"Rests on networks\">{}</td></tr>\n",
      index + 1, text, isGoal ? "" : verdict, isGoal ? verdict : "", xmlText(property.method), networkLinks(property));
}

void PageWriter::properties() {
  if (report_.properties.empty()) return;
  section("Properties and their evidence");
  for (std::size_t i = 0; i < report_.properties.size(); ++i) property(i);
}

void PageWriter::property(std::size_t index) {
  const PropertyResult& property = report_.properties[index];
  const std::string& place = propertyPlaces_[index];
  const AddressNames& names = namesOf(property);
  out_ << fmt::format(
      "<section class=\"property\" id=\"{0}\">\n<h3>{1} {2}. {3}<a class=\"anchor\" href=\"#{0}\" aria-label=\"link to "
      "this property\">#</a></h3>\n",
      place, verdictWord(property), index + 1, xmlText(property.title()));
  if (!property.evidence.requirement.empty())
    out_ << fmt::format("<p>{}</p>\n", xmlText(property.evidence.requirement));
  if (!property.statement.empty())
    out_ << fmt::format("<code class=\"statement\">{}</code>\n", names.markedStatement(property.statement));
  out_ << "<dl class=\"facts\">\n";
  const auto fact = [&](std::string_view name, const std::string& text) {
    if (!text.empty()) out_ << fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, text);
  };
  fact("Stands in", property.span && report_.sources ? xmlText(placeText(*report_.sources, *property.span)) : "");
  fact("By", property.method.empty() ? "" : fmt::format("{}, in {:.2f} s", xmlText(property.method), property.seconds));
  fact("Rests on networks", networkLinks(property));
  for (const std::string& assumption : property.assumptions) fact("Assumes", names.marked(assumption));
  if (!property.certificate.empty()) {
    fact("Certificate", xmlText(property.certificate));
    fact("its SHA-256", fmt::format("<span class=\"mono hash\">{}</span>", property.evidence.certificateSha256));
  }
  for (const std::string& note : notesBesideRun(property)) {
    if (property.certificate.empty() || !note.ends_with(property.certificate)) fact("Note", names.marked(note));
  }
  fact("Run", property.trace.empty() ? "" : xmlText(property.trace));
  out_ << "</dl>\n";
  run(property, place);
  out_ << "</section>\n";
}

void PageWriter::run(const PropertyResult& property, const std::string& place) {
  if (property.run.empty() && property.scans.empty()) return;
  out_ << fmt::format("<div class=\"run\" id=\"{}-run\" tabindex=\"0\">\n", place);
  if (!property.evidence.wave.empty())
    out_ << fmt::format("<figure class=\"wave\">{}</figure>\n", property.evidence.wave);
  runTable(property);
  if (!property.evidence.stimulus.empty()) {
    out_ << fmt::format(
        "<p class=\"quiet screen\"><a href=\"{}\" download=\"{}.csv\">This run as CSV</a>, which 'rungproof sim FILE "
        "--stimulus' "
        "repeats.</p>\n",
        dataLink("text/csv", property.evidence.stimulus), placeName(property.title()));
  }
  const bool isDrawn = !property.scans.empty() && !property.scans.front().networks.empty() &&
                       !property.scans.front().networks.front().svg.empty();
  if (isDrawn) scans(property.scans, place);
  out_ << "</div>\n";
}

void PageWriter::runTable(const PropertyResult& property) {
  if (property.run.empty()) return;
  const std::vector<std::string> heading = wordsIn(property.run.front());
  const bool hasTexts = heading.size() > 2 && (heading[2] == "events" || heading[2] == "devices");
  if (hasTexts) {  // a cell may hold several words or none
    out_ << "<pre>";
    for (const std::string& line : property.run) out_ << xmlText(line) << '\n';
    out_ << "</pre>\n";
    return;
  }
  const AddressNames& names = namesOf(property);
  out_ << "<div class=\"scroll\"><table><thead><tr>";
  for (const std::string& name : heading) {
    const std::string other = names.otherName(name);
    out_ << fmt::format("<th class=\"number\">{}{}</th>", xmlText(name),
                        other.empty() ? "" : fmt::format("<br/><span class=\"also\">{}</span>", xmlText(other)));
  }
  out_ << "</tr></thead><tbody>\n";
  for (std::size_t i = 1; i < property.run.size(); ++i) {
    out_ << "<tr>";
    std::vector<std::string> cells = wordsIn(property.run[i]);
    cells.resize(heading.size());
    for (const std::string& cell : cells) out_ << fmt::format("<td class=\"number\">{}</td>", xmlText(cell));
    out_ << "</tr>\n";
  }
  out_ << "</tbody></table></div>\n";
}

void PageWriter::scans(const std::vector<ShownScan>& scans, const std::string& place) {
  struct Drawn {
    const std::string* svg = nullptr;
    std::string place;
    std::uint64_t scan = 0;
  };
  hasScans_ = true;
  out_ << "<p class=\"steps\" hidden=\"hidden\"><button class=\"first\">first</button><button class=\"back\">scan "
          "back</button><button class=\"forward\">scan forward</button><button class=\"last\">last</button> <span "
          "class=\"where\"></span></p>\n";
  if (scans.front().scan > 1)
    out_ << fmt::format("<p class=\"quiet\">Scans 1 to {} are not drawn; diagram and table hold them.</p>\n",
                        scans.front().scan - 1);
  std::vector<Drawn> last;  // by place among the networks of a scan
  for (std::size_t i = 0; i < scans.size();) {
    std::size_t next = i + 1;  // scans that look alike stand together
    for (const auto isSame = [](const ShownNetwork&a, const ShownNetwork&b) { return a.svg == b.svg; };
         next < scans.size() && std::ranges::equal(scans[i].networks, scans[next].networks, isSame);)
      ++next;
    const ShownScan& shown = scans[i];
    out_ << (next == i + 1
                 ? fmt::format("<div class=\"scan\"><h4>scan {}, {} ms</h4>\n", shown.scan, plainNumber(shown.timeMs))
                 : fmt::format("<div class=\"scan\"><h4>scans {} to {}, {} to {} ms</h4>\n", shown.scan,
                               scans[next - 1].scan, plainNumber(shown.timeMs), plainNumber(scans[next - 1].timeMs)));
    std::map<std::uint64_t, std::string> unchanged;  // by the scan that shows them
    last.resize(std::max(last.size(), shown.networks.size()));
    for (std::size_t k = 0; k < shown.networks.size(); ++k) {
      const ShownNetwork& network = shown.networks[k];
      const std::string heading = xmlText(network.heading);
      if (last[k].svg != nullptr && *last[k].svg == network.svg) {
        const Drawn& drawn = last[k];
        out_ << fmt::format("<figure class=\"again\"><figcaption>{}</figcaption>\n{}</figure>\n", heading,
                            repeatedSvg(network.svg, drawn.place));
        std::string& names = unchanged[drawn.scan];
        names += (names.empty() ? "" : "; ") + heading;
        continue;
      }
      const std::string id = places_.of(fmt::format("{} {} scan {}", place, network.heading, shown.scan));
      last[k] = {&network.svg, id, shown.scan};
      out_ << fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", heading, placedSvg(network.svg, id));
    }
    for (const auto& [scan, names] : unchanged)
      out_ << fmt::format("<p class=\"paper quiet\">As in scan {}: {}</p>\n", scan, names);
    out_ << "</div>\n";
    i = next;
  }
}

void PageWriter::networks() {
  for (const ProgramRecord& record : report_.programs) {
    std::map<std::pair<std::string, int>, std::string> restedOn;  // links to properties
    for (std::size_t i = 0; i < report_.properties.size(); ++i) {
      const PropertyResult& property = report_.properties[i];
      if (recordOf(property) != &record) continue;
      for (const auto& network : property.evidence.networks) {
        std::string& links = restedOn[network];
        links += fmt::format("{}<a href=\"#{}\">{}</a>", links.empty() ? "" : ", ", propertyPlaces_[i],
                             xmlText(property.title()));
      }
    }
    if (restedOn.empty()) continue;
    section(report_.programs.size() > 1 ? "Networks of " + record.name : "Networks that proofs rest on");
    PlaceNames given;  // two blocks of a graphical program may have one name
    std::vector<std::pair<std::string, int>> free;
    for (const NetworkPicture& network : record.networks) {
      const auto links = restedOn.find({network.pou, network.number});
      if (links == restedOn.end()) {
        free.emplace_back(network.pou, network.number);
        continue;
      }
      out_ << fmt::format("<figure id=\"{}\"><figcaption>{}</figcaption>\n{}</figure>\n<p class=\"quiet\">{}: {}</p>\n",
                          given.of(networkPlace(record, network.pou, network.number)), xmlText(network.heading),
                          network.svg, "Proofs that rest on it", links->second);
    }
    if (!free.empty())
      out_ << fmt::format("<p>No proof rests on: {}. They can change without touching a proof.</p>\n",
                          xmlText(networkList(free)));
  }
}

void PageWriter::words() {
  std::vector<std::string> used;
  const auto add = [&](const std::string& word) {
    const Idea* idea = ideaNamed(word);
    if (idea != nullptr && std::ranges::find(used, idea->name) == used.end()) used.emplace_back(idea->name);
  };
  for (const PropertyResult& property : report_.properties) add(verdictText(property.verdict, property.depth));
  for (const PropertyResult& property : report_.properties) add(property.method);
  if (used.empty()) return;
  section("What the words mean");
  out_ << "<dl class=\"facts\">\n";
  for (const std::string& word : used)
    out_ << fmt::format("<dt>{}</dt><dd>{}</dd>\n", xmlText(word), xmlText(withManualTitles(ideaNamed(word)->text)));
  out_ << "</dl>\n";
}

}  // namespace rungproof
