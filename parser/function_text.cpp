#include "parser/function_text.h"

#include "parser/expression/function_compiler.h"
#include "parser/text/syntax_error.h"
#include "parser/text/token_file.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace firstlight::parser {

namespace {

render::CompileResult failure(std::string message, std::size_t column, std::size_t length) {
  render::CompileResult result;
  result.error = std::move(message);
  result.at = column > 0 ? column - 1 : 0;
  result.length = std::max<std::size_t>(length, 1);
  return result;
}

}  // namespace

render::CompileResult compile_text(std::string_view text, std::span<const std::string_view> parameters) {
  SourceFile source;
  source.name = "expression";
  source.text = text;
  // One line, so that columns are places in the text.
  std::ranges::replace_if(
      source.text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  source.line_starts = {0};
  try {
    Symbols symbols;
    const TokenFile file(source, symbols);
    std::vector<Token> tokens;
    for (std::size_t i = 0; i < file.size(); ++i) tokens.push_back(file[i]);
    FunctionScope scope;
    scope.parameters = parameters;
    return {compile_function(tokens, scope), {}, 0, 1};
  } catch (const FunctionError& error) {
    return failure(error.message, error.at.column, error.at.length);
  } catch (const SyntaxError& error) {
    const render::Diagnostic& first = error.diagnostics.front();
    return failure(first.message, first.column, first.length);
  }
}

}  // namespace firstlight::parser
