#include "app/options.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firstlight::app {
namespace {

CommandLine parse(const std::vector<std::string>& words) { return parse_command_line(words); }

/// The options of a command line that must be right.
Options good(std::vector<std::string> words) {
  words.emplace_back("+Iscene.pov");
  const CommandLine line = parse(words);
  EXPECT_TRUE(line.errors.empty()) << line.errors.front();
  return line.options;
}

/// The first message about a command line that must be wrong.
std::string complaint(std::vector<std::string> words) {
  words.emplace_back("+Iscene.pov");
  const CommandLine line = parse(words);
  EXPECT_FALSE(line.errors.empty()) << words.front();
  return line.errors.empty() ? "" : line.errors.front();
}

TEST(Options, TheSceneComesInManyForms) {
  for (const char* form : {"dir/a.pov", "+Idir/a.pov", "-Idir/a.pov", "+idir/a.pov", "Input_File_Name=dir/a.pov"}) {
    const CommandLine line = parse({"+W10", form, "+H20"});
    EXPECT_TRUE(line.errors.empty()) << form;
    EXPECT_EQ(line.options.scene, "dir/a.pov") << form;
  }
  EXPECT_EQ(parse({"with=equals.pov"}).options.scene, "with=equals.pov");
}

TEST(Options, HavePovRaysDefaults) {
  const Options options = good({});
  EXPECT_EQ(options.width, 320);
  EXPECT_EQ(options.height, 240);
  EXPECT_EQ(options.threads, 0);
  EXPECT_TRUE(options.write_picture);
  EXPECT_EQ(options.scheme, "contribution");
  EXPECT_EQ(picture_path(options), "scene.png");
}

TEST(Options, SayWhichBoundsCount) {
  EXPECT_TRUE(good({}).bounding.remove_bounds);
  EXPECT_FALSE(good({}).bounding.split_unions);
  for (const auto& words : {std::vector<std::string>{"-UR", "+SU"}, {"Remove_Bounds=Off", "Split_Unions=On"}}) {
    const Options options = good(words);
    EXPECT_FALSE(options.bounding.remove_bounds) << words[0];
    EXPECT_TRUE(options.bounding.split_unions) << words[0];
  }
  EXPECT_TRUE(good({"-UR", "+UR"}).bounding.remove_bounds);
  EXPECT_FALSE(good({"+SU", "-SU"}).bounding.split_unions);
}

TEST(Options, SwitchesSetTheirValues) {
  const Options options = good({"+W640", "-H480", "+WT3", "+Lone", "-Ltwo", "three/", "+K0.25", "declare=Depth=4",
                                "Declare=x1=-2.5", "+Oout/a", "--scheme", "level", "--stats=s.json", "--quiet"});
  EXPECT_EQ(options.width, 640);
  EXPECT_EQ(options.height, 480);
  EXPECT_EQ(options.threads, 3);
  EXPECT_EQ(options.library_paths, (std::vector<std::string>{"one", "two", "three/"}));
  EXPECT_EQ(options.clock, 0.25);
  using Declares = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(options.declares, (Declares{{"Depth", "4"}, {"x1", "-2.5"}}));
  EXPECT_EQ(options.output, "out/a");
  EXPECT_EQ(options.scheme, "level");
  EXPECT_EQ(options.stats_file, "s.json");
  EXPECT_TRUE(options.quiet);
}

TEST(Options, SettingsByTheirLongNamesMeanTheSame) {
  const Options options =
      good({"Width=64", "HEIGHT=48", "work_threads=2", "Output_to_File=off", "Library_Path=lib", "Antialias=off"});
  EXPECT_EQ(options.width, 64);
  EXPECT_EQ(options.height, 48);
  EXPECT_EQ(options.threads, 2);
  EXPECT_FALSE(options.write_picture);
  EXPECT_EQ(options.library_paths, (std::vector<std::string>{"lib"}));
}

TEST(Options, WhatCannotChangeThePictureIsAccepted) {
  for (const char* word : {"-A",
                           "+D",
                           "-D",
                           "+D0",
                           "+J",
                           "-J",
                           "+J0.5",
                           "-J0",
                           "+V",
                           "-V",
                           "+P",
                           "-P",
                           "+C",
                           "-C",
                           "+Q9",
                           "+Q11",
                           "+UV",
                           "-UV",
                           "+UR",
                           "-UR",
                           "+UL",
                           "-UL",
                           "+B",
                           "-B",
                           "+MB3",
                           "+R3",
                           "+AM2",
                           "+BS16",
                           "-GA",
                           "+GA",
                           "+GD",
                           "-GS",
                           "-TH",
                           "-UA",
                           "-KC",
                           "+SP32",
                           "+EP4",
                           "+WL0",
                           "+X",
                           "-X",
                           "+HR",
                           "+MV3.7",
                           "+FN",
                           "+FN8",
                           "+F",
                           "+RP2",
                           "Pause_when_Done=off",
                           "Verbose=false",
                           "Display=no",
                           "Jitter=on",
                           "-A0.3"}) {
    const Options options = good({word});
    EXPECT_TRUE(options.write_picture) << word;
    EXPECT_EQ(options.width, 320) << word;
  }
}

TEST(Options, WhatWouldChangeThePictureIsRefusedByItsName) {
  for (const char* word : {"+SC10", "+EC0.5", "+SR1", "+ER20", "+KFF10", "+KFI1", "+KI0", "+KF1", "+KC", "+UF",
                           "+MV3.5", "+HIhead.inc", "+GIout.ini", "+GAlog.txt", "+RTR", "+SF2", "+EF5", "+FS", "+O-"}) {
    EXPECT_NE(complaint({word}).find(word), std::string::npos) << complaint({word});
  }
}

TEST(Options, AntiAliasingHasPovRaysDefaults) {
  EXPECT_FALSE(good({}).antialias);
  const auto antialias = good({"+A"}).antialias;
  ASSERT_TRUE(antialias);
  EXPECT_EQ(antialias->method, 1);
  EXPECT_EQ(antialias->threshold, 0.3);
  EXPECT_EQ(antialias->depth, 3);
  EXPECT_TRUE(antialias->jitter);
  EXPECT_EQ(antialias->jitter_amount, 1.0);
  EXPECT_EQ(antialias->gamma, 2.5);
  EXPECT_EQ(antialias->block_size, 32);
}

TEST(Options, AntiAliasingIsReadFromSwitchesAndSettings) {
  const std::vector<std::vector<std::string>> forms{
      {"+A0.1", "+AM2", "+R4", "-J0.5", "+AG1.8", "+BS16"},
      {"Antialias=on", "Antialias_Threshold=0.1", "Sampling_Method=2", "Antialias_Depth=4", "Jitter=off",
       "Jitter_Amount=0.5", "Antialias_Gamma=1.8", "Render_Block_Size=16"}};
  for (const std::vector<std::string>& words : forms) {
    const auto antialias = good(words).antialias;
    ASSERT_TRUE(antialias);
    EXPECT_EQ(antialias->method, 2);
    EXPECT_EQ(antialias->threshold, 0.1);
    EXPECT_EQ(antialias->depth, 4);
    EXPECT_FALSE(antialias->jitter);
    EXPECT_EQ(antialias->jitter_amount, 0.5);
    EXPECT_EQ(antialias->gamma, 1.8);
    EXPECT_EQ(antialias->block_size, 16);
  }
}

TEST(Options, TheLastWordOnAntiAliasingCounts) {
  EXPECT_FALSE(good({"+A0.3", "-A"}).antialias);
  EXPECT_TRUE(good({"-A", "+A"}).antialias);
  EXPECT_FALSE(good({"Antialias_Threshold=0.1"}).antialias);
  EXPECT_EQ(good({"-A0.1", "+A"}).antialias->threshold, 0.1);
}

TEST(Options, AntiAliasingOutOfRangeIsBroughtIntoItWithAWarning) {
  for (const char* word : {"+A7", "+AM3", "+R0", "+R99", "+J3", "Jitter_Amount=-1", "+BS1"}) {
    const CommandLine line = parse({"scene.pov", word, "Antialias=on"});
    EXPECT_TRUE(line.errors.empty()) << word;
    EXPECT_EQ(line.warnings.size(), 1u) << word;
    EXPECT_TRUE(line.options.antialias) << word;
  }
  EXPECT_EQ(good({"+A", "+AM3"}).antialias->method, 2);
  EXPECT_EQ(good({"+A", "+R99"}).antialias->depth, 9);
  EXPECT_FALSE(good({"+A", "+AM0"}).antialias);
  EXPECT_NE(complaint({"+A", "+AG0"}).find("Antialias_Gamma"), std::string::npos);
  EXPECT_NE(complaint({"+A", "+AGnan"}).find("Antialias_Gamma"), std::string::npos);
}

TEST(Options, WrongNumbersAreNamed) {
  for (const char* word : {"+Wx",
                           "+W",
                           "+W12x",
                           "+W1.5",
                           "+W0",
                           "+W-4",
                           "+H99999999999",
                           "+WT0",
                           "+WT0x",
                           "+WT100000",
                           "+Kabc",
                           "+Q",
                           "Width=abc",
                           "Width=T5",
                           "declare=7=1",
                           "declare=A",
                           "declare=A=b",
                           "Jitter=perhaps",
                           "--threads=0",
                           "--threads=-1",
                           "--threads=x",
                           "+FZ",
                           "+FNx",
                           "+I",
                           "+O"}) {
    EXPECT_NE(complaint({word}), "") << word;
  }
  EXPECT_NE(complaint({"+W70000", "+H70000"}).find("too large"), std::string::npos);
  EXPECT_NE(complaint({"+WT0x"}).find("expected a whole number"), std::string::npos);
}

TEST(Options, FileTypesHaveTheDepthThatIsAskedForOrWarn) {
  for (const char type : {'N', 'T', 'C', 'P', 'B', 'J', 'E', 'H'}) {
    EXPECT_EQ(good({std::string("+F") + type}).file_type, type);
    EXPECT_EQ(good({std::string("+F") + type}).bits, 8);
  }
  for (const char* word : {"+FN12", "+FP12", "Bits_Per_Color=12", "Bits_Per_Colour=12", "Output_File_Type=P12"}) {
    EXPECT_EQ(good({word}).bits, 12) << word;
  }
  EXPECT_EQ(good({"Bits_Per_Color=16", "+FN"}).bits, 16) << "the type says nothing of them";
  const auto warning = [](const char* word) {
    const CommandLine line = parse_command_line(std::vector<std::string>{"scene.pov", word});
    EXPECT_TRUE(line.errors.empty()) << word;
    return line.warnings.empty() ? std::string() : line.warnings[0];
  };
  EXPECT_NE(warning("+FN4").find("5 are used"), std::string::npos);
  EXPECT_NE(warning("+FP32").find("16 are used"), std::string::npos);
  EXPECT_NE(warning("+FT16").find("8 bits"), std::string::npos);
  EXPECT_NE(warning("+FE16").find("32 bits"), std::string::npos);
  EXPECT_EQ(warning("+FT5"), "");
  EXPECT_EQ(warning("+FE32"), "");
  EXPECT_NE(warning("+FJ90").find("Compression=90"), std::string::npos);
  EXPECT_NE(complaint({"+FN8x"}).find("expected bits per channel"), std::string::npos);
  EXPECT_NE(complaint({"+FN-8"}).find("expected bits per channel"), std::string::npos);
  EXPECT_NE(complaint({"Bits_Per_Color=many"}).find("expected a whole number"), std::string::npos);
}

TEST(Options, PicturesInShadesOfGrayAreOfTypesThatHaveThem) {
  EXPECT_FALSE(good({"+FN"}).grey);
  for (const char* word : {"+FNg", "+fpG", "Grayscale_Output=on"}) EXPECT_TRUE(good({word}).grey) << word;
  EXPECT_FALSE(good({"+FNg", "Grayscale_Output=off"}).grey);
  for (const char* word : {"+FJg", "+FTg", "+FBg", "+FEg", "+FHg"}) {
    EXPECT_NE(complaint({word}).find("only PNG and PPM"), std::string::npos) << word;
  }
  EXPECT_NE(complaint({"Grayscale_Output=on", "+FT"}).find("only PNG and PPM"), std::string::npos);
  EXPECT_NE(complaint({"Grayscale_Output=perhaps"}).find("expected on or off"), std::string::npos);
}

TEST(Options, CompressionIsTheQualityOfJpegFiles) {
  EXPECT_EQ(good({}).compression, 0);
  EXPECT_EQ(good({"Compression=50"}).compression, 50);
  EXPECT_EQ(good({"Compression=200"}).compression, 100);
  EXPECT_EQ(good({"Compression=-1"}).compression, 0);
  EXPECT_NE(complaint({"Compression=best"}).find("expected a whole number"), std::string::npos);
}

TEST(Options, QualityHasPovRaysLevels) {
  EXPECT_EQ(good({}).quality.level, 9);
  EXPECT_EQ(good({"+Q4"}).quality.level, 4);
  EXPECT_EQ(good({"Quality=0"}).quality.level, 0);
  EXPECT_EQ(good({"+Q99"}).quality.level, 11);
  EXPECT_EQ(good({"+Q-1"}).quality.level, 0);
  EXPECT_NE(complaint({"+Qbest"}).find("expected a whole number"), std::string::npos);
}

TEST(Options, AlphaIsAskedFor) {
  EXPECT_FALSE(good({}).alpha);
  EXPECT_TRUE(good({"+UA"}).alpha);
  EXPECT_TRUE(good({"Output_Alpha=on"}).alpha);
  EXPECT_FALSE(good({"+UA", "-UA"}).alpha);
}

TEST(Options, DitheringHasPovRaysMethods) {
  using enum render::Dithering;
  EXPECT_EQ(good({}).dithering, none);
  EXPECT_EQ(good({"+TH"}).dithering, floyd_steinberg);
  EXPECT_EQ(good({"Dither=on"}).dithering, floyd_steinberg);
  EXPECT_EQ(good({"+THB2"}).dithering, bayer2);
  EXPECT_EQ(good({"+thb3"}).dithering, bayer3);
  EXPECT_EQ(good({"+THB4"}).dithering, bayer4);
  EXPECT_EQ(good({"+THD1"}).dithering, diffusion1);
  EXPECT_EQ(good({"+THD2"}).dithering, diffusion2);
  EXPECT_EQ(good({"+THFS"}).dithering, floyd_steinberg);
  EXPECT_EQ(good({"Dither_Method=D1"}).dithering, none) << "the method alone does not turn it on";
  EXPECT_EQ(good({"Dither_Method=D1", "+TH"}).dithering, diffusion1);
  EXPECT_EQ(good({"+THB2", "-TH"}).dithering, none);
  EXPECT_EQ(good({"-THB2"}).dithering, none);
  EXPECT_NE(complaint({"+THX9"}).find("known are B2"), std::string::npos);
}

TEST(Options, FilesHaveAGammaOfTheirOwn) {
  EXPECT_EQ(good({}).file_gamma, 0.0);
  EXPECT_EQ(good({"File_Gamma=2.2"}).file_gamma, 2.2);
  EXPECT_EQ(good({"File_Gamma=2.2", "file_gamma=sRGB"}).file_gamma, 0.0);
  EXPECT_EQ(good({"Display_Gamma=sRGB"}).file_gamma, 0.0);
  for (const char* word : {"File_Gamma=0", "File_Gamma=-1", "File_Gamma=inf", "File_Gamma=x", "File_Gamma="}) {
    EXPECT_NE(complaint({word}).find("expected sRGB or a number above 0"), std::string::npos) << word;
  }
}

TEST(Options, SamplesWithoutNumberAreRefused) {
  EXPECT_NE(complaint({"+A0", "+R9", "+AM2"}).find("samples"), std::string::npos);
  EXPECT_NE(complaint({"+A0", "+R9", "+W20000", "+H20000"}).find("samples"), std::string::npos);
  EXPECT_TRUE(good({"+A0", "+R9"}).antialias);
  EXPECT_TRUE(good({"+A0", "+R4", "+AM2"}).antialias);
  EXPECT_TRUE(good({"+A0.1", "+R9", "+AM2"}).antialias);
}

TEST(Options, UnknownOnesAreAnsweredWithTheNearest) {
  EXPECT_NE(complaint({"--shceme=level"}).find("--scheme"), std::string::npos);
  EXPECT_NE(complaint({"--thread"}).find("--threads"), std::string::npos);
  EXPECT_NE(complaint({"--no-such-option"}).find("--help"), std::string::npos);
  EXPECT_NE(complaint({"Widht=5"}).find("width"), std::string::npos);
  EXPECT_NE(complaint({"+NN"}).find("unknown option '+NN'"), std::string::npos);
  EXPECT_NE(complaint({"--scheme=nonsense"}).find("known are contribution, "), std::string::npos);
  EXPECT_NE(parse({"scene.pov", "--stats"}).errors.at(0).find("expected a value"), std::string::npos);
  EXPECT_NE(complaint({"settings.ini"}).find("settings.ini"), std::string::npos);
}

TEST(Options, OursSayHowToRenderAndWhenToStop) {
  for (const auto& words : {std::vector<std::string>{"--queue-memory", "16M", "--stop-at-error=0.01", "--stop-after",
                                                     "2.5", "--steer", "s", "--boost", "light 0", "--boost=light 1"},
                            std::vector<std::string>{"Queue_Memory=16M", "stop_at_error=0.01", "STOP_AFTER=2.5",
                                                     "Steer=s", "Boost=light 0", "boost=light 1"}}) {
    const Options options = good(words);
    EXPECT_EQ(options.queue_memory, 16u << 20);
    EXPECT_EQ(options.stop_at_error, 0.01);
    EXPECT_EQ(options.stop_after, 2.5);
    EXPECT_EQ(options.steer, "s");
    EXPECT_EQ(options.boosts, (std::vector<std::string>{"light 0", "light 1"}));
  }
  EXPECT_EQ(good({}).queue_memory, 0u);
  EXPECT_EQ(good({}).stop_at_error, 0.0);
  EXPECT_EQ(good({}).stop_after, 0.0);
}

TEST(Options, ImpossibleWishesAreNamed) {
  for (const char* word :
       {"--queue-memory=x", "--queue-memory=0", "--queue-memory=1k", "--queue-memory=-1M", "--stop-at-error=0",
        "--stop-at-error=-1", "--stop-at-error=inf", "--stop-at-error=nan", "--stop-at-error=x", "--stop-after=0",
        "--stop-after=-2", "--stop-after=soon", "--quiet=perhaps"}) {
    const std::string name = std::string(word).substr(0, std::string(word).find('='));
    EXPECT_NE(complaint({word}).find(name), std::string::npos) << complaint({word});
  }
  EXPECT_NE(complaint({"--queue-memory=1k"}).find("at least"), std::string::npos);
}

TEST(Options, AWrongPlainSchemeIsNamedBeforeTheSceneIsRead) {
  EXPECT_NE(complaint({"--scheme", "levl"}).find("no such scheme"), std::string::npos);
  EXPECT_NE(complaint({"--scheme="}).find("--scheme"), std::string::npos);
  // Whatever is more than a name needs the scene to be judged.
  EXPECT_EQ(good({"--scheme", "nothing(1), of the kind"}).scheme, "nothing(1), of the kind");
}

TEST(Options, ASceneIsNeeded) { EXPECT_FALSE(parse({"+W10"}).errors.empty()); }

TEST(Options, HelpAndVersionWinOverMistakes) {
  EXPECT_EQ(parse({"--help", "+Wx"}).wish, CommandLine::Wish::help);
  EXPECT_EQ(parse({"--version"}).wish, CommandLine::Wish::version);
  EXPECT_TRUE(parse({"--version"}).errors.empty());
  for (const char* word : {"-h", "-H", "-?", "-help"}) {
    EXPECT_EQ(parse({"scene.pov", word}).wish, CommandLine::Wish::help) << word;
  }
  for (const char* word : {"-version", "--V", "--v"}) {
    EXPECT_EQ(parse({"scene.pov", word}).wish, CommandLine::Wish::version) << word;
  }
  for (const char* word :
       {"--threads", "--scheme", "--boost", "--queue-memory", "--stop-at-error", "--stop-after", "--steer", "--stats",
        "--snapshots", "--front-end", "--quiet", "+Wn", "ray-type", ".ini", "firstlight steer", "space"}) {
    EXPECT_NE(help_text().find(word), std::string::npos) << word;
  }
}

TEST(PicturePath, IsPovRays) {
  const auto path = [](const std::string& output, char type = 'N') {
    Options options;
    options.scene = "scenes/room.pov";
    options.output = output;
    options.file_type = type;
    return picture_path(options);
  };
  EXPECT_EQ(path(""), "room.png");
  EXPECT_EQ(path("out/"), "out/room.png");
  EXPECT_EQ(path("out/a"), "out/a.png");
  EXPECT_EQ(path("a.png"), "a.png");
  EXPECT_EQ(path("a.PNG"), "a.PNG");
  EXPECT_EQ(path("a.jpg"), "a.jpg.png");
  EXPECT_EQ(path("a.jpg", 'J'), "a.jpg");
  EXPECT_EQ(path("", 'E'), "room.exr");
}

}  // namespace
}  // namespace firstlight::app
