// The program: picks the subcommand and turns what it throws into a message and an exit code.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <variant>

#include "app/options.h"
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
  std::fprintf(stderr, "ropelight: %s\n", message);
  return int(code);
}

}  // namespace
}  // namespace ropelight

int main(int argc, char** argv) {
  using namespace ropelight;
  try {
    return std::visit([](const auto& options) { return run(options); }, parseCommandLine(argc, argv));
  } catch (const Error& error) {
    return fail(error.what(), error.code());
  } catch (const std::bad_alloc&) {
    return fail("out of memory; lower --width, --height or --photons", ExitCode::outOfMemory);
  } catch (const std::exception& error) {
    return fail(error.what(), ExitCode::internal);
  } catch (...) {
    return fail("an unknown failure", ExitCode::internal);
  }
}
