#include "tests/parser/object_text.h"

namespace firstlight::parser {
namespace {

render::Settings settings_of(const std::string& words) {
  return described_scene("sphere { 0, 1 } global_settings { " + words + " }")->settings;
}
std::string mistake(const std::string& words) { return errors(described("global_settings { " + words + " }")); }
std::string warning(const std::string& words) {
  return warnings(described("sphere { 0, 1 } global_settings { " + words + " }"));
}

TEST(ParseGlobalSettings, DetailsAreKept) {
  const render::Settings plain = settings_of("");
  EXPECT_EQ(plain.number_of_waves, 10);
  EXPECT_EQ(plain.mm_per_unit, 10.0);
  EXPECT_EQ(plain.charset, render::Charset::ascii);
  EXPECT_FLOAT_EQ(plain.irid_wavelength.y, 0.52f);
  const render::Settings settings =
      settings_of("number_of_waves 3 mm_per_unit 100 charset utf8 irid_wavelength rgb <0.1, 0.2, 0.3>");
  EXPECT_EQ(settings.number_of_waves, 3);
  EXPECT_EQ(settings.mm_per_unit, 100.0);
  EXPECT_EQ(settings.charset, render::Charset::utf8);
  EXPECT_FLOAT_EQ(settings.irid_wavelength.z, 0.3f);
  EXPECT_TRUE(settings.unrendered.empty());
  EXPECT_EQ(settings_of("charset sys").charset, render::Charset::system);
  EXPECT_EQ(settings_of("charset ascii").charset, render::Charset::ascii);
}

TEST(ParseGlobalSettings, PovRaysRepairsAreWarnings) {
  EXPECT_NE(warning("number_of_waves 0").find("taken as 1"), std::string::npos);
  EXPECT_NE(warning("hf_gray_16 on").find("ignored"), std::string::npos);
  EXPECT_NE(warning("max_intersections 64").find("no effect"), std::string::npos);
  EXPECT_NE(mistake("noise_generator 4").find("1, 2 or 3"), std::string::npos);
  EXPECT_NE(mistake("charset latin"), "");
}

TEST(ParseGlobalSettings, SubsurfaceIsRead) {
  EXPECT_FALSE(settings_of("").subsurface.enabled);
  const render::SubsurfaceSettings settings = settings_of("subsurface { samples 10, 20 radiosity on }").subsurface;
  EXPECT_TRUE(settings.enabled);
  EXPECT_EQ(settings.diffuse_samples, 10);
  EXPECT_EQ(settings.single_samples, 20);
  EXPECT_TRUE(settings.radiosity);
}

TEST(ParseRadiosity, DefaultsArePovRays) {
  EXPECT_FALSE(settings_of("").radiosity.enabled);
  const render::Settings all = settings_of("radiosity { }");
  const render::RadiositySettings& settings = all.radiosity;
  EXPECT_TRUE(settings.enabled);
  EXPECT_EQ(spelled(all.unrendered), "radiosity");
  EXPECT_EQ(settings.count, 35);
  EXPECT_EQ(settings.direction_pool_size, 1600);
  EXPECT_EQ(settings.error_bound, 1.8);
  EXPECT_EQ(settings.nearest_count, 5);
  EXPECT_EQ(settings.recursion_limit, 2);
  EXPECT_EQ(settings.pretrace_start, 0.08);
  EXPECT_EQ(settings.pretrace_end, 0.04);
}

TEST(ParseRadiosity, AllItsWordsAreRead) {
  const render::RadiositySettings settings =
      settings_of(
          "radiosity { adc_bailout 0.02 always_sample on brightness 1.5 count 100, 5000 error_bound 0.5 "
          "gray_threshold 0.3 low_error_factor 0.8 max_sample 2 maximum_reuse 0.3 media on minimum_reuse 0.01 "
          "nearest_count 10, 4 normal on pretrace_end 0.01 pretrace_start 0.1 recursion_limit 3 subsurface on }")
          .radiosity;
  EXPECT_EQ(settings.adc_bailout, 0.02);
  EXPECT_TRUE(settings.always_sample && settings.media && settings.normal && settings.subsurface);
  EXPECT_EQ(settings.brightness, 1.5);
  EXPECT_EQ(settings.count, 100);
  EXPECT_EQ(settings.direction_pool_size, 5000);
  EXPECT_EQ(settings.error_bound, 0.5);
  EXPECT_EQ(settings.gray_threshold, 0.3);
  EXPECT_EQ(settings.low_error_factor, 0.8);
  EXPECT_EQ(settings.max_sample, 2.0);
  EXPECT_EQ(settings.maximum_reuse, 0.3);
  EXPECT_EQ(settings.minimum_reuse, 0.01);
  EXPECT_EQ(settings.nearest_count, 10);
  EXPECT_EQ(settings.nearest_count_pretrace, 4);
  EXPECT_EQ(settings.pretrace_start, 0.1);
  EXPECT_EQ(settings.pretrace_end, 0.01);
  EXPECT_EQ(settings.recursion_limit, 3);
}

TEST(ParseRadiosity, RefusesWhatMakesNoSense) {
  for (const char* words :
       {"brightness 0", "count 0", "count 100, 50", "error_bound 0", "gray_threshold 2", "low_error_factor 0",
        "maximum_reuse 0", "minimum_reuse -1", "nearest_count 21", "nearest_count 5, 5", "pretrace_start 2",
        "pretrace_end 0", "recursion_limit 21", "adc_bailout 0"}) {
    EXPECT_NE(mistake("radiosity { " + std::string(words) + " }"), "") << words;
  }
  EXPECT_NE(warning("radiosity { save_file \"a\" load_file \"b\" }").find("command line"), std::string::npos);
}

TEST(ParseRadiosity, WhatItSaysMustAgreeAtTheEndOfTheScene) {
  EXPECT_EQ(mistake("radiosity { pretrace_start 0.01 pretrace_end 0.04 }"),
            "'pretrace_end' of 'radiosity' (0.04) must not be greater than 'pretrace_start' (0.01)\n");
  EXPECT_NE(mistake("radiosity { pretrace_start 0.02 }"), "");  // the default end is 0.04
  EXPECT_EQ(mistake("radiosity { pretrace_start 0.02 } radiosity { pretrace_end 0.02 }"), "");
  EXPECT_NE(mistake("radiosity { minimum_reuse 0.3 maximum_reuse 0.2 }"), "");
  EXPECT_NE(warning("radiosity { minimum_reuse 0.15 maximum_reuse 0.2 }"), "");
  EXPECT_NE(warning("radiosity { minimum_reuse 0.3 }").find("which becomes 0.6"), std::string::npos);
  EXPECT_NE(warning("radiosity { maximum_reuse 0.02 }").find("which becomes 0.01"), std::string::npos);
}

TEST(ParseRadiosity, DefaultImportanceIsKept) {
  const auto scene = described_scene("#default { radiosity { importance 0.5 } } sphere { 0, 1 }");
  EXPECT_EQ(scene->settings.radiosity.default_importance, 0.5);
}

TEST(ParsePhotons, DefaultsArePovRays) {
  EXPECT_FALSE(settings_of("").photons.enabled);
  const render::Settings all = settings_of("photons { spacing 0.02 }");
  const render::PhotonSettings& settings = all.photons;
  EXPECT_TRUE(settings.enabled);
  EXPECT_EQ(spelled(all.unrendered), "photons");
  EXPECT_EQ(settings.spacing, 0.02);
  EXPECT_EQ(settings.gather_min, 20);
  EXPECT_EQ(settings.gather_max, 100);
  EXPECT_EQ(settings.jitter, 0.4);
  EXPECT_EQ(settings.autostop, 0.5);
  EXPECT_EQ(settings.expand_tolerance, 0.2);
  EXPECT_EQ(settings.expand_min, 35.0);
  EXPECT_EQ(settings.max_trace_level, -1);
  EXPECT_EQ(settings.surface_radius.least, -1.0);
}

TEST(ParsePhotons, AllItsWordsAreRead) {
  const render::PhotonSettings settings =
      settings_of(
          "photons { count 20000 gather 10, 50 media 100, 2 jitter 0.5 max_trace_level 7 adc_bailout 0.1 "
          "save_file \"map\" autostop 0 expand_thresholds 0.3, 40 radius 1, 2, 3, 4 }")
          .photons;
  EXPECT_EQ(settings.count, 20000);
  EXPECT_EQ(settings.gather_min, 10);
  EXPECT_EQ(settings.gather_max, 50);
  EXPECT_EQ(settings.max_media_steps, 100);
  EXPECT_EQ(settings.media_spacing_factor, 2.0);
  EXPECT_EQ(settings.jitter, 0.5);
  EXPECT_EQ(settings.max_trace_level, 7);
  EXPECT_EQ(settings.adc_bailout, 0.1);
  EXPECT_EQ(settings.file, "map");
  EXPECT_FALSE(settings.load);
  EXPECT_EQ(settings.autostop, 0.0);
  EXPECT_EQ(settings.expand_tolerance, 0.3);
  EXPECT_EQ(settings.expand_min, 40.0);
  EXPECT_EQ(settings.surface_radius.factor, 2.0);
  EXPECT_EQ(settings.media_radius.least, 3.0);
  EXPECT_EQ(settings.media_radius.factor, 4.0);
}

TEST(ParsePhotons, GatheringNothingTurnsThemOff) {
  const render::Settings settings = settings_of("photons { gather 0, 0 }");
  EXPECT_FALSE(settings.photons.enabled);
  EXPECT_TRUE(settings.unrendered.empty());
}

TEST(ParsePhotons, RefusesWhatMakesNoSense) {
  for (const char* words : {"gather 50, 10", "gather -1, 10", "media -1", "media 1, 0"}) {
    EXPECT_NE(mistake("photons { " + std::string(words) + " }"), "") << words;
  }
  EXPECT_NE(warning("photons { save_file \"a\" load_file \"b\" }").find("cannot be both"), std::string::npos);
  EXPECT_NE(warning("photons { expand_thresholds -1, 1 }").find("taken as 0"), std::string::npos);
}

}  // namespace
}  // namespace firstlight::parser
