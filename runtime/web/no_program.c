/* coif.wasm is all of the C interface and nothing else; a linker wants a source file all the same. */
typedef int coif_has_no_program;
