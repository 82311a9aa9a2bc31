#include "parser/expression/formula_program.h"

#include "parser/expression/arithmetic.h"
#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"
#include "parser/expression/words.h"

#include <algorithm>
#include <array>
#include <variant>

namespace firstlight::parser {

namespace {

constexpr std::size_t kMostComponents = 5;

render::Vec3 vector_at(const double* components, std::uint8_t size) {
  render::Vec3 vector(0.0);
  for (int i = 0; i < std::min<int>(size, 3); ++i) vector[i] = components[i];
  return vector;
}

/// The value of a word, which is known to be a T.
template <class T>
const T& as(const Word& word) {
  return *std::get_if<T>(&word.value);
}

}  // namespace

/// Goes through the steps of a formula as evaluation does, but with the sizes of the operands alone.
class FormulaSizer {
 public:
  using Operation = FormulaProgram::Operation;

  FormulaSizer(FormulaProgram& program, Formula::Shape shape, std::uint8_t terms)
      : program_(program), shape_(shape), terms_(terms) {}

  /// False at a size that does not fit.
  bool add(const Formula::Step& step) {
    using Of = Formula::Operation;
    switch (step.operation) {
      case Of::number:
        emit(Operation::number, step).number = step.number;
        return push(1, step);
      case Of::name:
        return name(step);
      case Of::unit:
        emit(Operation::unit, step, static_cast<std::uint8_t>(step.number)).index = step.index;
        return push(static_cast<std::uint8_t>(step.number), step);
      case Of::vector:
        operands_.resize(operands_.size() - step.index);
        operands_.push_back({step.index, false});
        return true;
      case Of::add:
      case Of::subtract:
      case Of::multiply:
      case Of::divide:
      case Of::truth:
        return of_two(step);
      case Of::negate:
      case Of::invert:
        emit(step.operation == Of::negate ? Operation::negate : Operation::invert, step, top().size);
        return true;
      case Of::component:
        return component(step);
      case Of::promote:
        widen(top(), wanted(step, operands_.size() - 1), step);
        return true;
      case Of::check_float:
        return top().size == 1;
      case Of::check_vector:
        return top().size <= 3;
      case Of::call_number:
        operands_.pop_back();
        emit(Operation::call_number, step);
        return push(1, step);
      case Of::call_two:
      case Of::fold:
        operands_.resize(operands_.size() - 2);
        emit(step.operation == Of::call_two ? Operation::call_two : Operation::fold, step);
        return push(1, step);
      case Of::fold_end:
        operands_.pop_back();
        emit(Operation::fold_end, step);
        return push(1, step);
      case Of::call_vectors:
        return call_vectors(step);
    }
    return false;
  }

  void finish() {
    program_.shape_ = shape_;
    program_.terms_ = terms_;
    program_.size_ = top().size;
    program_.is_color_ = top().is_color;
  }

 private:
  struct Operand {
    std::uint8_t size = 1;
    bool is_color = false;
  };

  Operand& top() { return operands_.back(); }
  FormulaProgram::Step& emit(Operation operation, const Formula::Step& from, std::uint8_t size = 1) {
    FormulaProgram::Step step;
    step.operation = operation;
    step.size = size;
    step.token = from.token;
    step.word = &word_of(from.token->keyword);
    return program_.steps_.emplace_back(step);
  }

  // By a place, below which there are `height` operands.
  std::uint8_t wanted(const Formula::Step& step, std::size_t height) const {
    return step.terms == Formula::kOfLeft     ? operands_[height - 1].size
           : step.terms == Formula::kOfCaller ? terms_
                                              : step.terms;
  }
  void widen(Operand& operand, std::uint8_t size, const Formula::Step& from) {
    if (size <= operand.size) return;
    emit(Operation::promote, from, size).left = operand.size;
    operand.size = size;
  }
  // An operand as its place wants it: see fitted().
  bool push(std::uint8_t size, const Formula::Step& step, bool is_color = false) {
    const std::uint8_t fit = wanted(step, operands_.size());
    operands_.push_back({size, is_color});
    if (size == 1 || (size == 3 && fit > 3)) widen(top(), fit, step);
    return true;
  }

  bool name(const Formula::Step& step) {
    const auto of_name = static_cast<std::uint8_t>(shape_ >> (Formula::kShapeBits * step.index));
    const std::uint8_t size = of_name & 7u;
    emit(size == 1 ? Operation::name : Operation::wide_name, step, size).index = step.index;
    return push(size, step, (of_name & Formula::kColorShape) != 0);
  }

  bool of_two(const Formula::Step& step) {
    using Of = Formula::Operation;
    const std::uint8_t right = top().size;
    operands_.pop_back();
    const std::uint8_t left = top().size;
    top() = {std::max(left, right), false};
    if (top().size > 1) {
      FormulaProgram::Step& wide = emit(Operation::combine, step, right);
      wide.left = left;
      wide.of_two = step.operation;
      return true;
    }
    emit(step.operation == Of::add        ? Operation::add
         : step.operation == Of::subtract ? Operation::subtract
         : step.operation == Of::multiply ? Operation::multiply
         : step.operation == Of::divide   ? Operation::divide
                                          : Operation::truth,
         step);
    return true;
  }

  bool component(const Formula::Step& step) {
    const std::size_t picked = picked_component(step.token->keyword);
    if (picked != kGray && picked >= top().size) return false;
    emit(Operation::component, step, top().size).index = static_cast<std::uint8_t>(picked);
    top() = {};
    return true;
  }

  bool call_vectors(const Formula::Step& step) {
    const Word& word = word_of(step.token->keyword);
    const auto& function = std::get<Word::OfVectors>(word.value);
    if (function.takes_degrees) operands_.pop_back();
    std::uint8_t second = 0;
    if (function.takes_second) {
      second = top().size;
      operands_.pop_back();
    }
    emit(Operation::call_vectors, step, second).left = top().size;
    operands_.pop_back();
    return push(word.kind == WordKind::number ? 1 : 3, step);
  }

  FormulaProgram& program_;
  std::vector<Operand> operands_;
  Formula::Shape shape_;
  std::uint8_t terms_;
};

std::unique_ptr<const FormulaProgram> FormulaProgram::make(std::span<const Formula::Step> steps, Formula::Shape shape,
                                                           std::uint8_t terms) {
  auto program = std::make_unique<FormulaProgram>();
  FormulaSizer sizer(*program, shape, terms);
  for (const Formula::Step& step : steps) {
    if (!sizer.add(step)) return nullptr;
  }
  sizer.finish();
  return program;
}

// In each component, of which the shorter operand gets as many as the other has.
void FormulaProgram::combine(Evaluator& in, const Step& step, double*& top) {
  using Of = Formula::Operation;
  std::array<double, kMostComponents> widened;
  const std::uint8_t size = std::max(step.left, step.size);
  const double* right = top - step.size;
  top -= step.size + step.left;
  const double* left = top;
  // Results are written over the left operand, which is read first unless it is the single number that all need.
  const double first = *left;
  const bool spread_left = step.left == 1, spread_right = step.size == 1;
  if (!spread_right && step.size != size) {
    std::fill(std::copy_n(right, step.size, widened.data()), widened.data() + size, 0.0);
    right = widened.data();
  } else if (!spread_left && step.left != size) {
    std::fill(std::copy_n(left, step.left, widened.data()), widened.data() + size, 0.0);
    left = widened.data();
  }
  const double second = *right;
  double* const result = top;
  const auto each = [&](auto operation) {
    if (spread_right) {
      for (std::uint8_t i = 0; i < size; ++i) result[i] = operation(left[i], second);
    } else if (spread_left) {
      for (std::uint8_t i = 0; i < size; ++i) result[i] = operation(first, right[i]);
    } else {
      for (std::uint8_t i = 0; i < size; ++i) result[i] = operation(left[i], right[i]);
    }
  };
  top += size;
  switch (step.of_two) {
    case Of::add:
      return each([](double a, double b) { return a + b; });
    case Of::subtract:
      return each([](double a, double b) { return a - b; });
    case Of::multiply:
      return each([](double a, double b) { return a * b; });
    case Of::divide:
      return each([&](double a, double b) { return parser::divide(in, *step.token, a, b); });
    default:
      return each([mark = step.token->punctuation](double a, double b) { return parser::truth(mark, a, b); });
  }
}

void FormulaProgram::call_vectors(Evaluator& in, const Step& step, double*& top) {
  const auto& function = as<Word::OfVectors>(*step.word);
  const double degrees = function.takes_degrees ? *--top : 0.0;
  top -= step.size;
  const render::Vec3 second = vector_at(top, step.size);
  top -= step.left;
  const render::Vec3 first = vector_at(top, step.left);
  const render::Vec3 result = function.value(in, *step.token, first, second, degrees);
  *top++ = result.x;
  if (step.word->kind == WordKind::number) return;
  *top++ = result.y;
  *top++ = result.z;
}

void FormulaProgram::run(Evaluator& in, const Numbers* const* values, Numbers& result) const {
  std::array<double, Formula::kDeepestStack * kMostComponents> stack;
  double* top = stack.data();  // behind the topmost number
  for (const Step& step : steps_) {
    switch (step.operation) {
      case Operation::number:
        *top++ = step.number;
        break;
      case Operation::name:
        *top++ = values[step.index]->values[0];
        break;
      case Operation::wide_name:
        top = std::copy_n(values[step.index]->values.data(), step.size, top);
        break;
      case Operation::unit:
        std::fill_n(top, step.size, 0.0);
        top[step.index] = 1.0;
        top += step.size;
        break;
      case Operation::promote:
        top = std::fill_n(top, step.size - step.left, step.left == 1 ? top[-1] : 0.0);
        break;
      case Operation::add:
        --top;
        top[-1] += top[0];
        break;
      case Operation::subtract:
        --top;
        top[-1] -= top[0];
        break;
      case Operation::multiply:
        --top;
        top[-1] *= top[0];
        break;
      case Operation::divide:
        --top;
        top[-1] = parser::divide(in, *step.token, top[-1], top[0]);
        break;
      case Operation::truth:
        --top;
        top[-1] = parser::truth(step.token->punctuation, top[-1], top[0]);
        break;
      case Operation::combine:
        combine(in, step, top);
        break;
      case Operation::negate:
        std::for_each(top - step.size, top, [](double& number) { number = negated(number); });
        break;
      case Operation::invert:
        std::for_each(top - step.size, top, [](double& number) { number = inverted(number); });
        break;
      case Operation::component: {
        top -= step.size;
        Numbers whole;
        whole.size = step.size;
        std::copy_n(top, step.size, whole.values.data());
        *top++ = pick_component(in, *step.token, whole);
        break;
      }
      case Operation::call_number:
        top[-1] = as<Word::OfOne>(*step.word)(in, *step.token, top[-1]);
        break;
      case Operation::call_two:
        --top;
        top[-1] = as<Word::OfTwo>(*step.word)(in, *step.token, top[-1], top[0]);
        break;
      case Operation::fold:
        --top;
        top[-1] = as<Word::Fold>(*step.word).join(top[-1], top[0]);
        break;
      case Operation::fold_end:
        top[-1] = parser::fold_end(as<Word::Fold>(*step.word), top[-1]);
        break;
      case Operation::call_vectors:
        call_vectors(in, step, top);
        break;
    }
  }
  result.values[0] = stack[0];
  if (size_ > 1) std::copy_n(&stack[1], size_ - 1, &result.values[1]);
  result.size = size_;
  result.is_color = is_color_;
}

}  // namespace firstlight::parser
