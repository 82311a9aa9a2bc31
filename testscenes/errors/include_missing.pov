// An included file that does not exist.
// expect error 4:10: no_such_file.inc
camera { location <0, 2, -6> look_at 0 }
#include "no_such_file.inc"
