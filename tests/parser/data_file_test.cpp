#include "tests/parser/evaluated.h"

#include <sstream>

namespace firstlight::parser {
namespace {

/// An empty folder that is the current one while the object lives.
class WorkingFolder {
 public:
  WorkingFolder() : before_(std::filesystem::current_path()) {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("firstlight_work_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
    std::filesystem::current_path(path_);
  }
  ~WorkingFolder() {
    std::filesystem::current_path(before_);
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

  void write(const std::string& name, std::string_view text) const { std::ofstream(path_ / name) << text; }
  std::string read(const std::string& name) const {
    std::ifstream stream(path_ / name, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }
  std::filesystem::path path() const { return path_; }

 private:
  std::filesystem::path before_, path_;
};

TEST(DataFile, WritesNumbersVectorsAndStringsAsPovRayDoes) {
  const WorkingFolder folder;
  EXPECT_EQ(debugged("#declare C = rgbft 0.5; #fopen F \"out.txt\" write #write (F, 1/3, \", \", <1, -2.5, 3e10>, u, "
                     "C, \"\\n\") #fclose F"),
            "");
  EXPECT_EQ(folder.read("out.txt"), "0.333333, <1,-2.5,3e+10> <1,0> <0.5,0.5,0.5,0.5,0.5> \n");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(DataFile, WritesBytes) {
  const WorkingFolder folder;
  EXPECT_EQ(
      debugged("#fopen F \"out\" write\n"
               "#write (F, uint8 65 300, sint8 -1, uint16be 258, uint16le 258, sint16be -2, sint16le 1, sint32be 1,"
               " sint32le <1, 2>) #fclose F"),
      "");
  const std::string expected(
      "A\xff\xff\x01\x02\x02\x01\xff\xfe\x01\x00\x00\x00\x00\x01\x01\x00\x00\x00\x02\x00\x00\x00", 23);
  EXPECT_EQ(folder.read("out"), expected);
}

TEST(DataFile, ReadsWhatItWroteUpToTheEnd) {
  const WorkingFolder folder;
  EXPECT_EQ(
      debugged(
          "#fopen F \"data\" write #for (I, 1, 3) #write (F, I, \",\", <I, 2, -I>, \",\\\"s\\\"\\n\") #end #fclose F\n"
          "#fopen F \"data\" read\n"
          "#while (defined(F)) #read (F, N, V, S) #debug concat(str(N, 0, 0), S, str(V.z, 0, 0), \" \") #end"),
      "1s-1 2s-2 3s-3 ");
}

TEST(DataFile, ReadsIntoArraysAndLeavesTheRestUndeclared) {
  const WorkingFolder folder;
  folder.write("data", "1, -2\n+3");
  EXPECT_EQ(debugged("#declare A = array[2]; #fopen F \"data\" read #read (F, A[0], A[1], B, C)\n"
                     "#debug concat(str(A[0] + A[1] + B, 0, 0), str(defined(C), 0, 0), str(defined(F), 0, 0))"),
            "200");
}

TEST(DataFile, ACommaBehindTheLastValueMakesForOneMoreTurn) {
  const WorkingFolder folder;
  const std::string count =
      "#fopen F \"data\" read #declare N = 0; #while (defined(F)) #read (F, A) #declare N = N + 1; #end\n"
      "#debug concat(str(N, 0, 0), \" \", str(A, 0, 0))";
  folder.write("data", "1,2,3,\n");
  EXPECT_EQ(debugged(count), "4 3");
  folder.write("data", "1,2,3\n");
  EXPECT_EQ(debugged(count), "3 3");
}

TEST(DataFile, ValuesNeedNoCommas) {
  const WorkingFolder folder;
  folder.write("data", "1 2 3\n4 <5, 6, 7>\n\"end\"");
  EXPECT_EQ(debugged("#fopen F \"data\" read #read (F, A, B, C, D, V, S) #debug concat(str(A + B + C + D, 0, 0), "
                     "str(V.z, 0, 0), S, str(defined(F), 0, 0))"),
            "107end0");
}

TEST(DataFile, AppendsToWhatIsThere) {
  const WorkingFolder folder;
  EXPECT_EQ(debugged("#fopen F \"log\" write #write (F, \"one\\n\") #fclose F"), "");
  EXPECT_EQ(debugged("#fopen F \"log\" append #write (F, \"two\\n\") #fclose F"), "");
  EXPECT_EQ(folder.read("log"), "one\ntwo\n");
}

TEST(DataFile, WhatOthersHaveMadeStays) {
  const WorkingFolder folder;
  folder.write("notes", "mine");
  for (const std::string mode : {"write", "append"}) {
    EXPECT_EQ(debugged("#fopen F \"notes\" " + mode),
              "error: 'notes' is there already and is not what a scene has written, so it is not replaced: permissions "
              "of '--permissions' allow it");
  }
  EXPECT_EQ(folder.read("notes"), "mine");
  EXPECT_NE(debugged("#fopen F \".hidden\" write"), "");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(DataFile, WhatASceneHasWrittenIsReplacedUntilSomeoneChangesIt) {
  const WorkingFolder folder;
  const std::string write = "#fopen F \"out\" write #write (F, 1) #fclose F";
  EXPECT_EQ(debugged(write), "");
  EXPECT_EQ(debugged(write), "");
  std::filesystem::last_write_time(folder.path() / "out", std::filesystem::file_time_type::clock::now());
  folder.write("out", "edited");
  EXPECT_NE(debugged(write), "");
  EXPECT_EQ(folder.read("out"), "edited");
}

TEST(DataFile, PermissionsOfAFileAllowReplacing) {
  const WorkingFolder folder;
  folder.write("notes", "mine");
  folder.write("own.conf", "[Permitted Paths]\nread+write* = .\n");
  const SceneFile scene("#version 3.7; global_settings { assumed_gamma 1 }\n#fopen F \"notes\" write #write (F, 1)");
  render::LoadOptions options;
  options.permission_files = {"own.conf"};
  EXPECT_EQ(errors(PovFrontEnd().load(scene.path(), options)), "");
  EXPECT_EQ(folder.read("notes"), "1");
}

TEST(DataFile, TheNumberOfFilesIsBounded) {
  const WorkingFolder folder;
  EXPECT_EQ(debugged("#for (I, 1, 2000) #fopen F concat(\"f\", str(I, 0, 0)) write #fclose F #end"),
            "error: this scene writes too many files (limit 1000)");
  EXPECT_EQ(folder.files(), 1000u);
}

TEST(DataFile, WhatIsAppendedToCountsAsWritten) {
  const WorkingFolder folder;
  const std::string text =
      "#declare K = \"0123456789abcdef\"; #for (I, 1, 12) #declare K = concat(K, K); #end\n"
      "#fopen F \"base\" write #for (I, 1, 600) #write (F, K) #end #fclose F\n"
      "#for (I, 1, 100) #fopen F \"base\" append #write (F, K) #fclose F #end";
  EXPECT_EQ(debugged(text), "error: this scene writes too much (limit 1024 MiB)");
}

TEST(DataFile, IsIncludedAsItWasWrittenLast) {
  const WorkingFolder folder;
  EXPECT_EQ(debugged("#for (I, 1, 2) #fopen F \"part.inc\" write #write (F, \"#declare X = \", I, \";\") #fclose F\n"
                     "#include \"part.inc\"\n#debug str(X, 0, 0) #end"),
            "12");
}

TEST(DataFile, IsThereAtTheEndOfTheSceneButNotAfterAMistake) {
  const WorkingFolder folder;
  EXPECT_EQ(debugged("#fopen F \"out\" write #write (F, 1)"), "");
  EXPECT_EQ(folder.read("out"), "1");
  EXPECT_NE(debugged("#fopen F \"out\" write #write (F, 2) sphere"), "");
  EXPECT_EQ(folder.read("out"), "1");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(DataFile, IsWrittenInTheCurrentFolderOnly) {
  const WorkingFolder folder;
  const std::string refused =
      "may not be written: a scene may write files where its permissions allow, which is the "
      "current folder and below unless others are given";
  EXPECT_EQ(debugged("#fopen F \"../elsewhere.txt\" write"),
            "error: '" + (std::filesystem::canonical(folder.path()).parent_path() / "elsewhere.txt").string() + "' " +
                refused);
  std::filesystem::create_directory_symlink("/usr", folder.path() / "link");
  EXPECT_EQ(debugged("#fopen F \"link/file\" write"), "error: '/usr/file' " + refused);
}

TEST(DataFile, MistakesAreNamed) {
  const WorkingFolder folder;
  folder.write("data", "word");
  EXPECT_EQ(debugged("#fopen F \"none\" read"),
            "error: there is no file 'none' in the current folder, the scene's or the library folders");
  EXPECT_EQ(debugged("#fopen F \"data\" read #read (F, A)"),
            "error: expected a number, a vector or a string in the file, found 'word'");
  EXPECT_EQ(debugged("#fopen F \"data\" read #write (F, 1)"), "error: 'F' is not open for writing");
  EXPECT_EQ(debugged("#fopen F \"out\" write #read (F, A)"), "error: 'F' is not open for reading");
  EXPECT_EQ(debugged("#read (G, A)"),
            "error: expected a file that '#fopen' has opened, found undeclared identifier 'G'");
  EXPECT_EQ(debugged("#fopen F \"data\""),
            "error: expected 'read', 'write' or 'append' after the name of the file, found 'camera'");
  EXPECT_EQ(warnings(load("sphere { 0, 1 } #fclose G")), "'G' is no open file, so '#fclose' changes nothing\n");
}

}  // namespace
}  // namespace firstlight::parser
