#pragma once

#include "parser/directive/scene_context.h"
#include "parser/expression/evaluator.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace firstlight::parser {

class DataReader;

/// Obeys the directives of the language: declarations, conditions, loops, macros, included files. Reader is its face
/// towards the statements.
///
/// Errors   Throws SyntaxError.
/// Limits   Steps, that is turns of loops and calls of macros, are bounded by kMostSteps: an endless loop ends with a
/// message.
class Interpreter final : public Evaluator {
 public:
  static constexpr std::size_t kDeepestInclude = 64;
  static constexpr std::size_t kMostElements = 1u << 24;  // in one array
  static constexpr std::size_t kDeepestArray = 20;        // of arrays in arrays
  static constexpr std::uint64_t kMostSteps = 100'000'000;
  static constexpr std::size_t kMostMistakes = 20;         // told of in one run
  static constexpr std::size_t kMostFailures = 500;        // with those that follow from others
  static constexpr std::uint64_t kMostWritten = 1u << 30;  // bytes, by all of a scene's #write; with what it appends to
  static constexpr std::size_t kMostFiles = 1000;          // that a scene writes

  Interpreter(const render::LoadOptions& options, render::Diagnostics& diagnostics, SceneContext& context);

  void open_scene(const std::string& path);
  /// At the end of the scene: what POV-Ray says about version and gamma, and the settings that follow.
  void finish();

  /// After a mistake in a statement of the scene: tells of it, unless it is only the consequence of another, and goes
  /// on at the next statement. Throws it again when that is not possible.
  void recover(const SyntaxError& error);
  bool has_failed() const { return failures_ > 0; }

  // --- what expressions and statements ask for ----------------------------------------------------------------------
  /// `assumed_gamma`; false when an earlier one holds.
  bool set_assumed_gamma(render::WorkingGamma gamma, double exponent = 1.0) {
    return language_.set_assumed_gamma(gamma, exponent);
  }
  /// The path of the file that the scene calls `name`, such as an image or a font; `extensions`, with their dots, may
  /// be left out in the name. Fails at `at` when there is none, or none that may be read.
  std::string find_file(const std::string& name, const std::vector<std::string>& extensions, const Location& at);
  /// An old directive without `#`: `declare`, `include`, `version`.
  void run_bare_directive();

 private:
  /// A loop or a choice whose `#end` has not been reached.
  struct Condition {
    enum class Kind { if_, while_, for_, switch_ };
    Kind kind = Kind::if_;
    const Token* word = nullptr;      // of its first directive
    std::size_t frame = 0;            // depth of the frame it is in
    std::uint32_t hash = 0;           // of its first directive; of #switch: of the case that applies
    std::uint32_t body = 0;           // of #for: behind its parentheses
    Scopes::Slot variable = nullptr;  // of #for
    double end = 0.0, step = 0.0;
  };
  /// Where pick_part() has come to.
  struct Part {
    std::shared_ptr<Array> array;  // the innermost; null for a dictionary
    std::uint32_t level = 0;       // arrays and dictionaries around it; 0: it is none's part
  };
  /// What `#declare` writes to.
  struct Target {
    Token name;
    Scopes::Slot slot;
    Part part;              // when it is a part of an array or a dictionary
    bool optional = false;  // of several: may get no value
  };
  /// A value, and the slot of the name that it was read from, when it was a single name.
  struct Argument {
    Value value;
    Scopes::Slot reference;
    std::uint32_t scope = 0;
    bool needs_semicolon = false;
  };

  // directive.cpp
  void read_permissions();
  void run_directive() override;
  void obey(const Token& word, std::uint32_t hash);
  // version_directive.cpp
  void run_version(const Token& word, bool first);
  void change_defaults(const Token& word);
  void run_message(const Token& word);
  void run_undef(const Token& word);
  void run_include(const Token& word);
  const SourceFiles::Result& found_file(const SourceFiles::Result& result, const std::string& name, const Location& at);
  const TokenFile& tokens_of(const SourceFile& file);
  void count_step(const Location& at);
  // conditional.cpp
  bool condition_holds();
  void run_if(const Token& word, std::uint32_t hash);
  void run_further_branch(const Token& word, std::uint32_t hash);
  void run_switch(const Token& word, std::uint32_t hash);
  bool case_applies(Keyword word, double value);
  void run_while(const Token& word, std::uint32_t hash);
  void run_for(const Token& word, std::uint32_t hash);
  void run_end(const Token& word, std::uint32_t hash);
  void run_break(const Token& word);
  std::uint32_t end_of_block(std::uint32_t hash) const;
  std::uint32_t next_branch(std::uint32_t hash, const Token& word);
  std::uint32_t find_branch(std::uint32_t index) const;
  void skip_to_end(std::uint32_t hash, const Token& word);
  [[noreturn]] void fail_unclosed(const Token& word);
  bool in_choice(Condition::Kind kind) const;
  void go_behind(std::uint32_t end);
  bool for_continues(const Condition& loop) const;
  bool turn_again(Condition& loop, const Token& word);
  bool in_block() const { return !conditions_.empty() && conditions_.back().frame == frames_.size(); }
  void check_same_frame(std::size_t frames, const Token& word);
  // macro.cpp
  void define_macro(const Token& word, std::uint32_t hash);
  void call_macro(const Token& name, std::shared_ptr<const Macro> macro) override;
  // declare.cpp
  void run_declare(const Token& word, bool after_hash);
  bool declare_by_formula(const Token& word);
  void check_semicolon(const Target& target, const Token& word);
  void store(const Target& target, Value value);
  Target parse_target(const Token& word);
  Argument parse_argument(bool parameter);
  Value parse_statement_value();
  const Token& take_identifier(const Token& word, Scopes::Reach reach = Scopes::Reach::any);
  // several_declare.cpp
  void run_several_declare(const Token& word);
  std::vector<Target> parse_targets(const Token& word, Punctuation closing);
  void store_tuple(const std::vector<Target>& targets);
  void store_components(const std::vector<Target>& targets);
  void store_elements(const std::vector<Target>& targets);
  // array.cpp
  Scopes::Slot pick_part(const Scopes::Slot& container, const Token& name, Pick purpose) override;
  Scopes::Slot pick_element(const std::shared_ptr<Array>& array, const Token& name, Pick purpose);
  [[noreturn]] void fail_without_value(const Token& name);
  std::size_t parse_subscripts(const Array& array, const Token& name);
  Value parse_array();
  void parse_initializer(Array& array, std::size_t dimension, std::size_t& element, const Token& owner);
  bool next_is_left_out();
  void parse_element(Array& array, std::size_t element);
  void check_element(Array& array, const Value& value, const Location& at);
  void check_depth(std::uint32_t level, const Value& value, const Location& at);
  void grow(Array& array, std::size_t size, const Location& at);
  // dictionary.cpp
  Value parse_dictionary(const Token& word);
  std::string parse_key() override;
  Scopes::Slot pick_entry(const std::shared_ptr<Dictionary>& dictionary, const Token& name, Pick purpose);
  Scopes::Slot add_entry(Dictionary& dictionary, const std::string& key, const Location& at);
  // file_directive.cpp
  void run_fopen(const Token& word);
  void run_fclose(const Token& word);
  void run_read(const Token& word);
  void run_write(const Token& word);
  std::shared_ptr<DataFile> take_data_file(const Token& word, Token& name);
  const SourceFile* open_for_reading(const std::string& path, const Location& at);
  void check_place(const std::string& path, const std::string& name, bool append, const Location& at);
  void count_written(std::uint64_t bytes, const Location& at);
  void close_data_file(DataFile& file, const Location& at);
  void close_data_files();
  void discard_data_files();
  std::optional<Value> parse_datum(DataReader& data);
  double parse_data_number(DataReader& data);

  // recovery.cpp
  bool is_consequence(const SyntaxError& error) const;
  void report_mistake(const SyntaxError& error);
  std::string standard_file_hint(std::string_view name) const;
  [[noreturn]] void give_up();
  std::uint32_t next_statement(std::uint32_t start, std::uint32_t reached) const;
  bool may_begin_statement(std::uint32_t index) const;
  void note_broken_names(std::uint32_t begin, std::uint32_t end);
  // progress.cpp
  void look_around() override;
  // memory.cpp
  void charge(const Value& value, const Location& at);

  SceneContext& context_;
  std::vector<std::unique_ptr<TokenFile>> token_files_;  // by SourceFile::index
  std::size_t tokens_cut_ = 0;                           // in all of them
  std::vector<Condition> conditions_;
  Part picked_;                          // by the last pick_part()
  std::vector<Scopes::Slot> arguments_;  // of the macros whose arguments are being read
  std::vector<std::weak_ptr<DataFile>> written_files_;
  std::uint64_t written_bytes_ = 0;
  std::set<std::string> made_files_;
  std::uint64_t steps_ = 0;
  // Mistakes so far, and what their consequences are known by.
  std::size_t mistakes_ = 0, failures_ = 0;
  bool include_failed_ = false;
  std::set<std::tuple<std::string, std::size_t, std::size_t>> reported_places_;  // file, line, column
  std::set<std::uint32_t> broken_names_;
  // Bytes of strings, arrays and dictionaries made since they were counted, with what was counted then.
  std::size_t charged_ = 0, next_count_ = 0;
  // For ParseProgress.
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_ = Clock::now(), last_told_ = began_;
};

}  // namespace firstlight::parser
