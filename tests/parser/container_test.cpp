#include "tests/parser/evaluated.h"

namespace firstlight::parser {
namespace {

TEST(Array, WithoutSizesGrowsAsItIsWrittenTo) {
  EXPECT_EQ(debugged("#declare A = array[]; #declare A[2] = 5; #declare A[0] = 3;\n"
                     "#debug concat(str(dimension_size(A, 1), 0, 0), \" \", str(A[0] + A[2], 0, 0))"),
            "3 8");
  EXPECT_EQ(number("dimension_size(array { 1, 2, 3 }, 1)", 0), "error: expected an array, found 'array'");
  EXPECT_EQ(debugged("#declare A = array { 1, 2, 3, }; #debug str(dimension_size(A, 1), 0, 0)"), "3");
}

TEST(Array, WithoutSizesHasNoValueWhereNothingWasWritten) {
  EXPECT_EQ(debugged("#declare A = array[]; #declare A[2] = 5; #debug str(A[1], 0, 0)"),
            "error: this element of 'A' has no value yet");
  EXPECT_EQ(debugged("#declare A = array[]; #debug str(A[7], 0, 0)"), "error: this element of 'A' has no value yet");
  EXPECT_EQ(debugged("#declare A = array[]; #declare A[2] = 5; #debug str(defined(A[1]) * 10 + defined(A[2]), 0, 0)"),
            "1");
}

TEST(Array, ReferencesToElementsOutliveItsGrowth) {
  EXPECT_EQ(debugged("#macro Fill(Element) #for (I, 1, 5000) #declare A[I] = I; #end #declare Element = 7; #end\n"
                     "#declare A = array[]; #declare A[0] = 1; Fill(A[0])\n#debug str(A[0], 0, 0)"),
            "7");
}

TEST(Array, TakesValuesOfSeveralKindsOnlyWhenItIsMixed) {
  EXPECT_EQ(debugged("#declare A = array mixed[3] { 1, \"two\", <3, 4, 5> }; #debug concat(A[1], str(A[2].y, 0, 0))"),
            "two4");
  EXPECT_EQ(debugged("#declare A = array[2] { 1, \"two\" };"),
            "error: expected a value of the same kind as the array's other elements, found a string");
}

TEST(Array, ElementsMayBeLeftOutBehindOptional) {
  EXPECT_EQ(debugged("#declare A = array[3] optional { 1, , 3 };\n"
                     "#debug str(defined(A[0]) * 100 + defined(A[1]) * 10 + defined(A[2]), 0, 0)"),
            "101");
}

TEST(Array, ElementOfAnArrayOfArraysHasTheKindOfItsOwnArray) {
  EXPECT_EQ(
      debugged("#declare A = array[1]; #declare A[0] = array[2]; #declare A[0][1] = 4; #debug str(A[0][1], 0, 0)"),
      "4");
}

TEST(Array, NestedWithoutEndIsRefused) {
  EXPECT_EQ(debugged("#declare D = dictionary {}; #for (I, 1, 100) #declare D.A = D; #end"),
            "error: arrays and dictionaries are nested too deeply here (limit 20)");
}

TEST(Array, HasALargestSize) {
  EXPECT_EQ(debugged("#declare A = array[]; #declare A[99999999] = 1;"),
            "error: expected a subscript from 0 to 1.67772e+07 for 'A', found 1e+08");
}

TEST(Dictionary, EntriesAreFoundByWordAndByString) {
  const std::string start = "#declare D = dictionary { .Size: 3, [\"a key\"]: \"text\", .In: dictionary { .x: 4 } };\n";
  EXPECT_EQ(debugged(start + "#debug concat(str(D.Size, 0, 0), D[\"a key\"], str(D[\"In\"].x, 0, 0))"), "3text4");
  EXPECT_EQ(debugged(start + "#declare D.New = D.Size + 1; #debug str(D.New, 0, 0)"), "4");
  EXPECT_EQ(debugged(start + "#debug str(D.None, 0, 0)"), "error: 'D' has no entry 'None'");
}

TEST(Dictionary, TellsWhichEntriesItHas) {
  EXPECT_EQ(debugged("#declare D = dictionary { .A: 1 }; #undef D.A\n#declare D.B = 2;\n"
                     "#debug str(defined(D.A) * 10 + defined(D.B), 0, 0)"),
            "1");
}

TEST(Dictionary, IsCopiedWhenItIsDeclared) {
  EXPECT_EQ(debugged("#declare D = dictionary { .A: 1 }; #declare E = D; #declare E.A = 2; #debug str(D.A, 0, 0)"),
            "1");
}

TEST(Dictionary, ItsWordIsFreeForNames) {
  EXPECT_EQ(debugged("#declare dictionary = 3; #declare optional = 4; #declare mixed = 5;\n"
                     "#debug str(dictionary + optional + mixed, 0, 0)"),
            "12");
}

TEST(DeclareSeveral, TupleGivesEachNameItsValue) {
  EXPECT_EQ(debugged("#declare (A, B) = (1, \"two\"); #debug concat(str(A, 0, 0), B)"), "1two");
  EXPECT_EQ(debugged("#declare (A, , C) = (1, 2, 3); #debug str(A + C, 0, 0)"), "4");
  EXPECT_EQ(debugged("#declare (A, optional B) = (1, ); #debug str(defined(B), 0, 0)"), "0");
  EXPECT_EQ(debugged("#declare (A, B) = (1);"), "error: expected ',' between the values, found ')'");
}

TEST(DeclareSeveral, TupleMayComeFromAMacro) {
  EXPECT_EQ(debugged("#macro Two() (4, 5) #end #local (A, B) = Two(); #debug str(A * 10 + B, 0, 0)"), "45");
}

TEST(DeclareSeveral, VectorGivesItsComponents) {
  EXPECT_EQ(debugged("#declare <A, B, C> = <1, 2, 3> * 2; #debug str(A * 100 + B * 10 + C, 0, 0)"), "246");
}

TEST(DeclareSeveral, ArrayGivesItsElements) {
  EXPECT_EQ(debugged("#declare N = array[3] { \"a\", \"b\", \"c\" }; #declare {A, B} = N; #debug concat(A, B)"), "ab");
  EXPECT_EQ(debugged("#declare N = array[1] { 1 }; #declare {A, B} = N;"),
            "error: there are 2 names, but the array has 1 elements");
}

TEST(Macro, OptionalParametersMayBeLeftOut) {
  const std::string macro = "#macro M(A, optional B) #if (defined(B)) #debug concat(A, B) #else #debug A #end #end\n";
  EXPECT_EQ(debugged(macro + "M(\"a\", \"b\") M(\"c\", ) M(\"d\", Undeclared) M(\"e\")"), "abcde");
  EXPECT_EQ(debugged(macro + "M(, \"b\")"), "error: expected a value, found ','");
}

}  // namespace
}  // namespace firstlight::parser
