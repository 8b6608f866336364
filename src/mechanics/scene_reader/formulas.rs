//! Formulas that were read last, remembered: all variants of a question have the same, with other numbers for their names.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use foldhash::fast::FixedState;

use crate::expr::{self, Angles, Expr, Fault};

/// How many are remembered at once. A stream of scenes of all kinds must not fill the memory.
const MOST: usize = 1 << 8;

/// Longer ones are read again.
const LONGEST: usize = 64;

type Read = HashMap<String, Rc<Expr>, FixedState>;

/// Reads a formula, or remembers what was read.
pub(super) fn read(text: &str, angles: Angles) -> Result<Rc<Expr>, Fault> {
    thread_local!(static READ: RefCell<[Read; 2]> = RefCell::default());
    READ.with_borrow_mut(|read| {
        let read = &mut read[angles as usize];
        if let Some(known) = read.get(text) {
            return Ok(known.clone());
        }
        let expr = Rc::new(expr::read(text, angles)?);
        if text.len() <= LONGEST {
            if read.len() >= MOST {
                read.clear();
            }
            read.insert(text.to_owned(), expr.clone());
        }
        Ok(expr)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_that_is_remembered_reads_as_it_did() {
        for text in ["2*u", "sin(30)", "180 - beta", "sin(30)", "2*u", "3 +"] {
            for angles in [Angles::Radians, Angles::Degrees] {
                let found = read(text, angles).map(|expr| (*expr).clone());
                assert_eq!(found, expr::read(text, angles), "{text} in {angles:?}");
            }
        }
    }
}
