#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::parser {

/// Which files a scene may read and write.
///
/// Source   POV-Ray 3.7's I/O restrictions and the syntax of its povray.conf: sections [File I/O Security] and
///          [Permitted Paths], entries `read`, `read*`, `read+write`, `read+write*`, places %INSTALLDIR%, %HOME%,
///          %CWD%.
/// Order    Paths that are asked for are canonical: symbolic links and `..` are resolved before.
class Permissions {
 public:
  /// The places that a .conf names.
  struct Places {
    std::filesystem::path install, home, working;
  };
  /// Where this process finds them.
  static Places places();

  /// The permissions when nobody says anything else: reading POV-Ray's include files and examples; reading and writing
  /// in the working folder and below. Hidden files and folders there are left alone, and of the root folder what is
  /// below.
  static Permissions built_in(const Places& places);
  /// Reads the `text` of a .conf file; lines of it that have no meaning go to `problems` as "line 3: ...".
  static Permissions parse(std::string_view text, const Places& places, std::vector<std::string>& problems);

  /// Reading in that folder and below, but for what is hidden there.
  void allow_reading(const std::filesystem::path& folder);
  bool may_read(const std::filesystem::path& path) const;
  bool may_write(const std::filesystem::path& path) const;
  /// Whether a path stays, as far as its words tell, in folders that may be read and on the way to them. The file system
  /// is not asked.
  bool may_reach(const std::filesystem::path& path) const;

 private:
  enum class Security { none, read_only, restricted };
  struct Rule {
    std::filesystem::path folder;  // canonical
    bool below = false;            // holds for the folders in it too
    bool write = false;
    bool hidden = false;            // holds for names that begin with a dot too
    std::filesystem::path spelled;  // the folder as it was named
  };
  static Rule rule_of(const std::filesystem::path& folder);
  static std::filesystem::path canonical(const std::filesystem::path& path);
  static bool holds(const Rule& rule, const std::filesystem::path& folder, const std::filesystem::path& path);
  bool matches(const std::filesystem::path& path, bool write) const;
  bool parse_rule(std::string_view line, const Places& places);

  Security security_ = Security::restricted;
  std::vector<Rule> rules_;
};

}  // namespace firstlight::parser
