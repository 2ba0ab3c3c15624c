#pragma once
// The text of an input script → commands whose words are checked. No window.

#include <string>
#include <vector>

namespace ropelight::view {

/// One line. Which members mean something follows from the name.
struct ScriptCommand {
  int line = 0;
  std::string name;                ///< "click"
  std::string word;                ///< the widget, file or text, or what wait waits for; empty: numbers give a place
  std::vector<double> numbers;     ///< in the order of the line
  std::vector<std::string> texts;  ///< the files of drop, the value of set
  int button = 0;                  ///< 0 left, 1 right, 2 middle
  bool twice = false;              ///< a double click
  int key = -1;                    ///< GLFW's number
  bool shift = false, control = false, alt = false;
  int frames = 0;
  bool optional = false;  ///< "try": left out where its widget is not there
};

/// Throws Error (badInput), "FILE:LINE: what is wrong; what was expected".
std::vector<ScriptCommand> parseScript(const std::string& file, const std::string& text);

/// GLFW's number of a key by its name ("a", "f1", "space"), in any case; −1: there is none.
int keyNumber(const std::string& name);

/// Name and usage of every command, in the order of the documentation.
struct ScriptUsage {
  const char* name;
  const char* usage;
};
std::vector<ScriptUsage> scriptUsages();

}  // namespace ropelight::view
