// An unknown word inside a shape.
// expect error 4:15: expected '}' to close 'sphere', found undeclared identifier 'pigmnt'
camera { location <0, 2, -6> look_at 0 }
sphere { 0, 1 pigmnt { rgb 1 } }
