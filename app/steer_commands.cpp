#include "app/steer_commands.h"

#include "app/boost_text.h"
#include "app/options.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace firstlight::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kBlanks = " \t\r\n\f\v";

/// Empty is a good outcome, as the other borders have it.
std::string outcome(const std::string& problem, std::string_view text = {}) {
  if (!problem.empty()) return fmt::format("error {}", problem);
  return text.empty() ? "ok" : fmt::format("ok {}", text);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos ? "" : text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

Json json_of(const priority::Boost& boost) {
  Json json{{"name", boost.name}};
  switch (boost.kind) {
    case priority::Boost::Kind::region:
      json["region"] = {boost.region.left, boost.region.top, boost.region.right, boost.region.bottom};
      break;
    case priority::Boost::Kind::object:
      json["object"] = boost.object;
      break;
    case priority::Boost::Kind::light:
      json["light"] = boost.light;
      break;
  }
  json["by"] = boost.by;
  return json;
}

}  // namespace

std::span<const SteerCommands::Row> SteerCommands::rows() {
  static constexpr Row kRows[] = {
      {"scheme", "TEXT", true, &SteerCommands::scheme},
      {"boost", "region X0 Y0 X1 Y1 | object NAME | light N [by N] [as NAME]", true, &SteerCommands::boost},
      {"drop", "NAME | all", true, &SteerCommands::drop},
      {"pause", "", false, &SteerCommands::pause},
      {"resume", "", false, &SteerCommands::resume},
      {"stop", "", false, &SteerCommands::stop},
      {"save", "[FILE]", false, &SteerCommands::save},
      {"status", "", false, &SteerCommands::status},
      {"help", "", false, &SteerCommands::help},
      {"quit", "", false, nullptr},
  };
  return kRows;
}

SteerCommands::Answer SteerCommands::answer(std::string_view line) {
  line = trimmed(line);
  if (line.empty()) return {};
  const std::string_view name = line.substr(0, line.find_first_of(kBlanks));
  const std::string_view text = trimmed(line.substr(name.size()));
  const auto row = std::ranges::find(rows(), name, &Row::name);
  if (row == rows().end()) {
    return {unknown(name)};
  }
  if (row->needs_more && text.empty()) return {fmt::format("error expected {} {}", row->name, row->parameters)};
  if (row->parameters.empty() && !text.empty()) {
    return {one_line(fmt::format("error expected nothing after '{}', found '{}'", name, text))};
  }
  if (row->run == nullptr) return {"ok", /*goodbye=*/true};
  return {one_line((this->*row->run)(text))};
}

std::string SteerCommands::unknown(std::string_view name) {
  // Garbage is not repeated.
  const bool is_word =
      name.size() <= 40 && std::ranges::all_of(name, [](unsigned char c) { return c > ' ' && c < 0x7f; });
  if (!is_word) return "error there is no such command; help lists all";
  std::vector<std::string> known;
  for (const Row& command : rows()) known.emplace_back(command.name);
  const std::string near = nearest(std::string(name), known);
  return fmt::format("error there is no command '{}'; {}", name,
                     near.empty() ? "help lists all" : fmt::format("the nearest is '{}'", near));
}

std::string SteerCommands::scheme(std::string_view text) { return outcome(steering_.set_scheme(text)); }

std::string SteerCommands::boost(std::string_view text) {
  std::string problem;
  const auto boost = parse_boost(text, steering_.order().boosts(), problem);
  if (boost) problem = steering_.boost(*boost);
  return outcome(problem, boost ? boost_text(*boost) : "");
}

std::string SteerCommands::drop(std::string_view text) {
  if (text == "all") {
    steering_.drop_all();
    return outcome({});
  }
  return outcome(steering_.drop(text) ? "" : fmt::format("there is no boost '{}'", text));
}

std::string SteerCommands::pause(std::string_view) {
  steering_.pause();
  return outcome({});
}

std::string SteerCommands::resume(std::string_view) {
  steering_.resume();
  return outcome({});
}

std::string SteerCommands::stop(std::string_view) {
  steering_.stop();
  return outcome({});
}

std::string SteerCommands::save(std::string_view text) { return outcome(desk_.save_to(std::string(text))); }

std::string SteerCommands::status(std::string_view) { return outcome({}, status_json(desk_.latest(), steering_)); }

std::string SteerCommands::help(std::string_view) {
  std::string text;
  for (const Row& row : rows()) {
    text +=
        fmt::format("{}{}{}{}", text.empty() ? "" : "; ", row.name, row.parameters.empty() ? "" : " ", row.parameters);
  }
  return outcome({}, text);
}

std::string status_json(const priority::Progress& progress, const priority::Steering& steering) {
  const priority::Order order = steering.order();
  const render::RayCounts& rays = progress.traced;
  Json boosts = Json::array();
  for (const priority::Boost& boost : order.boosts()) boosts.push_back(json_of(boost));
  const Json json{{"seconds", progress.seconds},
                  {"rays",
                   {{"primary", rays.of(render::RayKind::primary)},
                    {"reflection", rays.of(render::RayKind::reflection)},
                    {"transmission", rays.of(render::RayKind::transmission)},
                    {"shadow", rays.of(render::RayKind::shadow)}}},
                  {"waiting", progress.rays_waiting},
                  {"bytes", progress.queue_bytes},
                  {"tiles_done", progress.tiles_done},
                  {"tiles", progress.tiles},
                  {"key", progress.key},
                  {"remaining", progress.remaining},
                  {"remaining_is_bound", progress.remaining_is_bound},
                  {"scheme", order.text()},
                  {"boosts", std::move(boosts)},
                  {"paused", steering.paused()},
                  {"stopped", steering.stopped()}};
  // A path or text that is not UTF-8 must not cost the answer.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string one_line(std::string_view text) {
  std::string line(text.substr(0, text.find('\n')));
  std::ranges::replace_if(
      line, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  return line;
}

}  // namespace firstlight::app
