// Patterns of the property language with pictures. Each picture is a run that the prover has found on a program of a
// few lines and that the reference engine has repeated, so that no picture says what the language does not mean.
#include <fmt/format.h>

#include "analysis/proof/prover.hpp"
#include "frontend/guide/site.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project.hpp"
#include "frontend/picture/timing_diagram.hpp"
#include "frontend/property/property_reader.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

struct Pattern {
  std::string_view title;
  std::string_view meaning;
  std::string_view statement;  ///< which the program breaks, or of `reach` meets
  std::string_view networks;   ///< of the program
};

constexpr std::string_view bothOutputs = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n";
constexpr std::string_view latch = "Network 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n";

constexpr std::array patterns = {
    Pattern{"never", "In no scan do the outputs have these values.", "prove exclusive: never Q0.0 and Q0.1",
            bothOutputs},
    Pattern{"always", "In every scan the expression is true. The word may be left out.",
            "prove one follows: always Q0.0 = Q0.1", bothOutputs},
    Pattern{"implies", "In each scan in which the left side is true, the right side is true too.",
            "prove guarded: Q0.0 implies not I0.1", bothOutputs},
    Pattern{"prev", "The value at the end of the scan before; in the first scan, the value now.",
            "prove no restart: prev(not Q0.0) and Q0.0 implies I0.2", bothOutputs},
    Pattern{"rises, falls", "The value has changed since the scan before. There is no edge in the first scan.",
            "prove edge: rises(Q0.0) implies not Q0.1", bothOutputs},
    Pattern{"only after", "The left side needs the right side in the same or an earlier scan.",
            "prove order: Q0.1 only after Q0.0", bothOutputs},
    Pattern{"unless", "Once the left side is true it stays true until the right side is.",
            "prove stays: Q0.0 unless I0.2", latch},
    Pattern{"leads to, in scans", "The right side comes in the same scan or in one of the next scans.",
            "prove follows: I0.0 leads to Q0.1 within 2 scans", bothOutputs},
    Pattern{"leads to, in time", "The right side comes at a scan end that is not later than that.",
            "prove in time: I0.0 leads to Q0.1 within 50ms", bothOutputs},
    Pattern{"held", "The left side has been true at every scan end for that long.",
            "prove not for long: I0.0 held 100ms implies Q0.1", bothOutputs},
    Pattern{"once, since",
            "once(e): now or in an earlier scan. since(a, b): b in some scan, and a in every scan after it.",
            "prove remembered: once(Q0.0) implies not Q0.1", bothOutputs},
    Pattern{"reach", "Some run comes to such a scan end. The picture is such a run.",
            "reach again: Q0.0 and once(prev(Q0.0) and not Q0.0)", latch},
};

/// So that a picture shows what comes before: nothing is on at first, and both inputs not at once.
constexpr std::string_view quietStart =
    "assume quiet: first_scan implies not I0.0 and not I0.1\n"
    "assume one by one: I0.0 and I0.1 implies prev(I0.0) or prev(I0.1)\n";

/// The run as a picture; empty if there is none.
std::string pictureOf(const Pattern& pattern) {
  Program program =
      readText("sample.awl",
               fmt::format("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n{}END_ORGANIZATION_BLOCK\n", pattern.networks), {});
  PropertySet properties;
  const std::string statements = std::string(quietStart) + std::string(pattern.statement);
  const std::uint32_t file = program.sources->add("sample.prop", statements);
  readPropertyText(file, statements, 0, lookupIn(program), properties, program.findings, &program.target);
  ProverOptions options;
  options.jobs = 1;
  const ProofRun run = prove(program, properties, options);
  if (run.results.empty() || !run.results.front().witness) return {};
  const ProofResult& result = run.results.front();
  const Trace trace =
      traceOf(program, options.choices, *result.witness, signalsThatMatter(program, result), 100000, true);
  return timingDiagram(trace, "", 40);
}

}  // namespace

std::string patternSection() {
  std::string html;
  for (const Pattern& pattern : patterns) {
    html += fmt::format("<h3>{}</h3>\n<p>{}</p>\n<code class=\"statement\">{}</code>\n", xmlText(pattern.title),
                        xmlText(pattern.meaning), xmlText(pattern.statement));
    const std::string picture = pictureOf(pattern);
    if (!picture.empty())
      html += fmt::format("<figure class=\"wave\"><figcaption>{}</figcaption>{}</figure>\n",
                          pattern.statement.starts_with("reach") ? "A run that comes there" : "A run that breaks it",
                          picture);
  }
  return html;
}

}  // namespace rungproof
