#include "tests/golden/random_scene.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace firstlight::golden {
namespace {

/// Numbers that are the same on every machine: SplitMix64.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u) {}

  std::uint64_t below(std::uint64_t end) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (z ^ (z >> 31)) % end;
  }
  bool one_of(std::uint64_t n) { return below(n) == 0; }
  /// With three digits after the point.
  double between(double low, double high) {
    const auto steps = static_cast<std::uint64_t>((high - low) * 1000.0);
    return low + 0.001 * static_cast<double>(below(steps + 1));
  }

 private:
  std::uint64_t state_;
};

/// Writes one scene.
class Writer {
 public:
  explicit Writer(std::uint64_t seed) : dice_(seed) {}

  std::string scene() {
    text_ =
        "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 6 }\n"
        "#default { finish { ambient 0.2 diffuse 0.6 } }\n";
    const double away = dice_.one_of(8) ? 0.4 : 6.0;
    write("camera { location ").near(away, 0.3).write(" look_at ").vector(0.3).write(" angle 50 right x*4/3 }\n");
    write("background { rgb ").color().write(" }\n");
    for (std::uint64_t lights = 1 + dice_.below(2); lights > 0; --lights) {
      write("light_source { ").near(12.0, 4.0).write(", rgb ").color().write(" }\n");
    }
    if (dice_.one_of(2)) {
      write("plane { y, -2.5 pigment { checker rgb ").color().write(" rgb ").color().write(" } }\n");
    }
    for (std::uint64_t objects = 1 + dice_.below(4); objects > 0; --objects) {
      object(static_cast<int>(1 + dice_.below(4)), true);
    }
    return std::move(text_);
  }

 private:
  // One after the other: the order in which arguments of one call are worked out is the compiler's choice.
  Writer& write(std::string_view text) {
    text_ += text;
    return *this;
  }
  Writer& number(double low, double high) { return write(fmt::format("{:.3f}", dice_.between(low, high))); }
  Writer& vector(double reach) { return triple(-reach, reach); }
  Writer& color() { return triple(0.0, 1.0); }
  Writer& triple(double low, double high) {
    return write("<").number(low, high).write(", ").number(low, high).write(", ").number(low, high).write(">");
  }
  /// A point at about this distance from the middle, above it and in front.
  Writer& near(double away, double spread) {
    write("<").number(-0.5 * away - spread, 0.5 * away + spread).write(", ").number(0.1 * away, 0.6 * away + spread);
    return write(fmt::format(", {:.3f}>", -away));
  }

  void object(int levels, bool may_be_patch) {
    if (levels == 0 || dice_.one_of(4)) {
      shape(may_be_patch);
    } else {
      constexpr std::array<std::string_view, 5> kWords = {"union", "merge", "intersection", "difference",
                                                          "intersection"};
      const std::string_view word = kWords[dice_.below(kWords.size())];
      write(word).write(" {\n");
      for (std::uint64_t members = 2 + dice_.below(3); members > 0; --members) object(levels - 1, word == "union");
    }
    modifiers();
    write("}\n");
  }

  /// Up to its modifiers.
  void shape(bool may_be_patch) {
    switch (dice_.below(may_be_patch ? 9 : 8)) {
      case 0:
        write("box { ").vector(1.5).write(", ").vector(1.5);
        break;
      case 1:
        write("cylinder { ").vector(1.5).write(", ").vector(1.5).write(", ").number(0.2, 1.2).maybe_open();
        break;
      case 2:
        write("cone { ").vector(1.5).write(", ").number(0.0, 1.2);
        write(", ").vector(1.5).write(", ").number(0.1, 1.0).maybe_open();
        break;
      case 3:
        write("torus { ").number(0.6, 1.4).write(", ").number(0.1, 0.5);
        break;
      case 4:
        write("plane { ").direction().write(", ");
        dice_.one_of(3) ? write("0") : number(-0.5, 1.0);
        break;
      case 5:
        write("disc { ").vector(1.0).write(", ").direction().write(", ").number(0.4, 1.6);
        break;
      case 6:
      case 7:
        write("sphere { ").vector(1.0).write(", ").number(0.4, 1.5);
        break;
      default:
        write("triangle { ").vector(2.0).write(", ").vector(2.0).write(", ").vector(2.0);
    }
    write("\n");
  }
  Writer& maybe_open() { return write(dice_.one_of(4) ? " open" : ""); }
  Writer& direction() {
    static constexpr std::array<std::string_view, 6> kAxes = {"x", "y", "z", "-x", "-y", "-z"};
    return dice_.one_of(2) ? write(kAxes[dice_.below(kAxes.size())]) : vector(1.0);
  }

  void modifiers() {
    if (dice_.one_of(2)) texture();
    if (dice_.one_of(8)) {
      write("clipped_by { ");
      shape(false);
      write("} }\n");
    }
    if (dice_.one_of(12)) write("inverse\n");
    if (dice_.one_of(6)) write("scale ").triple(0.5, 1.5).write("\n");
    if (dice_.one_of(3)) write("rotate ").vector(180.0).write("\n");
    if (dice_.one_of(4)) write("translate ").vector(0.8).write("\n");
  }

  void texture() {
    write("pigment { rgb ").color();
    switch (dice_.below(5)) {
      case 0:
        write(" transmit ").number(0.3, 0.9).write(" } interior { ior ").number(1.0, 1.6).write(" }\n");
        break;
      case 1:
        write(" filter ").number(0.3, 0.9).write(" }\n");
        break;
      case 2:
        write(" } finish { reflection ").number(0.1, 0.8).write(" }\n");
        break;
      default:
        write(" }\n");
    }
  }

  Dice dice_;
  std::string text_;
};

}  // namespace

std::string random_csg_scene(std::uint64_t seed) { return Writer(seed).scene(); }

}  // namespace firstlight::golden
