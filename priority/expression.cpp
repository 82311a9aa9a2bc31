#include "priority/log_scale.h"
#include "priority/object_names.h"
#include "priority/pixels.h"
#include "priority/schemes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace firstlight::priority {
namespace {

using render::RayKind;
using render::RayTask;

/// Keys that grow with a number of either sign: 16 to an octave from 2^-32 to 2^32. What has no value gets key 0.
class SignedScale {
 public:
  static constexpr Key count() { return 2 * kSide + 1; }
  static Key of(double number) {
    if (std::isnan(number)) return 0;
    const Key side = kMagnitudes.of(static_cast<float>(std::min(std::abs(number), kLargest)));
    // The first step of the scale is zero, and what is as good as that.
    return number < 0.0 ? kSide - side : kSide + side;
  }

 private:
  static constexpr double kLargest = 1e30;
  static constexpr LogScale kMagnitudes{-32, 32, 4};
  static constexpr Key kSide = kMagnitudes.count() - 1;
};

/// An attribute of a ray that an expression may ask for.
struct Attribute {
  std::string_view name;
  double (*of)(const RayTask& task, const SchemeInput& input, const Pixels& pixels);
  bool of_pixel = false;  ///< differs from one primary ray to another
};

render::Rgb weight_of(const RayTask& task) {
  if (task.kind != RayKind::shadow) return task.weight();
  render::Rgb sum(0.0f);
  task.for_each_feeler([&](std::uint32_t, const render::PackedRgb& light) { sum += light.unpack(); });
  return sum;
}

const render::Light* light_of(const RayTask& task, const SchemeInput& input) {
  const std::span<const render::Light> lights = input.scene.lights;
  const bool known = task.kind == RayKind::shadow && task.first_light() < lights.size();
  return known ? &lights[task.first_light()] : nullptr;
}

constexpr Attribute kAttributes[] = {
    {"weight",
     [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return render::max_magnitude(weight_of(t)); }},
    {"red", [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return weight_of(t).x; }},
    {"green", [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return weight_of(t).y; }},
    {"blue", [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return weight_of(t).z; }},
    {"level", [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return t.level; }},
    {"type", [](const RayTask& t, const SchemeInput&, const Pixels&) { return static_cast<double>(t.kind); }},
    {"cost", [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return t.ray_count(); }},
    {"x", [](const RayTask& t, const SchemeInput&, const Pixels& pixels) -> double { return pixels.x(t); }, true},
    {"y", [](const RayTask& t, const SchemeInput&, const Pixels& pixels) -> double { return pixels.y(t); }, true},
    {"width", [](const RayTask&, const SchemeInput& input, const Pixels&) -> double { return input.width; }},
    {"height", [](const RayTask&, const SchemeInput& input, const Pixels&) -> double { return input.height; }},
    {"sample", [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return t.sample; }, true},
    {"object", [](const RayTask& t, const SchemeInput&, const Pixels&) -> double { return t.object; }},
    {"distance",
     [](const RayTask& t, const SchemeInput& input, const Pixels&) { return (t.origin - input.scene.eye).length(); }},
    {"light", [](const RayTask& t, const SchemeInput&,
                 const Pixels&) { return t.kind == RayKind::shadow ? static_cast<double>(t.first_light()) : -1.0; }},
    {"light_distance",
     [](const RayTask& t, const SchemeInput& input, const Pixels&) {
       const render::Light* light = light_of(t, input);
       return light != nullptr ? render::reach_to(*light, t.origin) : 0.0;
     }},
    {"light_intensity",
     [](const RayTask& t, const SchemeInput& input, const Pixels&) -> double {
       const render::Light* light = light_of(t, input);
       return light != nullptr ? render::grey(light->color) : 0.0;
     }},
    // The kinds of ray, to compare `type` with.
    {"primary",
     [](const RayTask&, const SchemeInput&, const Pixels&) { return static_cast<double>(RayKind::primary); }},
    {"reflection",
     [](const RayTask&, const SchemeInput&, const Pixels&) { return static_cast<double>(RayKind::reflection); }},
    {"transmission",
     [](const RayTask&, const SchemeInput&, const Pixels&) { return static_cast<double>(RayKind::transmission); }},
    {"shadow", [](const RayTask&, const SchemeInput&, const Pixels&) { return static_cast<double>(RayKind::shadow); }},
};
constexpr std::size_t kAttributeCount = std::size(kAttributes);

/// By the value of a user's expression: larger ones first.
class Expression final : public Scheme {
 public:
  /// `objects`: for each parameter of the program beyond the attributes, which groups of objects it is true for.
  Expression(const SchemeInput& input, std::shared_ptr<const render::Program> program,
             std::vector<std::vector<bool>> objects)
      : input_(input), pixels_(input), program_(std::move(program)), objects_(std::move(objects)) {
    used_.resize(program_->parameter_count());
    for (const render::Instruction& instruction : program_->instructions()) {
      if (instruction.operation == render::Operation::parameter) used_[instruction.index] = true;
    }
  }

  void keys(std::span<const RayTask> tasks, std::span<Key> keys) const override {
    constexpr std::size_t kChunk = 128;
    std::vector<std::array<double, kChunk>> columns(used_.size());
    std::vector<std::span<const double>> arguments(used_.size());
    std::array<double, kChunk> values;
    for (std::size_t begin = 0; begin < tasks.size(); begin += kChunk) {
      const auto chunk = tasks.subspan(begin, std::min(kChunk, tasks.size() - begin));
      for (std::size_t p = 0; p < used_.size(); ++p) {
        if (!used_[p]) continue;
        for (std::size_t i = 0; i < chunk.size(); ++i) columns[p][i] = value(p, chunk[i]);
        arguments[p] = std::span<const double>(columns[p]).first(chunk.size());
      }
      program_->evaluate(arguments, std::span(values).first(chunk.size()));
      for (std::size_t i = 0; i < chunk.size(); ++i) keys[begin + i] = SignedScale::of(values[i]);
    }
  }
  Key key_count() const override { return SignedScale::count(); }
  bool tells_pixels_apart() const override {
    for (std::size_t p = 0; p < kAttributeCount; ++p) {
      if (used_[p] && kAttributes[p].of_pixel) return true;
    }
    return false;
  }

 private:
  double value(std::size_t parameter, const RayTask& task) const {
    if (parameter < kAttributeCount) return kAttributes[parameter].of(task, input_, pixels_);
    const std::vector<bool>& groups = objects_[parameter - kAttributeCount];
    return task.object < groups.size() && groups[task.object] ? 1.0 : 0.0;
  }

  SchemeInput input_;
  Pixels pixels_;
  std::shared_ptr<const render::Program> program_;
  std::vector<std::vector<bool>> objects_;
  std::vector<bool> used_;  ///< by parameter
};

/// Whether `word` occurs in `text` as a word of its own.
bool occurs(std::string_view word, std::string_view text) {
  const auto is_part = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_part(text[at - 1])) && (end == text.size() || !is_part(text[end]))) return true;
  }
  return false;
}

}  // namespace

SchemePtr make_expression(const SchemeInput& input, SchemeText* arguments) {
  if (arguments == nullptr) throw MissingArguments{"an expression: expr(weight*(level < 3))"};
  const Piece text = arguments->rest_of_parenthesis();
  if (!input.compile) arguments->fail(text, "there are no expressions here");
  std::vector<std::string_view> parameters;
  for (const Attribute& attribute : kAttributes) parameters.push_back(attribute.name);
  std::vector<std::vector<bool>> objects;
  for (const std::string_view word : object_words(input.scene.objects)) {
    if (!occurs(word, text.text) || std::ranges::find(parameters, word) != parameters.end()) continue;
    parameters.push_back(word);
    std::vector<bool>& groups = objects.emplace_back();
    for (const render::ObjectGroup& group : input.scene.objects) groups.push_back(is_called(group, word));
  }
  const render::CompileResult compiled = input.compile(text.text, parameters);
  if (!compiled.program) throw SchemeError{text.at + compiled.at, compiled.length, compiled.error};
  return std::make_shared<Expression>(input, compiled.program, std::move(objects));
}

}  // namespace firstlight::priority
