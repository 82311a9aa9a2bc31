#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app {

/// One line of an .ini file, as the words of a command line that mean the same: "+W80", "Width=80", "more.ini".
struct IniLine {
  int number = 0;  ///< from 1
  std::vector<std::string> words;
};

/// The lines before the first section of the file, and those in the section of that name if there is a name.
struct IniText {
  std::vector<IniLine> lines;
  std::vector<std::string> sections;  ///< all names that the file has
  bool has_section = false;           ///< the one that was asked for
};

/// Source  POV-Ray 3.7 manual, "Using INI Files": comments from ; or # to the end of the line, sections whose names do
///         not depend on case, one setting or several switches a line, quotes around what holds blanks. As POV-Ray
///         does, and other than its manual says, the lines above the first section always count.
IniText parse_ini(std::string_view text, std::string_view section);

/// A word that names an .ini file and perhaps a section in it: "quick.ini", "quick.ini[High]", "quick[High]".
struct IniName {
  std::string file;  ///< as given
  std::string section;
};

/// Whether `word` names an .ini file. As POV-Ray has it, ".ini" may be left away if there is such a file.
bool is_ini_name(const std::string& word);
IniName split_ini_name(const std::string& word);

/// Finds the file in the current folder, then in `folders`, and reads it. On failure `error` says why.
IniText read_ini(const IniName& name, std::span<const std::string> folders, std::string& error);

}  // namespace firstlight::app
