// #declare of a reserved word.
// expect error 4:10: expected an identifier
camera { location <0, 2, -6> look_at 0 }
#declare sphere = 1;
