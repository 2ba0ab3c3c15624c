// The program: picks the subcommand and turns what it throws into a message and an exit code.

#include <fmt/format.h>

#include <exception>
#include <new>
#include <system_error>
#include <variant>

#include "app/cli/options.h"
#include "app/run/standard_streams.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

int run(const Message& message) {
  fmt::print("{}", message.text);
  return int(ExitCode::done);
}
int run(const ViewOptions& options) { return runView(options); }
int run(const RenderOptions& options) { return runRender(options); }
int run(const InfoOptions& options) { return runInfo(options); }
int run(const DevicesOptions& options) { return runDevices(options); }
int run(const CompareOptions& options) { return runCompare(options); }
int run(const BenchOptions& options) { return runBench(options); }
int run(const StressOptions& options) { return runStress(options); }
int run(const ConvergeOptions& options) { return runConverge(options); }

int fail(const char* message, ExitCode code) {
  printError("ropelight: {}", message);
  return int(code);
}

int runGuarded(int argc, char** argv) {
  try {
    return std::visit([](const auto& options) { return run(options); }, parseCommandLine(argc, argv));
  } catch (const Error& error) {
    return fail(error.what(), error.code());
  } catch (const std::bad_alloc&) {
    return fail("out of memory; lower --width, --height or --photons", ExitCode::outOfMemory);
  } catch (const std::system_error& error) {
    if (!standardOutputFailed()) return fail(error.what(), ExitCode::internal);
    rememberOutputError(error.code().value());
    return int(ExitCode::internal);
  } catch (const std::exception& error) {
    return fail(error.what(), ExitCode::internal);
  } catch (...) {
    return fail("an unknown failure", ExitCode::internal);
  }
}

}  // namespace
}  // namespace ropelight

int main(int argc, char** argv) {
  using namespace ropelight;
  prepareStandardStreams();
  return finishStandardOutput(runGuarded(argc, argv));
}
