#include "app/subcommands/parse.h"

#include <utility>

#include "render/import/load.h"
#include "render/text/suggest.h"

namespace ropelight {

void addSceneName(CLI::App& app, std::string& scene) {
  std::string const doc = fmt::format("scene file ({}) or the name of an asset", joinNames(sceneExtensions()));
  app.add_option("SCENE", scene, doc)->required()->type_name("");
}

CLI::Option* addFile(CLI::App& app, const char* flags, std::string& file, const char* doc) {
  return app.add_option(flags, file, doc)->type_name("FILE")->take_last();
}

bool parseInto(CLI::App& app, const Subcommand& self, Arguments arguments, std::string& help) {
  std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 takes
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    help = app.help();
    return false;
  } catch (const CLI::ParseError& error) {
    throw Error(fmt::format("{}; see ropelight {} --help", error.what(), self.name), ExitCode::usage);
  }
  return true;
}

Command printing(std::string text) {
  return [text = std::move(text)] {
    fmt::print("{}", text);
    return int(ExitCode::done);
  };
}

}  // namespace ropelight
