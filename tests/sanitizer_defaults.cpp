// Findings that the sanitizers leave alone, built into every sanitized program so that it holds however the program is
// started. Installed libraries are not instrumented: ThreadSanitizer cannot see how they synchronise. Nothing of ours
// is listed.

extern "C" {
const char* __tsan_default_options();
const char* __tsan_default_suppressions();
const char* __lsan_default_suppressions();
const char* __ubsan_default_options();

const char* __tsan_default_options() { return "halt_on_error=1:second_deadlock_stack=1"; }

// race_top: the access itself lies in a oneTBB header. race: called back from a thread inside Embree or oneTBB.
const char* __tsan_default_suppressions() {
  return "race_top:oneapi/tbb/\n"
         "race:libembree3.so\n"
         "race:libtbb.so\n"
         "race:libOpenImageIO\n";
}

// Caches kept until the process ends.
const char* __lsan_default_suppressions() {
  return "leak:libOpenImageIO\n"
         "leak:libtbb.so\n"
         "leak:libembree3.so\n";
}

const char* __ubsan_default_options() { return "print_stacktrace=1"; }
}
