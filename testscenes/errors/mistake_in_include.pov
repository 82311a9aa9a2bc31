// A mistake in an included file.
// expect error mistake.inc:2:15: expected '}' to close 'sphere', found undeclared identifier 'pigmet'
camera { location <0, 2, -6> look_at 0 }
#include "parts/mistake.inc"
