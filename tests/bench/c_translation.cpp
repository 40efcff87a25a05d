// Writes C.
#include "tests/bench/c_translation.hpp"

#include <fmt/format.h>

#include <vector>

#include "ir/check.hpp"

namespace rungproof::bench {

namespace {

class CWriter {
 public:
  explicit CWriter(const Program& program) : program_(program) {}

  std::string text() {
    std::string all =
        "#include <string.h>\n"
        "typedef short s16; typedef int s32; typedef unsigned char u8;\n"
        "static u8 *I, *Q, *M, *V; static s32* AC;\n"
        "static const u8 SM00 = 1;\n"
        "#define W(p) (*(s16*)(p))\n#define D(p) (*(s32*)(p))\n";
    for (const Pou& pou : program_.pous) {
      if (pou.kind == PouKind::Subroutine) all += fmt::format("static void sbr{}({});\n", pou.number, parameters(pou));
    }
    for (const Pou& pou : program_.pous) all += block(pou);
    return all + "void scan(u8* i, u8* q, u8* m, u8* v, s32* ac) { I = i; Q = q; M = m; V = v; AC = ac; program(); }\n";
  }

 private:
  static std::string parameters(const Pou& pou) {
    std::string list;
    for (const LocalVariable& local : pou.locals) {
      const std::string type = local.address.width == Width::Bit ? "u8" : "s16";
      if (!list.empty()) list += ", ";
      list += type + (local.section == VarSection::Input ? " " : "* ") + fmt::format("p{}", &local - pou.locals.data());
    }
    return list;
  }

  std::string block(const Pou& pou) {
    body_.clear();
    stack_.clear();
    next_ = 0;
    const bool isMain = pou.kind == PouKind::Main;
    std::string copyIn, copyOut;
    for (const LocalVariable& local : pou.locals) {
      const std::string name = fmt::format("p{}", &local - pou.locals.data());
      if (local.section == VarSection::Input) copyIn += place(local.address) + " = " + name + ";\n";
      if (local.section == VarSection::Output) copyOut += "*" + name + " = " + place(local.address) + ";\n";
    }
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) write(instruction);
    }
    const std::string head =
        isMain ? "static void program(void)" : fmt::format("static void sbr{}({})", pou.number, parameters(pou));
    return head + " {\nu8 LB[512] = {0}; u8 L[64] = {0}; (void)LB; (void)L;\n" + copyIn + body_ + copyOut + "}\n";
  }

  static std::string place(const Operand& o) {
    const std::uint32_t bit = o.offset * 8 + o.bit;
    if (o.kind == OperandKind::Indirect) return fmt::format("W(V + (AC[{}] - 0x08000000))", o.offset);
    if (o.area == Area::AC) return fmt::format("AC[{}]", o.offset);
    if (o.area == Area::SM) return "SM00";
    const char* area = o.area == Area::I   ? "I"
                       : o.area == Area::Q ? "Q"
                       : o.area == Area::M ? "M"
                       : o.area == Area::L ? "L"
                                           : "V";
    if (o.width == Width::Bit) return fmt::format("{}{}[{}]", area, o.area == Area::L ? "B" : "", bit);
    return fmt::format("{}({} + {})", o.width == Width::DWord ? "D" : "W", area, o.offset);
  }
  static std::string value(const Operand& o) {
    if (o.kind == OperandKind::Constant) return fmt::format("{}", o.value);
    if (o.kind == OperandKind::Address) return fmt::format("(0x08000000 + {})", o.offset);
    return o.kind == OperandKind::Direct && o.area == Area::AC ? "(s16)" + place(o) : place(o);
  }
  static std::string assigned(const Operand& o, const std::string& value) {
    if (o.kind == OperandKind::Direct && o.area == Area::AC)
      return fmt::format("{0} = ({0} & ~0xFFFF) | (({1}) & 0xFFFF);", place(o), value);
    return fmt::format("{} = {};", place(o), value);
  }

  void push(const std::string& expression) {
    stack_.push_back(fmt::format("t{}", next_++));
    body_ += fmt::format("const u8 {} = {};\n", stack_.back(), expression);
  }
  std::string pop() {
    std::string top = "0";
    if (!stack_.empty()) {
      top = stack_.back();
      stack_.pop_back();
    }
    return top;
  }
  std::string top() const { return stack_.empty() ? "0" : stack_.back(); }
  void join(const std::string& op, const std::string& other) {
    const std::string first = pop();
    push(first + op + other);
  }

  void write(const Instruction& instruction) {
    const std::string_view name = instruction.desc->stl;
    const auto& o = instruction.operands;
    const auto when = [&](const std::string& text) { body_ += "if (" + top() + ") { " + text + " }\n"; };
    const auto checked = [&](const std::string& op) {
      when(fmt::format("const s32 r = {} {} {}; if ((s16)r == r) {}", value(o[1]), op, value(o[0]),
                       assigned(o[1], "(s16)r")));
    };
    if (name == "LD") return push(value(o[0]));
    if (name == "LDN") return push("!" + value(o[0]));
    if (name == "A") return join(" & ", value(o[0]));
    if (name == "AN") return join(" & !", value(o[0]));
    if (name == "O") return join(" | ", value(o[0]));
    if (name == "ON") return join(" | !", value(o[0]));
    if (name == "ALD") return join(" & ", pop());
    if (name == "OLD") return join(" | ", pop());
    if (name == "LDW>=") return push(value(o[0]) + " >= " + value(o[1]));
    if (name == "LDW>") return push(value(o[0]) + " > " + value(o[1]));
    if (name == "=") return void(body_ += place(o[0]) + " = " + top() + ";\n");
    if (name == "S") return when(place(o[0]) + " = 1;");
    if (name == "R") return when(place(o[0]) + " = 0;");
    if (name == "MOVW") return when(assigned(o[1], value(o[0])));
    if (name == "MOVD") return when(place(o[1]) + " = " + value(o[0]) + ";");
    if (name == "+I") return checked("+");
    if (name == "-I") return checked("-");
    if (name == "+D")
      return when(fmt::format("s32 r; if (!__builtin_add_overflow({0}, {1}, &r)) {0} = r;", place(o[1]), value(o[0])));
    if (name == "ANDW") return when(assigned(o[1], value(o[0]) + " & " + value(o[1])));
    if (name == "INCW") return when(assigned(o[0], "(s16)(" + value(o[0]) + " + 1)"));
    if (name == "FOR") {
      loops_.push_back(value(o[0]));
      body_ += fmt::format("if ({0}) {1} = {2}; if ({0} && {1} <= {3}) do {{\n", top(), value(o[0]), value(o[1]),
                           value(o[2]));
      ends_.push_back(value(o[2]));
      return;
    }
    if (name == "NEXT") {
      body_ += fmt::format("{0} = (s16)({0} + 1); }} while ({0} <= {1});\n", loops_.back(), ends_.back());
      loops_.pop_back();
      ends_.pop_back();
      return;
    }
    CHECK(name == "CALL", "an instruction that the translation does not know");
    const Pou* callee = program_.subroutine(static_cast<int>(o[0].value));
    std::string list;
    for (std::size_t i = 1; i < o.size(); ++i) {
      if (i > 1) list += ", ";
      list += callee->locals[i - 1].section == VarSection::Input ? value(o[i]) : "&" + place(o[i]);
    }
    when(fmt::format("sbr{}({});", callee->number, list));
  }

  const Program& program_;
  std::string body_;
  std::vector<std::string> stack_, loops_, ends_;
  int next_ = 0;
};

}  // namespace

std::string inC(const Program& program) { return CWriter(program).text(); }

}  // namespace rungproof::bench
