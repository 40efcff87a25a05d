// Machine code for x86-64, by the assembler library; other processors run the reference engine.
#include "engine/compiled/emitter.hpp"

#if defined(__x86_64__)
#include "engine/compiled/code_pages.hpp"
#include "engine/compiled/x86_emitter.hpp"
#endif

namespace rungproof::compiled {

#if defined(__x86_64__)

namespace {

class X86Code final : public MachineCode {
 public:
  using Function [[gnu::sysv_abi]] = std::uint64_t (*)(Workspace*);  ///< on every system
  explicit X86Code(Function function) : function_(function) {}
  ~X86Code() override { codePages().release(function_); }
  X86Code(const X86Code&) = delete;
  X86Code& operator=(const X86Code&) = delete;
  bool run(Workspace& workspace) const override { return function_(&workspace) != 0; }

 private:
  Function function_;
};

}  // namespace

bool canTranslate() { return asmjit::CpuInfo::host().features().x86().hasBMI2(); }

std::unique_ptr<MachineCode> translated(const Code& code, const std::vector<bool>& isNeeded) {
  asmjit::CodeHolder holder;
  if (holder.init(codePages().environment()) != asmjit::kErrorOk) return nullptr;
  const std::optional<Layout> layout = X86Emitter(code, isNeeded, holder).emit();
  if (!layout) return nullptr;
  X86Code::Function function = nullptr;
  if (codePages().add(&function, &holder) != asmjit::kErrorOk) return nullptr;
  auto made = std::make_unique<X86Code>(function);
  made->layout = *layout;
  return made;
}

#else

bool canTranslate() { return false; }
std::unique_ptr<MachineCode> translated(const Code&, const std::vector<bool>&) { return nullptr; }

#endif

}  // namespace rungproof::compiled
