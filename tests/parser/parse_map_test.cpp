#include "tests/parser/surface_text.h"

#include <fstream>

namespace firstlight::parser {
namespace {

using render::PatternKind;
using render::Rgb;
using render::Vec3;

TEST(ParseMap, PatternsWithoutAMapHaveTheirOwn) {
  EXPECT_TRUE(pigment_of("marble").pattern->map.empty());
  EXPECT_EQ(render::map_of(pigment_of("marble")).size(), 3u);
  EXPECT_EQ(render::map_of(pigment_of("granite")).at(1).color.rgb, Rgb(1));
  EXPECT_EQ(render::map_of(pigment_of("hexagon rgb 0")).at(2).color.rgb, Rgb(1, 0, 0));
  EXPECT_EQ(render::map_of(pigment_of("brick")).at(1).color.rgb, Rgb(0.6f, 0.15f, 0.15f));
  EXPECT_EQ(render::map_of(pigment_of("triangular")).at(5).color.rgb, Rgb(1, 0, 1));
}

TEST(ParseMap, ListPatternsTakeAsManyColorsAsTheyHaveKinds) {
  const auto pigment = pigment_of("square rgb 1 rgb 0.5, rgb x rgb y");
  ASSERT_EQ(pigment.pattern->map.size(), 4u);
  EXPECT_EQ(pigment.pattern->map[3].color.rgb, Rgb(0, 1, 0));
  EXPECT_NE(pigment_error("checker rgb 1 rgb 1 rgb 1"), "");
}

TEST(ParseMap, PigmentMapsHoldPigments) {
  const auto pigment = pigment_of("gradient x pigment_map { [0 rgb x] [0.25 marble scale 2] [1, granite] }");
  ASSERT_TRUE(pigment.pattern->pigments);
  ASSERT_EQ(pigment.pattern->pigments->entries.size(), 3u);
  EXPECT_EQ(pigment.pattern->pigments->entries[0].value.color.rgb, Rgb(1, 0, 0));
  EXPECT_EQ(pigment.pattern->pigments->entries[1].position, 0.25);
  EXPECT_EQ(pigment.pattern->pigments->entries[1].value.pattern->kind, PatternKind::marble);
  EXPECT_EQ(pigment.pattern->depth, 1u);
}

TEST(ParseMap, DeclaredMapsCanBeUsed) {
  const auto scene = surface_scene(
      "#declare M = pigment_map { [0 rgb x] [1 rgb y] } #declare N = normal_map { [0 bumps] [1 dents 2] }"
      "#declare S = slope_map { [0 <0, 1>] [1 <1, 0>] } #declare T = texture_map { [0 pigment { rgb z }] [1 finish { "
      "phong 1 }] }"
      "sphere { 0, 1 pigment { bozo pigment_map { M } } } sphere { 0, 1 normal { bozo normal_map { N } } }"
      "sphere { 0, 1 normal { bozo slope_map { S } } } sphere { 0, 1 texture { bozo texture_map { T } } }");
  EXPECT_EQ(layer_of(*scene, 0).pigment.pattern->pigments->entries.size(), 2u);
  EXPECT_EQ(layer_of(*scene, 1).extras->normal->normals->entries[1].value.amount, 2.0);
  EXPECT_EQ(layer_of(*scene, 2).extras->normal->slopes->entries[0].value.slope, 1.0);
  EXPECT_EQ(layer_of(*scene, 2).extras->normal->slopes->entries[1].value.height, 1.0);
  const auto& textures = layer_of(*scene, 3).extras->patterned->textures->entries;
  EXPECT_EQ(textures[0].value->layers[0].pigment.color.rgb, Rgb(0, 0, 1));
  EXPECT_EQ(textures[1].value->layers[0].finish->phong, 1.0);
}

TEST(ParseMap, AverageHasWeights) {
  const auto pigment = pigment_of("average pigment_map { [rgb x] [2 rgb y] [3, bozo] }");
  ASSERT_TRUE(pigment.pattern->pigments);
  EXPECT_EQ(pigment.pattern->kind, PatternKind::average);
  EXPECT_EQ(pigment.pattern->pigments->entries[0].position, 1.0);
  EXPECT_EQ(pigment.pattern->pigments->entries[1].position, 2.0);
  EXPECT_EQ(pigment.pattern->pigments->entries[2].position, 3.0);
  EXPECT_TRUE(says(pigment_error("average color_map { [0 rgb 1] }"), "'color_map' does not go with 'average'"));
}

TEST(ParseMap, ListsOfPatternedPigmentsArePigmentMaps) {
  const auto pigment = pigment_of("checker pigment { bozo } pigment { rgb 1 }");
  ASSERT_TRUE(pigment.pattern->pigments);
  EXPECT_EQ(pigment.pattern->pigments->entries[0].value.pattern->kind, PatternKind::bozo);
  EXPECT_EQ(pigment.pattern->pigments->entries[1].value.color.rgb, Rgb(1));
}

TEST(ParseMap, UvMappingHoldsOneItem) {
  const auto pigment = pigment_of("uv_mapping checker rgb 1 rgb 0");
  ASSERT_TRUE(pigment.pattern->pigments);
  EXPECT_EQ(pigment.pattern->kind, PatternKind::uv_mapping);
  EXPECT_EQ(pigment.pattern->pigments->entries.at(0).value.pattern->kind, PatternKind::checker);
  EXPECT_EQ(normal_of("uv_mapping bumps 2").normals->entries.at(0).value.amount, 2.0);
  const auto texture = texture_pattern_of("uv_mapping pigment { rgb x }");
  EXPECT_EQ(texture.pattern.kind, PatternKind::uv_mapping);
  EXPECT_EQ(texture.textures->entries.at(0).value->layers[0].pigment.color.rgb, Rgb(1, 0, 0));
}

TEST(ParseMap, MapsGoOnlyWithPatternsThatHaveThem) {
  EXPECT_TRUE(says(pigment_error("checker color_map { [0 rgb 1] }"), "'color_map' does not go with 'checker'"));
  EXPECT_TRUE(says(pigment_error("rgb 1 pigment_map { [0 rgb 1] }"), "does not go with a single colour"));
  EXPECT_TRUE(says(pigment_error("bozo pigment_map { }"), "expected '[' and an entry of the map"));
  EXPECT_TRUE(says(pigment_error("bozo normal_map { [0 bumps] }"), "expected '}'"));
  EXPECT_TRUE(says(errors(load_described("sphere { 0, 1 normal { facets normal_map { [0 bumps] } } }")),
                   "'normal_map' does not go with 'facets'"));
  std::string entries;
  for (int i = 0; i < 257; ++i) entries += "[0 rgb 1]";
  EXPECT_TRUE(says(pigment_error("bozo pigment_map { " + entries + " }"), "at most 256 entries"));
}

TEST(ParseMap, QuickColorIsKept) {
  EXPECT_EQ(pigment_of("bozo quick_color rgb x").pattern->quick_color->rgb, Rgb(1, 0, 0));
  EXPECT_FALSE(pigment_of("bozo").pattern->quick_color);
}

/// A file of the current folder, there while the object lives.
class PictureFile {
 public:
  PictureFile(std::string name, const std::string& bytes) : name_(std::move(name)) {
    std::ofstream(name_, std::ios::binary) << bytes;
  }
  explicit PictureFile(std::string name) : name_(std::move(name)) {
    // A GIF of one pixel and four colours: what a file is, is told by what it contains.
    const unsigned char bytes[] = {'G', 'I', 'F', '8', '9', 'a', 1, 0,   1, 0, 0x81, 0, 0, 0, 0, 0, 90, 90, 90, 180, 180, 180,
                                   255, 255, 255, 0x2c, 0, 0, 0, 0, 1, 0, 1, 0, 0, 2, 2, 0x44, 1, 0, 0x3b};
    std::ofstream(name_, std::ios::binary).write(reinterpret_cast<const char*>(bytes), sizeof(bytes));
  }
  ~PictureFile() {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
  }
  std::string quoted() const { return "\"" + name_ + "\""; }

 private:
  std::string name_;
};

TEST(ParseImage, ImageMapsTellHowTheyAreLaid) {
  const PictureFile file("firstlight_parse_image.png");
  const auto pigment =
      pigment_of("image_map { png " + file.quoted() +
                 " gamma srgb premultiplied on map_type 1 once interpolate 2 filter all 0.5 transmit 3, 0.25 use_index "
                 "repeat <2, 3> offset <0.5, 0> }");
  EXPECT_EQ(pigment.pattern->kind, PatternKind::image_map);
  const render::ImageUse& image = *parameters<render::ImageParameters>(pigment.pattern).image;
  EXPECT_EQ(image.source.format, render::ImageSource::Format::png);
  EXPECT_EQ(image.source.gamma, render::ImageSource::Gamma::srgb);
  EXPECT_TRUE(image.source.premultiplied.value_or(false));
  EXPECT_EQ(image.projection, render::ImageUse::Projection::spherical);
  EXPECT_TRUE(image.once);
  EXPECT_EQ(image.interpolation, render::ImageUse::Interpolation::bilinear);
  EXPECT_EQ(image.filter_all, 0.5);
  EXPECT_EQ(image.transmits.at(0).entry, 3);
  EXPECT_EQ(image.transmits.at(0).value, 0.25);
  EXPECT_EQ(image.part, render::ImageUse::Part::index);
  EXPECT_EQ(image.repeat, render::Vec2(2, 3));
  EXPECT_EQ(image.offset, render::Vec2(0.5, 0));
}

TEST(ParseImage, FormatsAreWordsOrTheExtension) {
  const PictureFile file("firstlight_parse_image.bin");
  using Format = render::ImageSource::Format;
  const std::pair<const char*, Format> formats[] = {
      {"", Format::by_name}, {"bmp", Format::bmp},   {"exr", Format::exr},   {"gif", Format::gif}, {"hdr", Format::hdr},
      {"iff", Format::iff},  {"jpeg", Format::jpeg}, {"pgm", Format::pgm},   {"ppm", Format::ppm},
      {"sys", Format::sys},  {"tga", Format::tga},   {"tiff", Format::tiff}, {"png", Format::png}};
  for (const auto& [word, format] : formats) {
    const auto pigment = pigment_of("image_map { " + std::string(word) + " " + file.quoted() + " }");
    EXPECT_EQ(parameters<render::ImageParameters>(pigment.pattern).image->source.format, format) << word;
  }
}

TEST(ParseImage, ContinuousPotentialsHaveAPaletteAndAnEvenWidth) {
  const PictureFile file("firstlight_parse_potential.bin");
  EXPECT_TRUE(says(pigment_error("image_map { pot " + file.quoted() + " }"), "it is no continuous potential"));
}

TEST(ParseImage, PatternsAndBumpsOfImagesTakeTheNumbersAsTheyAre) {
  const PictureFile file("firstlight_parse_image.tga");
  const auto pigment = pigment_of("image_pattern { tga " + file.quoted() + " use_alpha interpolate 3 }");
  const render::ImageUse& image = *parameters<render::ImageParameters>(pigment.pattern).image;
  EXPECT_EQ(image.part, render::ImageUse::Part::alpha);
  EXPECT_EQ(image.source.gamma, render::ImageSource::Gamma::none);
  EXPECT_EQ(image.interpolation, render::ImageUse::Interpolation::bicubic);
  const auto normal =
      normal_of("bump_map { tga " + file.quoted() + " gamma 1.5 bump_size 3 use_color use_colour map_type 2 }");
  EXPECT_EQ(normal.amount, 3.0);
  EXPECT_EQ(normal.pattern.kind, PatternKind::bump_map);
  EXPECT_EQ(parameters<render::ImageParameters>(normal.pattern).image->source.gamma_exponent, 1.5);
}

TEST(ParseImage, MaterialMapsHoldTextures) {
  const PictureFile file("firstlight_parse_image.gif");
  const auto pattern =
      texture_pattern_of("material_map { gif " + file.quoted() +
                         " once texture { pigment { rgb x } } texture { pigment { rgb y } } } scale 2");
  EXPECT_EQ(pattern.pattern.kind, PatternKind::material_map);
  ASSERT_TRUE(pattern.textures);
  EXPECT_EQ(pattern.textures->entries.at(1).value->layers[0].pigment.color.rgb, Rgb(0, 1, 0));
  EXPECT_EQ(pattern.pattern.warps.steps.size(), 1u);
}

TEST(ParseImage, PicturesMayBeFunctions) {
  const auto pigment = pigment_of("image_map { function 20, 10 { x * y } map_type 5 }");
  const render::ImageUse& image = *parameters<render::ImageParameters>(pigment.pattern).image;
  EXPECT_EQ(image.source.columns, 20u);
  EXPECT_EQ(image.source.rows, 10u);
  EXPECT_TRUE(image.source.function);
  EXPECT_EQ(image.projection, render::ImageUse::Projection::torus);
}

TEST(ParseImage, MistakesAreNamed) {
  const PictureFile file("firstlight_parse_image.ppm");
  const auto error = [&](const std::string& words) {
    return pigment_error("image_map { ppm " + file.quoted() + " " + words + " }");
  };
  EXPECT_TRUE(says(error("map_type 3"), "'map_type' must be 0, 1, 2 or 5"));
  EXPECT_TRUE(says(error("interpolate 1"), "'interpolate' must be 2, 3 or 4"));
  EXPECT_TRUE(says(error("repeat 0"), "must be positive"));
  EXPECT_TRUE(says(error("gamma 0"), "'gamma' must be positive"));
  EXPECT_TRUE(says(pigment_error("image_map { ppm \"there is none.ppm\" }"), "there is none.ppm"));
  EXPECT_TRUE(says(pigment_error("image_map { ppm \"/etc/passwd\" }"), "may not be read"));
  EXPECT_TRUE(says(pigment_error("image_map { }"), "expected the format and name"));
}

TEST(ParseImage, OnlyImageMapsAreStrictAboutTheirProjection) {
  const PictureFile file("firstlight_parse_projection.ppm");
  const auto normal = normal_of("bump_map { ppm " + file.quoted() + " map_type 3 }");
  EXPECT_EQ(parameters<render::ImageParameters>(normal.pattern).image->projection,
            render::ImageUse::Projection::planar);
}

TEST(ParseImage, DensityFilesAreFoundToo) {
  const PictureFile file("firstlight_parse_image.df3", std::string("\0\1\0\1\0\1\x7f", 7));
  const auto pigment = pigment_of("density_file df3 " + file.quoted() + " interpolate 1");
  EXPECT_TRUE(says(parameters<render::DensityFileParameters>(pigment.pattern).path, "firstlight_parse_image.df3"));
  EXPECT_EQ(parameters<render::DensityFileParameters>(pigment.pattern).interpolation, 1);
  EXPECT_TRUE(says(pigment_error("density_file " + file.quoted()), "expected 'df3'"));
  const PictureFile cut("firstlight_parse_cut.df3", "123");
  EXPECT_TRUE(says(pigment_error("density_file df3 " + cut.quoted()), "ends too early"));
}

}  // namespace
}  // namespace firstlight::parser
