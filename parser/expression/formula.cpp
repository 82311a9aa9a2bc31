// Evaluation of formulas: by programs, and step by step where none can be made.
#include "parser/expression/formula.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/arithmetic.h"
#include "parser/expression/expression.h"
#include "parser/expression/formula_program.h"
#include "parser/expression/function_values.h"

#include <algorithm>
#include <utility>

namespace firstlight::parser {

namespace {

using Operation = Formula::Operation;
using Step = Formula::Step;

render::Vec3 as_vector(const Numbers& numbers) { return {numbers.values[0], numbers.values[1], numbers.values[2]}; }

/// Operands of any size.
class Stack {
 public:
  explicit Stack(std::uint8_t terms) : terms_(terms) {}

  Numbers& top() { return slots_[height_ - 1]; }
  Numbers pop() { return slots_[--height_]; }
  void push(double value, const Step& step) {
    const std::uint8_t terms = wanted(step, height_);
    slots_[height_++] = single(value, terms);
  }
  void push_name(const Numbers& value, const Step& step) {
    const std::uint8_t terms = wanted(step, height_);
    slots_[height_++] = fitted(value, terms);
  }
  void promote_top(const Step& step) { promote(top(), wanted(step, height_ - 1)); }
  void check(Interpreter& in, const Step& step) {
    const bool number = step.operation == Operation::check_float;
    if (top().size > (number ? 1 : 3)) fail_components(in, *step.token, number ? "float" : "vector", top());
  }
  void push_vector(const Numbers& value) { slots_[height_++] = value; }

 private:
  // By a place, below which `height` operands are on the stack.
  std::uint8_t wanted(const Step& step, std::size_t height) const {
    return step.terms == Formula::kOfLeft     ? slots_[height - 1].size
           : step.terms == Formula::kOfCaller ? terms_
                                              : step.terms;
  }

  std::array<Numbers, Formula::kDeepestStack> slots_;
  std::size_t height_ = 0;
  std::uint8_t terms_;
};

double first_of(const Numbers& numbers) { return numbers.values[0]; }

// The rarer steps.
void run_step(Interpreter& in, const Step& step, Stack& stack) {
  switch (step.operation) {
    case Operation::unit:
      return stack.push_name(unit(step.index, static_cast<std::uint8_t>(step.number)), step);
    case Operation::vector: {
      Numbers vector;
      vector.size = step.index;
      for (std::size_t i = step.index; i-- > 0;) vector.values[i] = stack.pop().values[0];
      return stack.push_vector(vector);
    }
    case Operation::component:
      stack.top() = single(pick_component(in, *step.token, stack.top()), 1);
      return;
    default: {  // call_vectors
      const Keyword word = step.token->keyword;
      const double degrees = word == Keyword::vaxis_rotate ? stack.pop().values[0] : 0.0;
      const render::Vec3 second = takes_second_vector(word) ? as_vector(stack.pop()) : render::Vec3(0.0);
      const render::Vec3 first = as_vector(stack.pop());
      if (word == Keyword::vdot || word == Keyword::vlength) {
        return stack.push(number_of_vectors(word, first, second), step);
      }
      const render::Vec3 vector = vector_of_vectors(in, *step.token, first, second, degrees);
      Numbers result;
      result.values = {vector.x, vector.y, vector.z, 0.0, 0.0};
      result.size = 3;
      return stack.push_name(result, step);
    }
  }
}

void run(Interpreter& in, std::span<const Step> steps, const Numbers* const* values, Stack& stack) {
  const auto operate = [&](auto operation) {
    const Numbers right = stack.pop();
    stack.top() = combine(stack.top(), right, operation);
  };
  for (const Step& step : steps) {
    switch (step.operation) {
      case Operation::number:
        stack.push(step.number, step);
        break;
      case Operation::name:
        stack.push_name(*values[step.index], step);
        break;
      case Operation::add:
        operate([](double a, double b) { return a + b; });
        break;
      case Operation::subtract:
        operate([](double a, double b) { return a - b; });
        break;
      case Operation::multiply:
        operate([](double a, double b) { return a * b; });
        break;
      case Operation::divide:
        operate([&](double a, double b) { return divide(in, *step.token, a, b); });
        break;
      case Operation::truth:
        operate([mark = step.token->punctuation](double a, double b) { return truth(mark, a, b); });
        break;
      case Operation::negate:
        change(stack.top(), negated);
        break;
      case Operation::invert:
        change(stack.top(), inverted);
        break;
      case Operation::promote:
        stack.promote_top(step);
        break;
      case Operation::check_float:
      case Operation::check_vector:
        stack.check(in, step);
        break;
      case Operation::call_number: {
        const double argument = first_of(stack.pop());
        stack.push(value_of_number(in, *step.token, argument), step);
        break;
      }
      case Operation::call_two: {
        const double second = first_of(stack.pop());
        const double first = first_of(stack.pop());
        stack.push(value_of_two(in, *step.token, first, second), step);
        break;
      }
      case Operation::fold: {
        const double next = first_of(stack.pop());
        const double so_far = first_of(stack.pop());
        stack.push(fold(step.token->keyword, so_far, next), step);
        break;
      }
      case Operation::fold_end: {
        const double so_far = first_of(stack.pop());
        stack.push(fold_end(step.token->keyword, so_far), step);
        break;
      }
      default:
        run_step(in, step, stack);
        break;
    }
  }
}

}  // namespace

Formula::Formula() = default;
Formula::~Formula() = default;

void Formula::evaluate(Interpreter& in, const Values& values, std::uint8_t terms, Numbers& result) const {
  if (latest_ != nullptr && latest_->serves(values.shape, terms)) {
    return latest_->run(in, values.of_names.data(), result);
  }
  evaluate_anew(in, values, terms, result);
}

void Formula::evaluate_anew(Interpreter& in, const Values& values, std::uint8_t terms, Numbers& result) const {
  const auto known = std::find_if(programs_.begin(), programs_.end(),
                                  [&](const auto& program) { return program->serves(values.shape, terms); });
  if (known != programs_.end()) {
    latest_ = known->get();
  } else {
    auto program = programs_.size() < kMostPrograms ? FormulaProgram::make(steps_, values.shape, terms) : nullptr;
    if (program == nullptr) {
      Stack stack(terms);
      run(in, steps_, values.of_names.data(), stack);
      result = stack.top();
      return;
    }
    latest_ = program.get();
    programs_.push_back(std::move(program));
  }
  latest_->run(in, values.of_names.data(), result);
}

const Formula* FormulaTable::meet(const std::vector<Token>& tokens, std::uint32_t begin, Formula::Kind kind) {
  std::uint32_t& entry = entries_[begin][static_cast<std::size_t>(kind)];
  if (entry == kNew) {
    entry = kMet;
    return nullptr;
  }
  std::unique_ptr<const Formula> formula = Formula::compile(tokens, begin, kind);
  if (formula == nullptr) {
    entry = kNone;
    return nullptr;
  }
  formulas_.push_back(std::move(formula));
  entry = kFirst + static_cast<std::uint32_t>(formulas_.size() - 1);
  return formulas_.back().get();
}

}  // namespace firstlight::parser
