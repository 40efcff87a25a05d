// Each form is the shortest text of its kind; what it means does not matter.
#include "tests/cli/large_forms.hpp"

#include <fmt/format.h>

#include "tests/graphical/plcopen_text.hpp"
#include "tests/step7/flgnet_text.hpp"

namespace rungproof::test {
namespace {

using Words = std::vector<std::string>;

/// One of 32,000 bits: "12.3".
std::string place(std::size_t i) { return fmt::format("{}.{}", i / 8 % 4000, i % 8); }
std::string onePlace(const char* format, std::size_t i) { return fmt::format(fmt::runtime(format), place(i)); }

Words listOf200(const TemporaryFolder& folder, const std::string& rung) {
  return {folder.file("p.awl", "Network 1\nLD I0.0\n" + rung + "= Q0.0\n")};
}
Words listOf300(const TemporaryFolder& folder, const std::string& statements) {
  return {folder.file("p.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n A I 0.0;\n" + statements +
                                   " = Q 0.0;\nEND_ORGANIZATION_BLOCK\n")};
}
Words structuredText(const TemporaryFolder& folder, const std::string& body) {
  return {folder.file("p.st", "PROGRAM P\nVAR\n  a, b, q : BOOL;\n  n : INT;\nEND_VAR\n" + body + "END_PROGRAM\n")};
}
Words sclText(const TemporaryFolder& folder, const std::string& body) {
  return {folder.file("p.scl",
                      "FUNCTION_BLOCK FB 1\nVAR\n  a, b, q : BOOL;\n  n : INT;\nEND_VAR\nBEGIN\n" + body +
                          "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1 FB 1\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
                          "VAR_TEMP\n x : ARRAY[1..20] OF BYTE;\nEND_VAR\nBEGIN\n FB1.DB1();\n"
                          "END_ORGANIZATION_BLOCK\n")};
}
Words instructionList(const TemporaryFolder& folder, const std::string& body) {
  return {folder.file("p.il", "PROGRAM P\nVAR\n  a, b, q : BOOL;\nEND_VAR\nLD a\n" + body + "ST q\nEND_PROGRAM\n")};
}
Words drawing(const TemporaryFolder& folder, const std::string& language, const std::string& elements) {
  return {folder.file("p.xml", plcopen({"a:BOOL", "q:BOOL"}, language, elements))};
}

std::string idText(std::size_t id) { return std::to_string(id); }
std::string contact(std::size_t id, std::size_t from) {
  return contactElement(static_cast<int>(id), {idText(from)}, "a");
}
std::string ifs(std::size_t depth) { return inARow(depth, "IF a THEN\n") + "q := b;\n" + inARow(depth, "END_IF;\n"); }
std::string elsifs(std::size_t count) {
  return "IF n = 0 THEN q := a;\n" +
         inARow(count, [](std::size_t i) { return fmt::format("ELSIF n = {} THEN q := b;\n", i % 30000); }) +
         "END_IF;\n";
}
std::string labels(std::size_t count) {
  return "CASE n OF\n" + inARow(count, [](std::size_t i) { return fmt::format("{}: q := a;\n", i); }) + "END_CASE;\n";
}

/// A rung of SimaticML: `count` contacts, joined as `joins` says, and a coil.
Words drawnContacts(const TemporaryFolder& folder, std::size_t count, bool isParallel) {
  test7::DrawnNet net;
  std::vector<int> contacts;
  std::vector<test7::DrawnNet::End> starts;
  for (std::size_t i = 0; i < count; ++i) {
    contacts.push_back(net.part("Contact"));
    net.in("I" + place(i % 1000), contacts.back(), "operand");
    if (isParallel || i == 0) starts.emplace_back(contacts.back(), "in");
    if (!isParallel && i > 0) net.flow({contacts[i - 1], "out"}, {{contacts[i], "in"}});
  }
  const int coil = net.part("Coil");
  net.in("Q0.0", coil, "operand");
  net.rail(starts);
  if (isParallel) {
    const int join = net.part("O", test7::typed("Card", std::to_string(count)));
    for (std::size_t i = 0; i < count; ++i) net.flow({contacts[i], "out"}, {{join, "in" + std::to_string(i + 1)}});
    net.flow({join, "out"}, {{coil, "in"}});
  } else {
    net.flow({contacts.back(), "out"}, {{coil, "in"}});
  }
  return {folder.file("p.xml",
                      test7::drawnDocument(test7::drawnBlock("OB", "Main", 1, "", test7::unit(net.text(), "LAD"))))};
}

std::string smallProgram(const TemporaryFolder& folder) {
  return folder.file("small.awl", "Network 1\nLD I0.0\n= Q0.0\n");
}
Words withProperties(const TemporaryFolder& folder, const std::string& text) {
  return {"prove", "--isolated", "--timeout", "2s", "--props", folder.file("p.prop", text), smallProgram(folder)};
}
Words withSettings(const TemporaryFolder& folder, const std::string& text) {
  return {"lint", "--config", folder.file("c.toml", text), smallProgram(folder)};
}
Words withBaseline(const TemporaryFolder& folder, const std::string& text) {
  return {"lint", "--isolated", "--baseline", folder.file("b.json", text), smallProgram(folder)};
}
std::string rows(const std::string& heading, std::size_t count) {
  return heading + inARow(count, [](std::size_t i) { return fmt::format("{},{}\n", i + 1, i % 2); });
}
std::string joinedBy(const char* word, std::size_t count) {
  return "I0.0" + inARow(count, [&](std::size_t) { return std::string(word) + "I0.0"; });
}

}  // namespace

const std::vector<LargeForm>& largePrograms() {
  using Folder = TemporaryFolder;
  static const std::vector<LargeForm> forms = {
      {"contacts in series",
       [](const Folder& f, std::size_t n) {
         return listOf200(f, inARow(n, [](std::size_t i) { return onePlace("A V{}\n", i); }));
       }},
      {"contacts in parallel",
       [](const Folder& f, std::size_t n) {
         return listOf200(f, inARow(n, [](std::size_t i) { return onePlace("O V{}\n", i); }));
       }},
      {"nested loads",
       [](const Folder& f, std::size_t n) { return listOf200(f, inARow(n, "LD I0.1\n") + inARow(n, "ALD\n")); }},
      {"parallel pairs in series",
       [](const Folder& f, std::size_t n) {
         return listOf200(f, inARow(n, [](std::size_t i) { return onePlace("LD V{}\nO I0.1\nALD\n", i); }));
       }},
      {"branches in branches",
       [](const Folder& f, std::size_t n) { return listOf200(f, inARow(n, "LPS\n") + inARow(n, "LPP\n")); }},
      {"outputs of one rung",
       [](const Folder& f, std::size_t n) {
         return listOf200(f, inARow(n, [](std::size_t i) { return onePlace("= V{}\n", i); }));
       }},
      {"networks",
       [](const Folder& f, std::size_t n) {
         return Words{f.file("p.awl", inARow(n, [](std::size_t i) {
                               return fmt::format("Network {}\nLD V{}\n= M{}.{}\n", i + 1, place(i), i / 8 % 30, i % 8);
                             }))};
       }},
      {"loops in loops",
       [](const Folder& f, std::size_t n) {
         return Words{f.file("p.awl", inARow(n, "Network 1\nLD I0.0\nFOR VW0, 1, 2\n") + inARow(n, "Network 1\nNEXT\n"))};
       }},
      {"scans in a row",
       [](const Folder& f, std::size_t n) {
         return listOf300(f, inARow(n, [](std::size_t i) { return onePlace(" A M {};\n", i % 16000); }));
       }},
      {"alternatives in a row",
       [](const Folder& f, std::size_t n) {
         return listOf300(f, inARow(n, [](std::size_t i) { return onePlace(" O M {};\n", i % 16000); }));
       }},
      {"parentheses in parentheses",
       [](const Folder& f, std::size_t n) { return listOf300(f, inARow(n, " A(;\n") + " A I 0.1;\n" + inARow(n, " );\n")); }},
      {"zones in zones",
       [](const Folder& f, std::size_t n) { return listOf300(f, inARow(n, " MCR(;\n") + inARow(n, " )MCR;\n")); }},
      {"sums of words",
       [](const Folder& f, std::size_t n) { return listOf300(f, " L MW 0;\n" + inARow(n, " L MW 2;\n +I;\n") + " T MW 4;\n"); }},
      {"networks of an OB",
       [](const Folder& f, std::size_t n) {
         return listOf300(f, inARow(n, [](std::size_t i) { return onePlace(" = M {};\nNETWORK\n A I 0.0;\n", i % 16000); }));
       }},
      {"blocks",
       [](const Folder& f, std::size_t n) {
         return Words{f.file("p.awl", inARow(n, [](std::size_t i) {
                               return fmt::format("FUNCTION FC {} : VOID\nBEGIN\nNETWORK\n A I 0.0;\n = Q 0.0;\n"
                                                  "END_FUNCTION\n",
                                                  i + 1);
                             }) + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FC 1;\nEND_ORGANIZATION_BLOCK\n")};
       }},
      {"structures in structures",
       [](const Folder& f, std::size_t n) {
         return Words{f.file("p.awl", "DATA_BLOCK DB 1\nSTRUCT\n" + inARow(n, " a : STRUCT\n") + " b : BOOL;\n" +
                                          inARow(n, " END_STRUCT;\n") + "END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n")};
       }},
      {"SCL, a row of AND", [](const Folder& f, std::size_t n) { return sclText(f, "q := a" + inARow(n, " AND b") + ";\n"); }},
      {"SCL, nested parentheses",
       [](const Folder& f, std::size_t n) { return sclText(f, "q := " + std::string(n, '(') + "a" + std::string(n, ')') + ";\n"); }},
      {"SCL, IF in IF", [](const Folder& f, std::size_t n) { return sclText(f, ifs(n)); }},
      {"SCL, ELSIF", [](const Folder& f, std::size_t n) { return sclText(f, elsifs(n)); }},
      {"SCL, CASE", [](const Folder& f, std::size_t n) { return sclText(f, labels(n)); }},
      {"SCL, assignments", [](const Folder& f, std::size_t n) { return sclText(f, inARow(n, "q := a;\n")); }},
      {"ST, a row of OR", [](const Folder& f, std::size_t n) { return structuredText(f, "q := a" + inARow(n, " OR b") + ";\n"); }},
      {"ST, NOT of NOT", [](const Folder& f, std::size_t n) { return structuredText(f, "q := " + inARow(n, "NOT ") + "a;\n"); }},
      {"ST, IF in IF", [](const Folder& f, std::size_t n) { return structuredText(f, ifs(n)); }},
      {"ST, ELSIF", [](const Folder& f, std::size_t n) { return structuredText(f, elsifs(n)); }},
      {"ST, CASE", [](const Folder& f, std::size_t n) { return structuredText(f, labels(n)); }},
      {"ST, assignments", [](const Folder& f, std::size_t n) { return structuredText(f, inARow(n, "q := a;\n")); }},
      {"IL, a row of AND", [](const Folder& f, std::size_t n) { return instructionList(f, inARow(n, "AND b\n")); }},
      {"IL, a row of OR", [](const Folder& f, std::size_t n) { return instructionList(f, inARow(n, "OR b\n")); }},
      {"IL, nested parentheses",
       [](const Folder& f, std::size_t n) { return instructionList(f, inARow(n, "AND( b\n") + inARow(n, ")\n")); }},
      {"PLCopen, contacts in series",
       [](const Folder& f, std::size_t n) {
         return drawing(f, "LD", railElement(1) + inARow(n, [](std::size_t i) { return contact(i + 2, i + 1); }) +
                                     coilElement(static_cast<int>(n) + 2, {idText(n + 1)}, "q"));
       }},
      {"PLCopen, contacts in parallel",
       [](const Folder& f, std::size_t n) {
         std::vector<std::string> all;
         for (std::size_t i = 0; i < n; ++i) all.push_back(idText(i + 2));
         return drawing(f, "LD", railElement(1) + inARow(n, [](std::size_t i) { return contact(i + 2, 1); }) +
                                     coilElement(static_cast<int>(n) + 2, all, "q"));
       }},
      {"PLCopen, rungs",
       [](const Folder& f, std::size_t n) {
         return drawing(f, "LD", railElement(1) + inARow(n, [](std::size_t i) {
                                   return contact(2 * i + 2, 1) +
                                          coilElement(static_cast<int>(2 * i) + 3, {idText(2 * i + 2)}, "q");
                                 }));
       }},
      {"PLCopen, boxes in a row",
       [](const Folder& f, std::size_t n) {
         return drawing(f, "FBD", inElement(1, "a") + inARow(n, [](std::size_t i) {
                                    return blockElement(static_cast<int>(i) + 2, "AND", "",
                                                        {{"IN1", {idText(i + 1)}}, {"IN2", {"1"}}}, {"OUT"});
                                  }) + outElement(static_cast<int>(n) + 2, {idText(n + 1)}, "q"));
       }},
      {"PLCopen, elements in elements",
       [](const Folder& f, std::size_t n) { return drawing(f, "LD", inARow(n, "<x>") + inARow(n, "</x>")); }},
      {"SimaticML, contacts in series", [](const Folder& f, std::size_t n) { return drawnContacts(f, n, false); }},
      {"SimaticML, contacts in parallel", [](const Folder& f, std::size_t n) { return drawnContacts(f, n, true); }},
      {"SimaticML, elements in elements",
       [](const Folder& f, std::size_t n) {
         return Words{f.file("p.xml", "<?xml version=\"1.0\"?>\n<Document>" + inARow(n, "<x>") + inARow(n, "</x>") +
                                          "</Document>\n")};
       }},
      {"a symbol table of STEP 7",
       [](const Folder& f, std::size_t n) {
         return Words{f.file("p.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n A \"s1\";\n = Q 0.0;\n"
                                      "END_ORGANIZATION_BLOCK\n"),
                      "--symbols", f.file("s.asc", inARow(n, [](std::size_t i) {
                                            return fmt::format("126,{:<24}M {:>9} BOOL      {:<80}\r\n",
                                                               fmt::format("s{}", i), place(i), "");
                                          }))};
       }},
      {"a symbol table with commas",
       [](const Folder& f, std::size_t n) {
         return Words{f.file("p.awl", "Network 1\nLD s1\n= Q0.0\n"), "--symbols",
                      f.file("s.csv", "Symbol,Address,Comment\n" + inARow(n, [](std::size_t i) {
                                        return fmt::format("s{},V{},c\n", i, place(i));
                                      }))};
       }},
  };
  return forms;
}

const std::vector<LargeForm>& largeInputs() {
  using Folder = TemporaryFolder;
  static const std::vector<LargeForm> forms = {
      {"properties, one a line",
       [](const Folder& f, std::size_t n) {
         return withProperties(
             f, inARow(n, [](std::size_t i) { return fmt::format("prove p{}: not Q0.0 or I0.0\n", i); }));
       }},
      {"a property, and",
       [](const Folder& f, std::size_t n) { return withProperties(f, "prove p: " + joinedBy(" and ", n) + "\n"); }},
      {"a property, or",
       [](const Folder& f, std::size_t n) { return withProperties(f, "prove p: " + joinedBy(" or ", n) + "\n"); }},
      {"a property, implies",
       [](const Folder& f, std::size_t n) { return withProperties(f, "prove p: " + joinedBy(" implies ", n) + "\n"); }},
      {"a property, prev of prev",
       [](const Folder& f, std::size_t n) {
         return withProperties(f, "prove p: " + inARow(n, "prev(") + "I0.0" + std::string(n, ')') + "\n");
       }},
      {"assumptions",
       [](const Folder& f, std::size_t n) {
         return withProperties(f, inARow(n, [](std::size_t i) {
                                    return fmt::format("assume a{}: I0.0 or I0.1\n", i);
                                  }) + "prove p: Q0.0 implies I0.0\n");
       }},
      {"rows of a stimulus",
       [](const Folder& f, std::size_t n) {
         return Words{"sim", "--isolated", "--stimulus", f.file("s.csv", rows("scan,I0.0\n", n)), smallProgram(f)};
       }},
      {"columns of a stimulus",
       [](const Folder& f, std::size_t n) {
         return Words{"sim", "--isolated", "--stimulus",
                      f.file("s.csv", "scan" + inARow(n, [](std::size_t i) { return onePlace(",V{}", i); }) + "\n1" +
                                          inARow(n, ",1") + "\n"),
                      smallProgram(f)};
       }},
      {"rows of an expected trace",
       [](const Folder& f, std::size_t n) {
         return Words{"sim",          "--isolated",
                      "--stimulus",   f.file("s.csv", rows("scan,I0.0\n", n)),
                      "--expect",     f.file("e.csv", rows("scan,Q0.0\n", n)),
                      smallProgram(f)};
       }},
      {"rows of a test table",
       [](const Folder& f, std::size_t n) {
         return Words{"test", "--isolated", "--table",
                      f.file("t.csv", "test,wait,set I0.0,expect Q0.0\n" + inARow(n, "t,1 scan,1,1\n")),
                      smallProgram(f)};
       }},
      {"tests of a test table",
       [](const Folder& f, std::size_t n) {
         return Words{"test", "--isolated", "--table",
                      f.file("t.csv", "test,wait,set I0.0,expect Q0.0\n" +
                                          inARow(n, [](std::size_t i) { return fmt::format("t{},1 scan,1,1\n", i); })),
                      smallProgram(f)};
       }},
      {"a traced run",
       [](const Folder& f, std::size_t n) {
         return Words{"test", "--isolated", "--record", f.file("s.csv", rows("scan,I0.0\n", n)), smallProgram(f)};
       }},
      {"settings, rules in a list",
       [](const Folder& f, std::size_t n) { return withSettings(f, "select = [" + inARow(n, "\"ADR001\",") + "]\n"); }},
      {"settings, keys",
       [](const Folder& f, std::size_t n) {
         return withSettings(f, inARow(n, [](std::size_t i) { return fmt::format("k{} = 1\n", i); }));
       }},
      {"settings, tables in tables",
       [](const Folder& f, std::size_t n) {
         return withSettings(f, "a = " + inARow(n, "{b = ") + "1" + std::string(n, '}') + "\n");
       }},
      {"settings, lists in lists",
       [](const Folder& f, std::size_t n) {
         return withSettings(f, "a = " + std::string(n, '[') + std::string(n, ']') + "\n");
       }},
      {"a baseline, keys",
       [](const Folder& f, std::size_t n) {
         return withBaseline(f,
                             "{" + inARow(n, [](std::size_t i) { return fmt::format("\"k{}\":1,", i); }) + "\"z\":1}");
       }},
      {"a baseline, lists in lists",
       [](const Folder& f, std::size_t n) { return withBaseline(f, std::string(n, '[') + std::string(n, ']')); }},
  };
  return forms;
}

}  // namespace rungproof::test
