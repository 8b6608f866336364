//! The program: parse arguments, run, print the error, choose the exit code; nothing else.

fn main() {}
