// Functions of many points are those of one point, to the bit, at every width.
#include "render/function/internal.h"
#include "render/function/program.h"
#include "tests/render/dice.h"
#include "tests/render/each_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace firstlight::render {
namespace {

constexpr std::size_t kPoints = 150;
#ifdef FIRSTLIGHT_SANITIZED
constexpr int kPrograms = 15;
#else
constexpr int kPrograms = 60;
#endif
using Columns = std::vector<std::vector<double>>;

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

void expect_same_of_many(const Function& function, const Columns& arguments, const std::string& name) {
  for_each_target([&](const std::string& target) {
    for (const std::size_t count : {kPoints, std::size_t{64}, std::size_t{13}, std::size_t{1}}) {
      Columns found(function.result_count(), std::vector<double>(count));
      std::vector<const double*> from;
      std::vector<double*> to;
      for (const std::vector<double>& column : arguments) from.push_back(column.data());
      for (std::vector<double>& column : found) to.push_back(column.data());
      Evaluation evaluation;
      function.evaluate_many(from.data(), to.data(), count, evaluation);
      for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> point;
        for (const std::vector<double>& column : arguments) point.push_back(column[i]);
        std::vector<double> alone(function.result_count());
        function.evaluate(point.data(), alone.data(), evaluation);
        for (std::size_t r = 0; r < alone.size(); ++r) {
          ASSERT_TRUE(same(found[r][i], alone[r])) << name << ", " << target << ", point " << i << " of " << count
                                                   << ": " << found[r][i] << ", " << alone[r];
        }
      }
    }
  });
}

/// Numbers about 0, some of them whole.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : dice_(seed) {}
  unsigned die() { return static_cast<unsigned>(dice_.below(1 << 30)); }
  double moderate() {
    return die() % 4 == 0 ? static_cast<double>(die() % 9) - 4.0 : static_cast<double>(die() % 60001) / 10000.0 - 3.0;
  }
  /// The same, or now and then one that is special.
  double next() {
    constexpr double kSpecial[] = {0.0,
                                   -0.0,
                                   1.0,
                                   -1.0,
                                   0.5,
                                   2.0,
                                   -3.0,
                                   1e-9,
                                   1e9,
                                   std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::quiet_NaN()};
    return die() % 16 == 0 ? kSpecial[die() % std::size(kSpecial)] : moderate();
  }
  std::vector<double> column() {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < kPoints; ++i) numbers.push_back(next());
    return numbers;
  }

 private:
  Dice dice_;
};

TEST(Functions, BuiltInOnesGiveManyPointsWhatTheyGiveOne) {
  int count = 0;
  for (std::size_t number = 0; number < 100; ++number) {
    const FunctionPtr function = make_internal(number);
    if (function == nullptr) continue;
    ++count;
    Numbers numbers(static_cast<unsigned>(number));
    for (int set = 0; set < 6; ++set) {
      Columns arguments;
      for (std::size_t p = 0; p < function->parameter_count(); ++p) {
        // Parameters of its own are the same everywhere, or in one set are not.
        std::vector<double> column = numbers.column();
        if (p >= 3) std::generate(column.begin(), column.end(), [&] { return numbers.moderate(); });
        if (p >= 3 && set != 0) std::fill(column.begin(), column.end(), column.front());
        arguments.push_back(std::move(column));
      }
      expect_same_of_many(*function, arguments, "internal " + std::to_string(number));
    }
  }
  EXPECT_EQ(count, 78);
}

/// A function of two numbers with all results that there may be.
class Five final : public Function {
 public:
  Five() : Function(2, 5) {}
  void evaluate(const double* p, double* results, Evaluation&) const override {
    for (std::size_t r = 0; r < 5; ++r) results[r] = p[0] * static_cast<double>(r) - p[1];
  }
};

/// Instructions that leave one value, chosen at random.
std::shared_ptr<const Program> random_program(Numbers& numbers, const std::vector<FunctionPtr>& callees, int length,
                                              std::size_t parameters) {
  std::vector<Instruction> instructions;
  std::size_t height = 0;
  const auto push = [&] {
    ++height;
    const unsigned kind = numbers.die() % 3;
    if (kind == 0) {
      instructions.push_back({Operation::constant, 0, 0, static_cast<double>(numbers.die() % 40)});
    } else {
      instructions.push_back({Operation::parameter, 0, static_cast<std::uint16_t>(numbers.die() % parameters), 0.0});
    }
  };
  for (int i = 0; i < length || height != 1; ++i) {
    if (height == 0 || (i < length && height + 8 < Program::kDeepest && numbers.die() % 2 == 0)) {
      push();
      continue;
    }
    const auto index = static_cast<std::uint16_t>(numbers.die() % callees.size());
    const std::size_t taken = callees[index]->parameter_count();
    if (numbers.die() % 8 == 0 && taken <= height) {
      const auto most = callees[index]->result_count() == 5 ? kHeightComponent + 1u : 1u;
      instructions.push_back({Operation::call, static_cast<std::uint8_t>(numbers.die() % most), index, 0.0});
      height -= taken - 1;
      continue;
    }
    constexpr auto kFirst = static_cast<unsigned>(Operation::add_constant);
    constexpr auto kLast = static_cast<unsigned>(Operation::select);
    const auto operation = static_cast<Operation>(kFirst + numbers.die() % (kLast - kFirst + 1));
    const auto needed = static_cast<std::size_t>(operands(operation));
    if (needed > height || (i >= length && needed == 1)) continue;
    instructions.push_back({operation, 0, static_cast<std::uint16_t>(2 + numbers.die() % 7), numbers.next()});
    height -= needed - 1;
  }
  return std::make_shared<Program>(std::move(instructions), parameters, callees);
}

TEST(Functions, ProgramsGiveManyPointsWhatTheyGiveOne) {
  Numbers numbers(7);
  std::vector<FunctionPtr> callees{std::make_shared<Five>(), make_internal(76), make_internal(61), make_internal(57)};
  for (int i = 0; i < kPrograms; ++i) {
    const std::size_t parameters = 1 + numbers.die() % 4;
    const auto program = random_program(numbers, callees, i % 12 == 11 ? 900 : 40, parameters);
    ASSERT_TRUE(program->is_in_rows());
    Columns arguments;
    for (std::size_t p = 0; p < parameters; ++p) arguments.push_back(numbers.column());
    expect_same_of_many(*program, arguments, "program " + std::to_string(i));
    if (program->cost() < 1000 && callees.size() < 40) callees.push_back(program);
  }
}

TEST(Functions, AskForNoArgumentsThatTheyDoNotUse) {
  const Program program({{Operation::parameter, 0, 1, 0.0}, {Operation::square, 0, 0, 0.0}}, 3);
  for (const std::size_t count : {std::size_t{64}, std::size_t{13}}) {
    const std::vector<double> used(count, 3.0);
    std::vector<double> found(count);
    const std::array<std::span<const double>, 3> arguments{std::span<const double>(), used, {}};
    program.evaluate(arguments, found);
    EXPECT_EQ(found, std::vector<double>(count, 9.0));
  }
}

TEST(Functions, PutWhatIsWorkedOutTwiceIntoOneStep) {
  const auto inner = std::make_shared<Program>(
      std::vector<Instruction>{{Operation::parameter, 0, 0, 0.0}, {Operation::sine, 0, 0, 0.0}}, 1);
  std::vector<Instruction> instructions;
  for (int i = 0; i < 3; ++i) {
    instructions.push_back({Operation::parameter, 0, 1, 0.0});
    instructions.push_back({Operation::call, 0, 0, 0.0});
    if (i > 0) instructions.push_back({Operation::add, 0, 0, 0.0});
  }
  const std::vector<FunctionPtr> callees{inner};
  const RowProgram rows(instructions, 2, callees);
  EXPECT_EQ(rows.steps().size(), 3u);  // one sine, two sums
}

}  // namespace
}  // namespace firstlight::render
