#pragma once

#include "parser/text/scope.h"
#include "parser/text/source.h"
#include "parser/text/syntax_error.h"
#include "parser/text/token_file.h"
#include "render/scene/front_end.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace firstlight::parser {

/// The scene as one stream of significant tokens, over a stack of token ranges: the scene's file, included files, macro
/// bodies. What to do at a directive or at a macro's name is the Interpreter's part.
///
/// Order    A directive is obeyed, and a macro called, when peek() comes to it: not before, and once.
/// Limits   Depths are bounded (the constants below), so that no scene can exhaust the stack.
class TokenStream {
 public:
  static constexpr std::size_t kDeepestBlock = 200;  // of braces; POV-Ray has the same limit
  static constexpr std::size_t kDeepestExpression =
      250;                                            // of parentheses, arguments, values being declared, directives
  static constexpr std::size_t kDeepestFrame = 1000;  // of macros and included files

  TokenStream(const render::LoadOptions& options, render::Diagnostics& diagnostics)
      : options_(options), diagnostics_(diagnostics) {}
  TokenStream(const TokenStream&) = delete;
  TokenStream& operator=(const TokenStream&) = delete;

  // --- tokens -------------------------------------------------------------------------------------------------------
  // They are given by value, because a file may give up the page that they lie on.
  Token peek() {
    if (!settled_ || pending_) settle();
    return *next_;
  }
  Token take() {
    if (!settled_ || pending_) settle();
    settled_ = false;
    pending_ = false;
    last_ = next_->location;
    count(next_->keyword);
    if (++taken_ % kTokensBetweenLooks == 0) look_around();
    return *next_;
  }
  /// The declared value of the name that peek() gives, or of the array's element it picks; null for any other token.
  const Value* peek_value() { return peek().kind == TokenKind::identifier ? next_value_ : nullptr; }
  /// The place of that value and the scope of the name. Pre: peek_value().
  Scopes::Binding peek_binding() const;
  /// Takes that name, whatever it is declared as.
  Scopes::Binding take_binding();
  /// A word of the language after 3.7, which is reserved only where nothing has that name: whether it is next; takes
  /// it.
  bool next_is_word(std::string_view word);
  bool accept_word(std::string_view word);
  /// Tokens taken so far; tells whether an expression was a single name.
  std::uint64_t taken() const { return taken_; }
  /// Takes `mark`; the message says "expected ')' `purpose` 'name', found ...".
  void expect(Punctuation mark, std::string_view purpose, std::string_view name = {}) {
    if (!peek().is(mark)) fail_expected(mark, purpose, name);
    take();
  }

  struct HoldState {
    bool held = false;
    std::size_t blocks = 0;  ///< open ones when it began
  };
  /// While one lives, peek() stops at a directive or macro instead of obeying it: POV-Ray reads the token behind a
  /// declared value so, for the declaration must be complete before the next directive is obeyed. In blocks that are
  /// opened meanwhile directives are obeyed as ever.
  class Hold {
   public:
    explicit Hold(TokenStream& stream) : Hold(stream, true) {}
    ~Hold() { stream_.hold_ = before_; }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   protected:
    Hold(TokenStream& stream, bool held) : stream_(stream), before_(stream.hold_) {
      stream.hold_ = {held, stream.blocks_.size()};
    }

   private:
    TokenStream& stream_;
    HoldState before_;
  };
  /// The opposite: where an operand is due, directives and macros may always give it.
  struct Release : Hold {
    explicit Release(TokenStream& stream) : Hold(stream, false) {}
  };
  /// One level of expressions; fails beyond kDeepestExpression.
  class Nesting {
   public:
    explicit Nesting(TokenStream& stream) : stream_(stream) {
      if (stream_.nesting_ >= kDeepestExpression) stream_.fail_nesting();
      ++stream_.nesting_;
    }
    ~Nesting() { --stream_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    TokenStream& stream_;
  };

  // --- blocks -------------------------------------------------------------------------------------------------------
  void open_block(const Token& owner) {
    if (!peek().is(Punctuation::left_brace) || blocks_.size() >= kDeepestBlock) fail_block(owner);
    take();
    blocks_.push_back(owner);
  }
  void close_block() {
    if (!peek().is(Punctuation::right_brace)) fail_unclosed_block();
    take();
    blocks_.pop_back();
  }

  // --- messages -----------------------------------------------------------------------------------------------------
  [[noreturn]] void fail(const Location& at, std::string message);
  [[noreturn]] void fail(const Location& at, std::string message, const Location& note_at, std::string note);
  /// The same about something after which the scene cannot be read on, such as a limit.
  [[noreturn]] void fail_finally(const Location& at, std::string message);
  /// The same about an end that has no beginning.
  [[noreturn]] void fail_unbalanced(const Location& at, std::string message);
  void warn(const Location& at, std::string message) {
    report(at, std::move(message), render::Diagnostic::Severity::warning);
  }
  void report(const Location& at, std::string message, render::Diagnostic::Severity severity);
  /// "'blob' cannot be rendered by this version of Firstlight", at its place.
  render::Diagnostic describe_unrendered(const render::FeatureUse& use) const;
  /// The reserved words taken so far, and how often each was.
  std::map<std::string, std::uint64_t> keyword_counts() const;
  /// For messages: the token, and why it has no meaning if it is an undeclared name.
  std::string describe_next();
  /// "; did you mean 'sphere'?", or nothing when no reserved word and no declared name is like `word`.
  std::string suggestion(std::string_view word) const;
  void report(const render::Diagnostic& message);
  // The error for those: a mistake, and notes of the macros and included files on the way to it.
  SyntaxError error_at(const Location& at, std::string message);
  void add_call_chain(render::Diagnostics& messages) const;
  /// Just behind the token that was taken last.
  Location behind_last_token() const;
  render::Diagnostic diagnostic(const Location& at, render::Diagnostic::Severity severity, std::string message) const;

  // --- the text itself, for directives ------------------------------------------------------------------------------
  /// A token range that is being read. `macro` is null for a file.
  struct Frame {
    const TokenFile* file = nullptr;
    std::uint32_t position = 0;
    std::uint32_t end = 0;
    std::shared_ptr<const Macro> macro;
    Location call;  ///< of the macro's name, or of the #include
  };
  const std::vector<Frame>& frames() const { return frames_; }
  Frame& frame() { return frames_.back(); }
  const Frame& frame() const { return frames_.back(); }
  void enter_frame(Frame frame);
  void leave_frame();
  /// Goes on behind the directive whose `#` is at `hash`, and its word.
  void go_behind(std::uint32_t hash) { frames_.back().position = hash + 2; }
  /// The next token as it stands in the text, directives and macros too; takes it.
  Token raw_next() const { return frames_.back().file->view(frames_.back().position); }
  Token take_raw();
  /// Takes the `local.` or `global.` that stands before a name, if any; of `local["Name"]` the word.
  Scopes::Reach take_reach();
  /// Takes the token behind that, mostly a name. One that a string gives is made a token.
  Token take_prefixed(Scopes::Reach reach);
  /// Gives up the token that peek() has shown, if any, so that reading goes on before it.
  void unsettle() {
    if (settled_) frames_.back().position = next_index_;
    settled_ = false;
    pending_ = false;
  }
  /// There is a turn of a loop or a call of a macro.
  void note_replay() { replays_ = true; }
  /// Text ahead in a frame, from the next token on.
  struct Text {
    const TokenFile* file = nullptr;
    std::uint32_t begin = 0, end = 0;
  };
  /// The text ahead, when it may be taken by take_to() and is worth knowing: text that is read once is not, and a name
  /// that is deprecated must be told of; files of very many tokens are mostly data. Else without a file.
  Text replayed_text() const {
    if (!replays_ || pending_ || !deprecated_.empty()) return {};
    const Frame& frame = frames_.back();
    if (frame.file->size() > kMostReplayed) return {};
    return {frame.file, settled_ ? next_index_ : frame.position, frame.end};
  }
  /// Takes all before the token `end` at once, with `words` among it. Pre: there are no directives and macros in it.
  void take_to(std::uint32_t end, std::span<const Keyword> words) {
    Frame& frame = frames_.back();
    const std::uint64_t before = taken_;
    taken_ += end - (settled_ ? next_index_ : frame.position);
    frame.position = end;
    settled_ = false;
    last_ = frame.file->view(end - 1).location;
    for (const Keyword word : words) count(word);
    if (taken_ / kTokensBetweenLooks != before / kTokensBetweenLooks) look_around();
  }
  /// Whether so many levels of expressions more would not be too many.
  bool may_nest(std::size_t levels) const { return nesting_ + levels < kDeepestExpression; }
  /// Whether a directive or macro would be shown, not obeyed: see Hold.
  bool is_held() const { return hold_.held && blocks_.size() <= hold_.blocks; }
  /// Where the statement at top level begins that is being read.
  struct StatementStart {
    std::size_t frames = 0;
    std::uint32_t position = 0;
  };
  /// The next token begins a statement of the scene.
  void begin_statement();
  const StatementStart& statement() const { return statement_; }
  /// Forgets the braces that are open.
  void drop_blocks() { blocks_.clear(); }

  // --- names --------------------------------------------------------------------------------------------------------
  Scopes& scopes() { return scopes_; }
  const Scopes& scopes() const { return scopes_; }
  Symbols& symbols() { return symbols_; }
  const Symbols& symbols() const { return symbols_; }
  SourceFiles& files() { return files_; }
  const SourceFiles& files() const { return files_; }
  const render::LoadOptions& options() const { return options_; }
  /// Purposes of picking a part of an array or a dictionary: to read it, to write it, or to see whether it is there.
  enum class Pick { value, target, test };
  /// A name's `#declare deprecated`.
  struct Deprecation {
    std::string message;
    bool once = false;  ///< a warning at the first use is enough
  };
  /// From now on uses of that name are warned of.
  void deprecate(std::uint32_t symbol, Deprecation deprecation) { deprecated_[symbol] = std::move(deprecation); }

 protected:
  ~TokenStream() = default;

  /// Called now and then: whether to go on.
  virtual void look_around() = 0;
  /// At `#`: obey the directive. The frame's position is at the `#`.
  virtual void run_directive() = 0;
  /// At a macro's name, which has been passed.
  virtual void call_macro(const Token& name, std::shared_ptr<const Macro> macro) = 0;
  /// The slot of the part that the subscripts and keys behind `name` pick.
  virtual Scopes::Slot pick_part(const Scopes::Slot& container, const Token& name, Pick purpose) = 0;
  /// `.Key` or `["Key"]`.
  virtual std::string parse_key() = 0;

  void count(Keyword word) { ++keyword_counts_[static_cast<std::size_t>(word)]; }

 private:
  static constexpr std::uint64_t kTokensBetweenLooks = 1u << 12;
  static constexpr std::size_t kMostReplayed = 1u << 20;  // tokens of a file whose text is worth knowing

  [[noreturn]] void fail_nesting();
  [[noreturn]] void fail_block(const Token& owner);
  [[noreturn]] void fail_unclosed_block();
  [[noreturn]] void fail_expected(Punctuation mark, std::string_view purpose, std::string_view name);
  void warn_of_deprecated(const Token& name);
  void note_statement(std::uint32_t position) {
    if (nesting_ == 0 && blocks_.empty()) statement_ = {frames_.size(), position};
  }
  void settle();
  void settle_step_by_step();
  void show(const Token& token, std::uint32_t index) {
    if (frames_.back().file->all() != nullptr) return show_where_it_lies(token, index);
    shown_ = token;
    show_where_it_lies(shown_, index);
  }
  void show_where_it_lies(const Token& token, std::uint32_t index) {
    next_ = &token;
    next_index_ = index;
    next_value_ = nullptr;
    settled_ = true;
  }
  bool is_prefix() const;
  bool settle_name(const Token& name);
  bool settle_prefixed_name();
  bool settle_as(const Token& name, std::uint32_t index, const Scopes::Binding* binding, bool prefixed);

  const render::LoadOptions& options_;
  render::Diagnostics& diagnostics_;
  SourceFiles files_;
  Symbols symbols_;
  Scopes scopes_;
  std::vector<Frame> frames_;
  std::vector<Token> blocks_;  // owners of the open braces
  StatementStart statement_;
  // Names given as strings: file, the `[`, symbol.
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> named_by_strings_;
  std::map<std::uint32_t, Deprecation> deprecated_;  // by symbol
  bool replays_ = false;                             // there has been a turn of a loop or a call of a macro
  // The token that peek() gives. `pending_`: it is a `#` or a macro's name, shown because of a Hold.
  const Token* next_ = nullptr;
  Token shown_;  // it, unless it lies where it stays
  std::uint32_t next_index_ = 0;
  const Value* next_value_ = nullptr;
  Scopes::Slot next_element_;     // when it is a part of an array or a dictionary, or has a prefix
  std::uint32_t next_scope_ = 0;  // of that
  bool settled_ = false;
  bool pending_ = false;
  HoldState hold_;
  std::size_t nesting_ = 0;
  std::uint64_t taken_ = 0;
  Location last_;  // of the token that was taken last
  std::uint32_t described_undeclared_ = kNoSymbol;
  std::array<std::uint64_t, kKeywordCount> keyword_counts_{};
};

}  // namespace firstlight::parser
