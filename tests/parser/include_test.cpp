#include "parser/text/source.h"
#include "tests/parser/evaluated.h"

#include <fstream>

namespace firstlight::parser {
namespace {

/// A folder of files that goes when the object does.
class Folder {
 public:
  Folder() {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("firstlight_folder_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path add(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  std::string path() const { return path_.string(); }
  /// Loads a scene of this folder with `text` and a camera.
  render::LoadResult load(const std::string& text, const render::LoadOptions& options = {}) const {
    const auto scene =
        add("scene.pov", "#version 3.7; global_settings { assumed_gamma 1 } camera { look_at z }\n" + text);
    return PovFrontEnd().load(scene.string(), options);
  }

 private:
  std::filesystem::path path_;
};

std::string warnings(const render::LoadResult& result) {
  return messages(result, render::Diagnostic::Severity::warning);
}
std::string debugs(const render::LoadResult& result) { return messages(result, render::Diagnostic::Severity::debug); }

TEST(Include, IsFoundBesideTheScene) {
  const Folder folder;
  folder.add("part.inc", "#debug \"part\"");
  EXPECT_EQ(debugs(folder.load("#include \"part.inc\"")), "part\n");
}
TEST(Include, TheExtensionMayBeLeftOut) {
  const Folder folder;
  folder.add("part.inc", "#debug \"part\"");
  EXPECT_EQ(debugs(folder.load("#include \"part\"")), "part\n");
}
TEST(Include, IsFoundBesideTheIncludingFile) {
  const Folder folder;
  folder.add("parts/outer.inc", "#include \"inner.inc\"");
  folder.add("parts/inner.inc", "#debug \"inner\"");
  EXPECT_EQ(debugs(folder.load("#include \"parts/outer.inc\"")), "inner\n");
}
TEST(Include, IsFoundInALibraryFolder) {
  const Folder folder, library;
  library.add("part.inc", "#debug \"library\"");
  render::LoadOptions options;
  options.library_paths = {library.path()};
  EXPECT_EQ(debugs(folder.load("#include \"part.inc\"", options)), "library\n");
}
TEST(Include, InAnotherLetterCaseWarns) {
  const Folder folder;
  folder.add("Part.INC", "#debug \"part\"");
  const auto result = folder.load("#include \"pART.inc\"");
  EXPECT_EQ(debugs(result), "part\n");
  EXPECT_NE(warnings(result).find("differs in upper and lower case"), std::string::npos);
}
TEST(Include, BackslashesInItsNameStandForSlashes) {
  const Folder folder;
  folder.add("Parts/new.inc", "#debug \"part\"");
  const auto result = folder.load("#include \"parts\\new.inc\"");
  EXPECT_EQ(debugs(result), "part\n");
  EXPECT_NE(warnings(result).find("as if each '\\' in the name were '/'"), std::string::npos) << warnings(result);
}
TEST(Include, AnotherFilesNameIsTakenAsItStandsToo) {
  const Folder folder;
  folder.add("parts/new.png", "P2 1 1 255 0\n");
  const std::string text = "sphere { 0, 1 pigment { image_map { png \"parts\\new.png\" } } }";
  render::LoadOptions options;
  options.parse_only = true;
  const auto result = folder.load(text, options);
  EXPECT_EQ(errors(result), "");
  EXPECT_NE(warnings(result).find("'parts\\new.png'"), std::string::npos) << warnings(result);
}
TEST(Include, LocalNamesEndWithTheFile) {
  const Folder folder;
  folder.add("part.inc", "#local A = 1; #declare B = 2;");
  EXPECT_EQ(debugs(folder.load("#include \"part.inc\"\n#debug str(defined(A)*10 + defined(B), 0, 0)")), "1\n");
}
TEST(Include, AMissingFileIsNamed) {
  const Folder folder;
  const auto result = folder.load("#include \"nowhere.inc\"");
  EXPECT_EQ(errors(result),
            "there is no file 'nowhere.inc' in the current folder, the scene's or the library folders\n");
  EXPECT_EQ(result.diagnostics.back().line, 2u);
}
TEST(Include, AFileBeyondTheLimitIsNotRead) {
  const Folder folder;
  const auto part = folder.add("part.inc", "");
  std::filesystem::resize_file(part, SourceFiles::kLargestFile + 1);  // a hole, which takes no room
  EXPECT_EQ(errors(folder.load("#include \"part.inc\"")), "'" + part.string() + "' is too large (limit 2048 MiB)\n");
  EXPECT_EQ(errors(PovFrontEnd().load(part.string(), {})), "the file is too large (limit 2048 MiB)\n");
}
TEST(Include, AFileElsewhereMayNotBeRead) {
  const Folder folder;
  EXPECT_NE(errors(folder.load("#include \"/etc/hostname\"")).find("may not be read"), std::string::npos);
}
TEST(Include, ALinkOutOfTheFolderMayNotBeRead) {
  const Folder folder;
  std::filesystem::create_symlink("/etc/hostname", folder.path() + "/link.inc");
  EXPECT_NE(errors(folder.load("#include \"link.inc\"")).find("may not be read"), std::string::npos);
}
TEST(Include, FilesElsewhereAreNotToldFromNone) {
  const Folder folder, other;
  other.add("Part.inc", "");
  const std::string place = "#include \"" + other.path() + "/";
  const auto message = [&](const std::string& name) {
    std::string text = errors(folder.load(name + "\""));
    return text.substr(text.find("' may not"));
  };
  EXPECT_EQ(message(place + "Part.inc"), message(place + "none.inc"));
  const std::string up = "#include \"../" + std::filesystem::path(other.path()).filename().string() + "/";
  EXPECT_EQ(message(up + "Part.inc"), message(up + "none.inc"));
  EXPECT_EQ(message(up + "part.inc"), message(up + "none.inc"));
  std::filesystem::create_symlink(other.path() + "/Part.inc", folder.path() + "/there.inc");
  std::filesystem::create_symlink(other.path() + "/none.inc", folder.path() + "/none.inc");
  EXPECT_EQ(message("#include \"there.inc"), message("#include \"none.inc"));
  EXPECT_EQ(debugs(folder.load("#debug str(file_exists(\"" + other.path() + "/Part.inc\"), 0, 0)")), "0\n");
}
TEST(Include, AConfigurationPermitsMoreOrLess) {
  const Folder folder, other;
  const auto part = other.add("part.inc", "#debug \"part\"");
  const std::string text = "#include \"" + part.string() + "\"";
  EXPECT_NE(errors(folder.load(text)).find("may not be read"), std::string::npos);
  render::LoadOptions options;
  options.permission_files = {folder.add("povray.conf", "[Permitted Paths]\nread* = " + other.path()).string()};
  EXPECT_EQ(debugs(folder.load(text, options)), "part\n");
  options.permission_files.push_back(folder.add("own.conf", "[Permitted Paths]\nread* = .").string());
  EXPECT_NE(errors(folder.load(text, options)).find("may not be read"), std::string::npos);
}
TEST(Include, AConfigurationThatCannotBeUnderstoodIsAnError) {
  const Folder folder;
  render::LoadOptions options;
  options.permission_files = {folder.add("povray.conf", "[Permitted Paths]\nreed = .").string()};
  EXPECT_EQ(errors(folder.load("", options)), "line 2: 'reed = .' has no meaning here\n");
  options.permission_files = {folder.path() + "/none.conf"};
  EXPECT_EQ(errors(folder.load("", options)), "the permissions cannot be read\n");
}
TEST(Include, AFileThatIncludesItselfIsAnError) {
  const Folder folder;
  folder.add("self.inc", "#include \"self.inc\"");
  EXPECT_EQ(errors(folder.load("#include \"self.inc\"")), "included files are nested too deeply here (limit 64)\n");
}
TEST(Include, AnErrorInsideTellsOfTheInclude) {
  const Folder folder;
  folder.add("part.inc", "\nsphere { 0 }");
  const auto result = folder.load("#include \"part.inc\"");
  ASSERT_FALSE(result.diagnostics.empty());
  EXPECT_NE(result.diagnostics.back().message.find("included from here"), std::string::npos);
}
TEST(Include, MacrosCanBeCalledFromOutside) {
  const Folder folder;
  folder.add("part.inc", "#macro F(A) A*2 #end");
  EXPECT_EQ(debugs(folder.load("#include \"part.inc\"\n#declare R = F(4); #debug str(R, 0, 0)")), "8\n");
}

class StandardInclude : public testing::TestWithParam<const char*> {};
TEST_P(StandardInclude, LoadsWithoutError) {
  const Folder folder;
  EXPECT_EQ(errors(folder.load(std::string("#include \"") + GetParam() + "\"")), "");
}
INSTANTIATE_TEST_SUITE_P(Everyday, StandardInclude,
                         testing::Values("colors.inc", "consts.inc", "shapes.inc", "math.inc", "transforms.inc"));

TEST(Scene, AMissingFileIsAnError) {
  const auto result = PovFrontEnd().load("/nowhere/scene.pov", {});
  EXPECT_EQ(errors(result), "there is no such file\n");
  EXPECT_EQ(result.scene, nullptr);
}
TEST(Scene, AFolderIsNoScene) {
  const Folder folder;
  EXPECT_EQ(errors(PovFrontEnd().load(folder.path(), {})), "the file cannot be read\n");
}
TEST(Scene, ItsNameIsKnownWithoutItsFolder) {
  const Folder folder;
  EXPECT_EQ(debugs(folder.load("#debug input_file_name")), "scene.pov\n");
}
TEST(Scene, DeclaresOfTheCommandLineAreKnown) {
  const Folder folder;
  render::LoadOptions options;
  options.declares = {{"Size", "-2.5"}};
  EXPECT_EQ(debugs(folder.load("#debug str(Size, 0, 1)", options)), "-2.5\n");
}

// POV-Ray 3.7 writes `rgb 0.5` as 188 with gamma correction, as 128 without.
struct GammaCase {
  const char* text;
  render::WorkingGamma gamma;
  int version;
};
class Gamma : public testing::TestWithParam<GammaCase> {};
TEST_P(Gamma, FollowsVersionAndAssumedGamma) {
  const auto result = load_bare(std::string(GetParam().text) + "\ncamera { look_at z }");
  ASSERT_EQ(errors(result), "");
  EXPECT_EQ(result.scene->settings.gamma, GetParam().gamma);
  EXPECT_EQ(result.scene->settings.language_version, GetParam().version);
}
INSTANTIATE_TEST_SUITE_P(
    Scenes, Gamma,
    testing::Values(GammaCase{"", render::WorkingGamma::unmanaged, 362},
                    GammaCase{"#version 3.6;", render::WorkingGamma::unmanaged, 360},
                    GammaCase{"#version 3.7;", render::WorkingGamma::linear, 370},
                    GammaCase{"#include \"colors.inc\"", render::WorkingGamma::linear, 370},
                    GammaCase{"#include \"colors.inc\"\n#version 3.5;", render::WorkingGamma::unmanaged, 350},
                    GammaCase{"global_settings { assumed_gamma 1 }", render::WorkingGamma::linear, 362},
                    GammaCase{"#version 3.6; global_settings { assumed_gamma 2.2 }", render::WorkingGamma::power, 360},
                    GammaCase{"#version 3.7; global_settings { assumed_gamma srgb }", render::WorkingGamma::srgb,
                              370}));

TEST(Version, IsAValueToo) { EXPECT_EQ(debugged("#debug str(version, 0, 2)"), "3.70"); }
TEST(Include, ALinkOfTheInstallationMayLeadOutOfIt) { EXPECT_EQ(number("file_exists(\"timrom.ttf\")", 0), "1"); }

}  // namespace
}  // namespace firstlight::parser
