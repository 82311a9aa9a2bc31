// Names have meanings in scopes, and prefixes choose one.
#include "tests/parser/evaluated.h"

namespace firstlight::parser {
namespace {

TEST(ScopePrefix, ChoosesTheScopeOfAName) {
  EXPECT_EQ(
      debugged("#declare A = 1; #macro M() #local A = 2; #debug str(A*100 + local.A*10 + global.A, 0, 0) #end M()"),
      "221");
  EXPECT_EQ(debugged("#declare A = 1; #debug str(global.A*10 + local.A, 0, 0)"), "11");
}
TEST(ScopePrefix, TellsAnOuterNameFromALocalOne) {
  EXPECT_EQ(debugged("#macro Inner() #debug str(A, 0, 0) #debug str(local.A, 0, 0) #end "
                     "#macro Outer() #local A = 2; Inner() #end Outer()"),
            "error: expected a numeric expression, found undeclared identifier 'A'");
  EXPECT_EQ(debugged("#macro Inner() #debug str(defined(A)*100 + defined(local.A)*10 + defined(global.A), 0, 0) #end "
                     "#macro Outer() #local A = 2; Inner() #end Outer()"),
            "100");
}
TEST(ScopePrefix, IsDeclaredInThatScope) {
  EXPECT_EQ(debugged("#macro M() #local A = 2; #declare global.A = 5; #declare local.B = 7; #debug str(A, 0, 0) #end "
                     "M() #debug str(A*10 + defined(B), 0, 0)"),
            "250");
  EXPECT_EQ(debugged("#macro M() #local global.A = 3; #end M() #debug str(A, 0, 0)"), "3");
}
TEST(ScopePrefix, ReachesArraysMacrosAndAnythingElse) {
  EXPECT_EQ(debugged("#declare A = array[2] { 3, 4 }; #macro F(X) X*2 #end #declare S = \"s\";\n"
                     "#macro M() #local A = 1; #local S = \"t\"; #declare global.A[0] = 9;\n"
                     "#debug str(global.A[0]*10 + global.F(global.A[1]), 0, 0) #debug concat(global.S, S) #end M()"),
            "98st");
}
TEST(ScopePrefix, HandsItsNameToAMacroByReference) {
  EXPECT_EQ(debugged("#declare A = 1; #macro Set(X) #declare X = 6; #end #macro M() #local A = 2; Set(global.A) "
                     "#debug str(A, 0, 0) #end M() #debug str(A, 0, 0)"),
            "26");
}
TEST(ScopePrefix, IsReadInLoopsAndConditions) {
  EXPECT_EQ(debugged("#declare A = 1; #macro M() #local A = 7; #while (global.A < 5) #declare global.A = global.A + 1; "
                     "#end #debug str(A*10 + global.A, 0, 0) #end M()"),
            "75");
  EXPECT_EQ(debugged("#declare A = 1; #ifdef (global.A) #debug \"is\" #end #ifndef (global.B) #debug \"not\" #end"),
            "isnot");
}
TEST(ScopePrefix, CanBeUndefined) {
  EXPECT_EQ(debugged("#declare A = 1; #macro M() #local A = 2; #undef global.A #debug str(A, 0, 0) #end M() "
                     "#debug str(defined(A), 0, 0)"),
            "20");
}
TEST(ScopePrefix, TakesTheNameAsAStringToo) {
  EXPECT_EQ(debugged("#declare A1 = 1; #macro M() #local A1 = 2; #debug str(global[\"A1\"]*10 + local[concat(\"A\", "
                     "str(1, 0, 0))], 0, 0) #end M()"),
            "12");
  EXPECT_EQ(debugged("#for (I, 1, 3) #declare global[concat(\"B\", str(I, 0, 0))] = I*I; #end "
                     "#debug str(B1 + B2*10 + B3*100, 0, 0)"),
            "941");
  EXPECT_EQ(debugged("#declare A = array[2] { 3, 4 }; #macro F(X) X*2 #end #declare N = \"A\"; "
                     "#debug str(global[N][1]*10 + global[\"F\"](3), 0, 0)"),
            "46");
  EXPECT_EQ(debugged("#declare A = 1; #macro Set(X) #declare X = 6; #end Set(global[\"A\"]) #debug str(A, 0, 0) "
                     "#debug str(defined(global[\"A\"])*10 + defined(local[\"B\"]), 0, 0) #undef global[\"A\"] "
                     "#ifndef (A) #debug \"gone\" #end"),
            "610gone");
  EXPECT_EQ(debugged("#declare B = 1 + local[\"Missing\"];"),
            "error: expected a numeric expression, found undeclared identifier 'Missing'");
  EXPECT_EQ(debugged("#declare B = global[5];"), "error: expected a string, found number 5");
}
TEST(ScopePrefix, NeedsAName) {
  EXPECT_EQ(debugged("#declare B = global.5;"), "error: expected a value, found 'global'");
  EXPECT_EQ(debugged("#declare B = global.sphere;"), "error: expected an identifier behind 'global.', found 'sphere'");
  EXPECT_EQ(debugged("#declare B = 1 + local.Missing;"),
            "error: expected a numeric expression, found undeclared identifier 'Missing'");
}

}  // namespace
}  // namespace firstlight::parser
