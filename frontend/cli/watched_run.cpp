// The request is the arguments, each with a 0 behind it.
#include "frontend/cli/watched_run.hpp"

#include "frontend/cli/standard_streams.hpp"
#include "frontend/files/disk_file.hpp"

namespace rungproof {

namespace {

const Streams* watchedStreams = nullptr;  ///< of the process that was asked to watch

int runWatched(const std::string& request, const GiveBytes& give) {
  std::vector<std::string> arguments;
  for (std::size_t begin = 0; begin < request.size();) {
    const std::size_t end = request.find('\0', begin);
    arguments.push_back(request.substr(begin, end - begin));
    begin = end + 1;
  }
  const Streams streams = watchedStreams != nullptr ? *watchedStreams : standardStreams();
  const int exit = runProgram(arguments, streams);
  streams.out.flush();
  streams.err.flush();
  std::string names;
  for (const std::string& name : inputNames()) names += name + '\n';
  give(names);
  return exit;
}

}  // namespace

constinit const Worker watchedRunWorker = {"run", runWatched};

std::string watchedRunRequest(std::string_view command, const std::vector<std::string>& arguments,
                              const Streams& streams) {
  watchedStreams = &streams;
  std::string request = std::string(command) + '\0';
  for (const std::string& argument : arguments) request += argument + '\0';
  return request;
}

}  // namespace rungproof
