// Files on disk, read and written in one place: what has been read as input is remembered, so that no output takes its
// place, and an output neither destroys what its name stands for (a device, a pipe, a link) nor is ever seen half
// written. Tested by tests/cli/output_file_test.cpp.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/files/encoding.hpp"
#include "frontend/files/failure.hpp"

namespace rungproof {

/// The longest input that is read: spans count bytes in 32 bits, and U+FFFD may triple a text. A program or a table is
/// kept in several forms at once, a trace is not.
inline constexpr std::size_t longestInput = std::size_t{1} << 30;
inline constexpr std::size_t longestProgram = std::size_t{1} << 27;

struct InputBytes {
  std::optional<std::string> bytes;
  std::string problem{};  ///< why there are none: "it has more than 128 MiB"
};
/// The bytes of a file, a pipe or, as "-", of standard input, which counts as input from now on. Whatever can be read
/// only once is read once in a run and kept; no more than `most` bytes are taken from it.
InputBytes inputBytes(const std::string& name, std::size_t most = longestInput);
/// The same for who has nothing to say about the reason.
std::optional<std::string> bytesOfInput(const std::string& name);
/// The same for a configuration, which confineInputs() does not concern.
std::optional<std::string> bytesOfConfiguration(const std::string& name);
/// All of standard input; it is read once in a run.
const std::string& standardInput();
/// From now on only what lies below this folder behind all links is read; an empty name lifts that.
void confineInputs(const std::filesystem::path& folder);
/// Why a file or folder must not be read; nothing if it may be.
std::optional<std::string> confinedAgainst(const std::string& name);
/// What standardInput() gives from now on.
void replaceStandardInput(std::string text);
/// Notes a file that is read in another way.
void noteInput(const std::string& name);
/// Another run of the program begins: nothing has been read.
void forgetInputs();
/// Everything that has been asked for as input, also what could not be read.
std::vector<std::string> inputNames();

/// Texts that stand for files while an editor or an assistant holds them: UTF-8, whatever lies on the disk under that
/// name. `encoding`: of the file on the disk, in which the controller gets its characters.
struct HeldText {
  std::string text;
  TextEncoding encoding = TextEncoding::Utf8;
};
void holdText(const std::string& name, HeldText text);
void releaseText(const std::string& name);
bool holdsTexts();
/// nullptr: the file on the disk counts. Valid until that name is held anew or released.
const HeldText* heldText(const std::string& name);

/// Where a name leads to behind all symbolic links, also if nothing stands there yet; empty if the links run in a
/// circle.
std::filesystem::path behindLinks(const std::filesystem::path& name);

/// The name of a file from the root of its project, or as given if it lies outside or `root` is empty: one file has one
/// name, whatever the current folder and the spelling of the path are.
std::string nameInProject(const std::string& name, const std::filesystem::path& root);
/// Whether a name fits a pattern with * (also across folders), ? and [...]; a pattern that ends in / means all below.
bool fitsPattern(const std::string& name, const std::string& pattern);
/// Where that file is.
std::string pathInProject(const std::string& name, const std::filesystem::path& root);

enum class InputFile : bool { Refuse, Replace };  ///< Replace: the input itself is to be changed

/// Removes what an interrupted run left beside the file `target` (or, without a name, in the whole folder `target`):
/// parts whose writer is gone.
void removeStaleParts(const std::filesystem::path& folder, std::string_view name);

/// Writes the whole text, or says why not. A regular file is replaced as a whole by one of the same mode and owner, at
/// the place that links lead to; anything else (device, pipe, standard output by its name) is written to directly. What
/// no mode bit permits to write is refused, whoever asks.
std::optional<Failure> writeOutputFile(const std::string& name, std::string_view text,
                                       InputFile input = InputFile::Refuse);

/// Takes the next piece of a text; false: it cannot be written, no other piece is wanted.
using TakePiece = std::function<bool(std::string_view piece)>;
/// Gives a text piece by piece. False: it gives up; a regular file is left as it was.
using PiecewiseText = std::function<bool(const TakePiece&)>;
/// The same for a text that is never whole in memory. It is asked for once everything that can be refused has been;
/// where it gives up, the failure has no message.
std::optional<Failure> writeOutputFile(const std::string& name, const PiecewiseText& text,
                                       InputFile input = InputFile::Refuse);

}  // namespace rungproof
