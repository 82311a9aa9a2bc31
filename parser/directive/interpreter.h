#pragma once

#include "parser/directive/conditions.h"
#include "parser/directive/containers.h"
#include "parser/directive/data_files.h"
#include "parser/directive/declarations.h"
#include "parser/directive/macros.h"
#include "parser/directive/recovery.h"
#include "parser/directive/scene_context.h"
#include "parser/directive/value_memory.h"
#include "parser/expression/evaluator.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace firstlight::parser {

/// Obeys the directives of the language. Each kind has a part of its own, to which a directive is handed; what is left
/// here are files, versions and messages. Reader is its face towards the statements.
///
/// Errors   Throws SyntaxError.
/// Limits   Steps, that is turns of loops and calls of macros, are bounded by kMostSteps: an endless loop ends with a
/// message.
class Interpreter final : public Evaluator {
 public:
  static constexpr std::size_t kDeepestInclude = 64;
  static constexpr std::uint64_t kMostSteps = 100'000'000;

  Interpreter(const render::LoadOptions& options, render::Diagnostics& diagnostics, SceneContext& context);

  void open_scene(const std::string& path);
  /// At the end of the scene: what POV-Ray says about version and gamma, and the settings that follow.
  void finish();

  /// The path of the file that the scene calls `name`, such as an image or a font; `extensions`, with their dots, may
  /// be left out in the name. Fails at `at` when there is none, or none that may be read.
  std::string find_file(const std::string& name, const std::vector<std::string>& extensions, const Location& at);
  /// An old directive without `#`: `declare`, `include`, `version`.
  void run_bare_directive();

  SceneContext& context() { return context_; }

  // --- its parts ----------------------------------------------------------------------------------------------------
  Conditions& conditions() { return conditions_; }
  Containers& containers() { return containers_; }
  DataFiles& data_files() { return data_files_; }
  Declarations& declarations() { return declarations_; }
  Recovery& recovery() { return recovery_; }
  ValueMemory& memory() { return memory_; }

  // --- what they have in common -------------------------------------------------------------------------------------
  /// The name that the directive `word` is about.
  Token take_identifier(const Token& word, Scopes::Reach reach = Scopes::Reach::any);
  /// Says what is wrong when the file was not found, or not by that name.
  const SourceFiles::Result& found_file(const SourceFiles::Result& result, const std::string& name, const Location& at);
  /// At each turn of a loop and call of a macro.
  void count_step(const Location& at);

 private:
  void look_around() override;
  void run_directive() override;
  void call_macro(const Token& name, std::shared_ptr<const Macro> macro) override;
  Scopes::Slot pick_part(const Scopes::Slot& container, const Token& name, Pick purpose) override;
  std::string parse_key() override;

  void obey(const Token& word, std::uint32_t hash);
  void run_undef(const Token& word);
  void run_message(const Token& word);
  // source_files.cpp
  void read_permissions();
  void run_include(const Token& word);
  const TokenFile& tokens_of(const SourceFile& file);
  // version_directive.cpp
  void run_version(const Token& word, bool first);
  void change_defaults(const Token& word);

  SceneContext& context_;
  Conditions conditions_{*this};
  Containers containers_{*this};
  DataFiles data_files_{*this};
  Declarations declarations_{*this};
  Macros macros_{*this};
  Recovery recovery_{*this};
  ValueMemory memory_{*this};
  std::vector<std::unique_ptr<TokenFile>> token_files_;  // by SourceFile::index
  std::uint64_t steps_ = 0;
  // For ParseProgress.
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_ = Clock::now(), last_told_ = began_;
};

}  // namespace firstlight::parser
