// The program: picks the subcommand and turns what it throws into a message and an exit code.

#include <fmt/format.h>

#include <exception>
#include <new>
#include <system_error>

#include "app/cli/options.h"
#include "app/run/standard_streams.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

int fail(const char* message, ExitCode code) {
  printError("ropelight: {}", message);
  return int(code);
}

int runGuarded(int argc, char** argv) {
  try {
    return parseCommandLine(argc, argv)();
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
