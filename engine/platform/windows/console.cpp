// Streams without translation, a console that reads UTF-8 and shows colours, arguments in Unicode.
#include "engine/platform/console.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// behind windows.h
#include <shellapi.h>

#include "engine/platform/windows/names.hpp"

namespace rungproof {

namespace {

HANDLE handleOf(Stream stream) {
  constexpr DWORD names[] = {STD_INPUT_HANDLE, STD_OUTPUT_HANDLE, STD_ERROR_HANDLE};
  return ::GetStdHandle(names[static_cast<int>(stream)]);
}

/// "plant\\" is the folder "plant": the C runtime finds no folder whose name ends so.
std::string withoutLastStroke(const std::string& text, const std::wstring& argument) {
  constexpr std::size_t drive = 3;  // "C:\\" stays
  if (text.size() <= drive || text.starts_with('-') || text.find_last_of("/\\") != text.size() - 1) return text;
  const DWORD attributes = ::GetFileAttributesW(argument.c_str());
  const bool isFolder = attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  return isFolder ? text.substr(0, text.size() - 1) : text;
}

/// What the shell leaves to the program: "*.awl". A pattern that no file fits stays as it is, and so does what belongs
/// to an option.
void addExpanded(std::vector<std::string>& arguments, const std::wstring& argument) {
  const std::string text = narrowName(argument);
  const bool isOfOption =
      !arguments.empty() && arguments.back().starts_with("--") && arguments.back().find('=') == std::string::npos;
  const bool isPattern = !text.starts_with('-') && text.find_first_of("*?") != std::string::npos && !isOfOption;
  WIN32_FIND_DATAW found{};
  const HANDLE search = isPattern ? ::FindFirstFileW(argument.c_str(), &found) : INVALID_HANDLE_VALUE;
  if (search == INVALID_HANDLE_VALUE) {
    arguments.push_back(withoutLastStroke(text, argument));
    return;
  }
  const std::size_t folderEnd = text.find_last_of("/\\:");
  const std::string folder = folderEnd == std::string::npos ? std::string() : text.substr(0, folderEnd + 1);
  do {
    const std::string name = narrowName(found.cFileName);
    if (name != "." && name != "..") arguments.push_back(folder + name);
  } while (::FindNextFileW(search, &found) != 0);
  ::FindClose(search);
}

/// The console as it was is given back at the end.
class ConsoleInUtf8 {
 public:
  ConsoleInUtf8() : output_(::GetConsoleOutputCP()) {
    if (output_ != 0) ::SetConsoleOutputCP(CP_UTF8);
  }
  ~ConsoleInUtf8() {
    if (output_ != 0) ::SetConsoleOutputCP(output_);
  }
  ConsoleInUtf8(const ConsoleInUtf8&) = delete;
  ConsoleInUtf8& operator=(const ConsoleInUtf8&) = delete;

 private:
  UINT output_;
};

}  // namespace

std::vector<std::string> programArguments(int /*argc*/, char** /*argv*/) {
  int count = 0;
  wchar_t** const wide = ::CommandLineToArgvW(::GetCommandLineW(), &count);
  std::vector<std::string> arguments;
  for (int i = 1; i < count; ++i) addExpanded(arguments, wide[i]);
  ::LocalFree(wide);
  return arguments;
}

bool isTerminal(Stream stream) {
  DWORD mode = 0;
  const HANDLE handle = handleOf(stream);
  if (::GetConsoleMode(handle, &mode) == 0) return false;
  if (stream == Stream::In) return true;
  // Consoles before Windows 10 show no colours.
  return ::SetConsoleMode(handle, mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

int runProgramIn(const std::function<int()>& work) {
  for (const Stream stream : {Stream::In, Stream::Out, Stream::Err}) ::_setmode(static_cast<int>(stream), _O_BINARY);
  ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX);  // no windows
  const ConsoleInUtf8 console;
  return work();  // the linker gives every thread its stack
}

}  // namespace rungproof
