// A word that is neither of the language nor declared.
// expect error 4:1: found undeclared identifier 'spere'
camera { location <0, 2, -6> look_at 0 }
spere { 0, 1 }
