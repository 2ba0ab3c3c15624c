#include "app/commands/devices.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, DevicesOptions& o) { addFile(app, "--json", o.json, jsonDoc); }

Command parseDevices(const Subcommand& self, Arguments arguments) {
  return parse<DevicesOptions>(self, std::move(arguments), declare, runDevices);
}

}  // namespace

constinit const Subcommand devicesCommand{"devices", "", "List the CPU and the GPUs.", parseDevices};

}  // namespace ropelight
