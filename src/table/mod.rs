//! Tables as spreadsheets save them: bytes decoded, records read with their lines, cells written so that none is a formula.

mod cells;
mod decode;
mod records;

pub use cells::{append, harmless, meant, one_line, push_cell, visible, write};
pub use decode::{Undecoded, decode};
pub use records::{Record, delimiter, read};
