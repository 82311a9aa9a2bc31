// Scenes are untrusted input: nested without end, calling themselves, cut off. None may crash the program or hang it.

#include "tests/golden/refusal.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

namespace firstlight::golden {
namespace {

const std::string kCamera = "camera { location -5*z look_at 0 }\n";

std::string repeat(const std::string& text, int times) {
  std::string result;
  result.reserve(text.size() * static_cast<std::size_t>(times));
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

struct Hostile {
  const char* name;
  std::string text;
};

void PrintTo(const Hostile& scene, std::ostream* stream) { *stream << scene.name; }

std::string name_of(const testing::TestParamInfo<Hostile>& info) { return info.param.name; }

/// Wrong in any reading.
class HostileScene : public testing::TestWithParam<Hostile> {};

TEST_P(HostileScene, IsRefused) {
  const ScratchFolder scratch;
  const auto result = expect_refusal(scratch.write("hostile.pov", kCamera + GetParam().text), scratch);
  EXPECT_LT(result.err.size(), 100000U) << "messages without end";
}

constexpr int kDeep = 100000;

INSTANTIATE_TEST_SUITE_P(
    Deep, HostileScene,
    testing::Values(
        Hostile{"parentheses", "#declare A = " + repeat("(", kDeep)},
        Hostile{"vectors", "#declare A = " + repeat("<", kDeep)},
        Hostile{"minus_signs", "#declare A = " + repeat("-", kDeep)},
        Hostile{"not_signs", "#declare A = " + repeat("!", kDeep)},
        Hostile{"conditionals", "#declare A = " + repeat("1?", kDeep)},
        Hostile{"function_calls", "#declare A = " + repeat("sin(", kDeep)}, Hostile{"blocks", repeat("{", kDeep)},
        Hostile{"unions", repeat("union{", kDeep)}, Hostile{"differences", repeat("difference{", kDeep)},
        Hostile{"objects", repeat("object{", kDeep)}, Hostile{"textures", "sphere{0,1 " + repeat("texture{", kDeep)},
        Hostile{"pigment_maps", "sphere{0,1 pigment{" + repeat("gradient x pigment_map{[0 ", kDeep)},
        Hostile{"transforms", "sphere{0,1 " + repeat("transform{", kDeep)},
        Hostile{"bounds", repeat("sphere{0,1 bounded_by{", kDeep)},
        Hostile{"interior_textures", "sphere{0,1 " + repeat("interior_texture{", kDeep)},
        Hostile{"ifs", repeat("#if(1) ", kDeep)}, Hostile{"skipped_ifs", "#if(0) " + repeat("#if(1) ", kDeep)},
        Hostile{"whiles", repeat("#while(1) ", kDeep)}, Hostile{"switches", repeat("#switch(1) #case(1) ", kDeep)},
        Hostile{"macros", repeat("#macro A() ", kDeep)}, Hostile{"comments", repeat("/*", kDeep)},
        Hostile{"arrays", "#declare A = array" + repeat("[2]", kDeep)},
        Hostile{"array_values", "#declare A = array[2] " + repeat("{", kDeep)},
        Hostile{"declares", repeat("#declare A = ", kDeep)}, Hostile{"includes", repeat("#include ", kDeep)},
        Hostile{"strings", "#debug " + repeat("concat(", kDeep)}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Endless, HostileScene,
    testing::Values(Hostile{"macro_calls_itself", "#macro A() A() #end A()"},
                    Hostile{"macro_calls_itself_as_argument", "#macro A(B) A(A(B)) #end A(1)"},
                    Hostile{"macros_call_each_other", "#macro A() B() #end #macro B() A() #end A()"},
                    Hostile{"macro_nests_unions", "#macro A() union { A() } #end A()"},
                    Hostile{"file_includes_itself", "#include \"hostile.pov\""},
                    Hostile{"array_too_large", "#declare A = array[2000000000];"},
                    Hostile{"array_of_arrays_too_large", "#declare A = array[100000][100000];"},
                    Hostile{"array_of_negative_size", "#declare A = array[-1];"},
                    Hostile{"string_grows_without_end",
                            "#declare S = \"xxxxxxxxxxxxxxxx\"; #while (1) #declare S = concat(S, S); #end"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    CutOff, HostileScene,
    testing::Values(Hostile{"string", "#debug \"never closed"}, Hostile{"string_escape", "#debug \"\\"},
                    Hostile{"comment", "/* never closed"}, Hostile{"directive", "#"}, Hostile{"declare", "#declare"},
                    Hostile{"declare_name", "#declare A"}, Hostile{"declare_equals", "#declare A ="},
                    Hostile{"macro", "#macro"}, Hostile{"macro_parameters", "#macro A("},
                    Hostile{"macro_body", "#macro A() sphere { 0, 1 }"}, Hostile{"macro_call", "#macro A(B) #end A("},
                    Hostile{"loop", "#while (1)"}, Hostile{"for", "#for (I, 1,"},
                    Hostile{"if", "#if (1) sphere { 0, 1 }"}, Hostile{"switch", "#switch (1) #case (1)"},
                    Hostile{"number", "sphere { 0, 1e"}, Hostile{"vector", "sphere { <1, 2"},
                    Hostile{"colour", "background { rgb"}, Hostile{"block", "sphere {"},
                    Hostile{"map", "sphere { 0, 1 pigment { gradient x color_map { [0 rgb 1"},
                    Hostile{"include", "#include"}, Hostile{"end_alone", "#end"}, Hostile{"else_alone", "#else"},
                    Hostile{"case_alone", "#case (1)"}, Hostile{"break_alone", "#break"}),
    name_of);

/// Right, but deeper than anyone writes: to render it and to refuse it are both in order.
class DeepScene : public testing::TestWithParam<Hostile> {};

TEST_P(DeepScene, EndsWithoutASignal) {
  const ScratchFolder scratch;
  const auto scene = scratch.write("deep.pov", kCamera + GetParam().text);
  const auto result = render(program_under_test(), scene, scratch / "deep.png", scratch.path());
  EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1) << result.summary();
  EXPECT_EQ(result.exit_code == 0, std::filesystem::exists(scratch / "deep.png"));
  EXPECT_EQ(result.exit_code == 1, result.err.find("error: ") != std::string::npos) << result.err.substr(0, 3000);
}

std::string nested(const std::string& before, const std::string& middle, const std::string& after, int times) {
  return repeat(before, times) + middle + repeat(after, times);
}

INSTANTIATE_TEST_SUITE_P(
    Closed, DeepScene,
    testing::Values(
        Hostile{"parentheses", "#declare A = " + nested("(", "1", ")", kDeep) + ";"},
        Hostile{"unions", nested("union{ sphere{0,.1} ", "sphere{0,1}", "}", 20000)},
        Hostile{"differences", nested("difference{ ", "sphere{0,1}", " box{0,.1}}", 20000)},
        Hostile{"objects", nested("object{", "sphere{0,1}", "}", 20000)},
        Hostile{"pigment_maps",
                "sphere{0,1 pigment{" + nested("gradient x pigment_map{[0 ", "rgb 1", "][1 rgb 0]}", 20000) + "}}"},
        Hostile{"ifs", nested("#if(1) ", "sphere{0,1}", " #end ", 20000)},
        Hostile{"powers", "#declare A = " + repeat("2-", kDeep) + "1;"},
        Hostile{"macro_recursion", "#macro A(N) #if (N > 0) A(N - 1) #end #end A(20000)"},
        Hostile{"grown_union",
                "#declare A = sphere{0,1} #for(I,1,100000) #declare A = union{object{A} sphere{I,1}} #end object{A}"},
        Hostile{"grown_union_cut",
                "#declare A = sphere{0,1} #for(I,1,100000) #declare A = union{object{A} sphere{I,1}} #end "
                "difference{box{-2,1} object{A}}"},
        Hostile{"grown_lights",
                "#declare A = light_source{0,1} #for(I,1,100000) #declare A = light_source{0,1 looks_like{object{A}}} "
                "#end light_source{A}"},
        Hostile{"many_objects", repeat("sphere{0,1}\n", 50000)},
        Hostile{"long_name", "#declare " + std::string(1000000, 'a') + " = 1;"},
        Hostile{"long_line", std::string(5000000, ' ')},
        Hostile{"huge_numbers", "sphere{1e308,1e308} sphere{1e-308,1e-308} box{-1e300,1e300}"},
        Hostile{"not_numbers", "#declare N = 1e308*10; sphere{<N-N,0,N>,N} plane{<N,N,N>,N}"},
        Hostile{
            "nothing_wide",
            "sphere{0,0} box{0,0} cylinder{0,0,0} torus{0,0} plane{0,0} disc{0,0,0} triangle{0,0,0} cone{0,0,0,0}"}),
    name_of);

}  // namespace
}  // namespace firstlight::golden
