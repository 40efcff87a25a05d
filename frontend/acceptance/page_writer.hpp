// Writes the sections of an HTML page from a report. The page is one file without outside references and well-formed
// XML; frontend/report/html.cpp puts the sections in order. Tested by tests/page.
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "frontend/acceptance/page_text.hpp"
#include "frontend/report.hpp"

namespace rungproof {

class PageWriter {
 public:
  PageWriter(const Report& report, std::ostream& out);

  void begin();       ///< up to the heading and what was examined
  void verdicts();    ///< the table of properties
  void properties();  ///< each with its evidence and its run
  void networks();    ///< drawings, with the proofs that rest on each
  void selfCheck();   ///< planted faults
  void findings();    ///< of the run and of lint
  void basis();       ///< coverage, assumptions, approximations
  void choices();     ///< points that the manual leaves open and some verdict depends on
  void words();       ///< what the verdicts and methods on this page mean
  void signatures();
  void end();

  /// A heading with a place of its own.
  void section(std::string_view title);
  /// Scans with their networks, inside a run with its buttons.
  void scans(const std::vector<ShownScan>& scans, const std::string& place);

 private:
  struct Place {
    std::string id;             ///< "property-stop-left"
    const AddressNames* names;  ///< of its program
  };
  const ProgramRecord* recordOf(const PropertyResult& property) const;
  const AddressNames& namesOf(const PropertyResult& property) const;
  std::string networkPlace(const ProgramRecord& record, const std::string& pou, int number) const;
  std::string networkLinks(const PropertyResult& property) const;
  void program(const ProgramRecord& record);
  void assumptions();
  bool isDependedOn(const ProgramRecord& record, const ChoiceInForce& choice) const;
  void verdictRow(std::size_t index);
  void property(std::size_t index);
  void run(const PropertyResult& property, const std::string& place);
  void runTable(const PropertyResult& property);
  void finding(const Finding& finding, PlaceNames& places);
  void findingPlace(Span span, const std::string& context);
  std::string summaryLine() const;

  const Report& report_;
  std::ostream& out_;
  PlaceNames places_;
  std::vector<std::string> propertyPlaces_;
  std::vector<AddressNames> names_;  ///< by program
  AddressNames noNames_;
  bool hasScans_ = false;  ///< there are runs to step through
};

/// "good", "bad" or "open".
std::string_view verdictClass(Outcome verdict);

}  // namespace rungproof
